#include "mortise/coupler/acoustic_line.hpp"

#include <cmath>
#include <string>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

Wave operator+(const Wave& x, const Wave& y) { return {x[0] + y[0], x[1] + y[1]}; }
Wave operator-(const Wave& x, const Wave& y) { return {x[0] - y[0], x[1] - y[1]}; }
Wave operator*(double k, const Wave& x) { return {k * x[0], k * x[1]}; }

/// The flux of a state, which is what a face with this state gives.
Wave flux(const Wave& w) { return {w[1], w[0]}; }

/// The state between two others: what the wave to the right carries from the left, and the other way round.
Wave riemann(const Wave& left, const Wave& right) {
  const Wave mean = 0.5 * (left + right);
  return mean + 0.5 * flux(left - right);
}

/// w₋₁ that makes the slope in w₀ that of the parabola through w₀, w₁, w₂.
Wave continued(const Wave& w0, const Wave& w1, const Wave& w2) { return 3.0 * w0 - 3.0 * w1 + w2; }

void check(bool good, const char* what, double value) {
  if (!good) throw InputError(std::string("a side of an interface needs ") + what + ", not " + std::to_string(value));
}

}  // namespace

AcousticLine::AcousticLine(const AcousticSide& side, int order)
    : side_(side), order_(order), root_(std::sqrt(side.impedance)) {
  check(side.impedance > 0 && std::isfinite(side.impedance), "an impedance > 0", side.impedance);
  check(side.speed > 0 && std::isfinite(side.speed), "a speed > 0", side.speed);
  check(side.spacing > 0 && std::isfinite(side.spacing), "a spacing > 0", side.spacing);
  check(side.cells >= 3, "three cells at least", side.cells);
  check(order == 1 || order == 2, "order 1 or 2", order);
  cells_.resize(static_cast<std::size_t>(side.cells), Wave{});
}

/// One ghost at the interface, then the cells, then two ghosts.
std::vector<Wave> AcousticLine::with_ghosts() const {
  std::vector<Wave> w = {continued(cells_[0], cells_[1], cells_[2])};
  w.insert(w.end(), cells_.begin(), cells_.end());
  const Wave last = w[w.size() - 1], inner = w[w.size() - 2], far = w[w.size() - 3];
  switch (side_.end) {
    case FarEnd::open:
      w.insert(w.end(), {last, last});
      break;
    case FarEnd::rest:
      w.insert(w.end(), {Wave{}, Wave{}});
      break;
    case FarEnd::wall:
      w.insert(w.end(), {Wave{-last[0], last[1]}, Wave{-inner[0], inner[1]}});
      break;
    case FarEnd::fixed:
    case FarEnd::free: {
      const Wave first = continued(last, inner, far);
      w.insert(w.end(), {first, continued(first, last, inner)});
      break;
    }
  }
  return w;
}

Wave AcousticLine::slope(const std::vector<Wave>& w, std::size_t cell) const {
  return order_ == 1 ? Wave{} : 0.5 * (w[cell + 1] - w[cell - 1]);
}

AcousticLine::Trace AcousticLine::trace(double dt) const {
  const std::vector<Wave> w = with_ghosts();
  const Wave delta = slope(w, 1), now = w[1] - 0.5 * delta;
  const Wave half = now - 0.5 * side_.speed * dt / side_.spacing * flux(delta);
  return {now[0] / root_, now[1] * root_, half[0] / root_, half[1] * root_};
}

void AcousticLine::step(double velocity, double stress, double dt) {
  const double courant = side_.speed * dt / side_.spacing;
  const std::vector<Wave> w = with_ghosts();
  const std::size_t n = cells_.size();
  std::vector<Wave> state = {Wave{velocity * root_, stress / root_}};  // at the faces
  Wave left{};                                                         // of the next face
  for (std::size_t i = 1; i <= n + 1; ++i) {
    const Wave delta = slope(w, i), half = w[i] - 0.5 * courant * flux(delta);
    if (i > 1) state.push_back(riemann(left, half - 0.5 * delta));
    left = half + 0.5 * delta;
    if (i < n || side_.end == FarEnd::open || side_.end == FarEnd::rest) continue;
    const double outgoing = left[0] + left[1];
    state.push_back(side_.end == FarEnd::free ? Wave{outgoing, 0} : Wave{0, outgoing});
    break;
  }
  for (std::size_t i = 0; i < n; ++i) cells_[i] = cells_[i] - courant * flux(state[i + 1] - state[i]);
}

}  // namespace mortise
