// A free neo-Hookean ring ½ ≤ R ≤ 1 that turns about its middle in equilibrium: what it loses in a turn.
#include "verification/elastic_run.hpp"

namespace mortise {
namespace {

using namespace testing;

/// The ring turning at rate ω: x = Q(ωt) r(R) e_R, F = Q (r' e_R ⊗ e_R + r/R e_Θ ⊗ e_Θ) with principal stretches
/// a = r', b = r/R and stresses p(a, b) = μ (a − 1/a) + λ ln(ab)/a along R, p(b, a) along Θ;
///   d p(a, b)/dR + (p(a, b) − p(b, a))/R + ρ ω² r = 0,   p(a, b) = 0 at both circles.
class TurningRing {
 public:
  TurningRing(const Material& material, double omega) : material_(material), omega_(omega) {
    // by the secant method for the inner radius
    double before = inner, now = inner * 1.01, left = integrate(before);
    for (int n = 0; n < 30 && std::abs(now - before) > 1e-15; ++n) {
      const double here = integrate(now), next = now - here * (now - before) / (here - left);
      left = here, before = now, now = next;
    }
    integrate(now);
  }

  ElasticState operator()(const Point<2>& X, double t) const {
    const double R = X.norm(), where = (R - inner) / step(), k = std::clamp(std::floor(where), 0.0, intervals - 1.0);
    const auto [r, a] = interpolated(static_cast<std::size_t>(k), where - k);
    const Point<2> n = X / R, m(-n.y(), n.x());
    Gradient turn;
    turn << std::cos(omega_ * t), -std::sin(omega_ * t), std::sin(omega_ * t), std::cos(omega_ * t);
    const Point<2> x = turn * (r * n);
    const Gradient F = turn * (a * n * n.transpose() + r / R * m * m.transpose());
    return elastic_state(material_, omega_ * Point<2>(-x.y(), x.x()), F - Gradient::Identity(), x - X);
  }

 private:
  static constexpr double inner = 0.5;
  static constexpr int intervals = 2000;
  static constexpr double step() { return (1 - inner) / intervals; }
  struct Node {
    double r, a;
  };

  double stress(double a, double b) const {
    return material_.mu * (a - 1 / a) + material_.lambda * std::log(a * b) / a;
  }
  /// (r', a') at R.
  Node rates(double R, const Node& at) const {
    const double a = at.a, b = at.r / R, b_rate = (a - b) / R;
    const double by_a = material_.mu * (1 + 1 / (a * a)) + material_.lambda * (1 - std::log(a * b)) / (a * a);
    const double by_b = material_.lambda / (a * b);
    const double rate = -(stress(a, b) - stress(b, a)) / R - material_.density * omega_ * omega_ * at.r;
    return {a, (rate - by_b * b_rate) / by_a};
  }
  /// The stretch along R without stress along R, by Newton's method.
  double free_stretch(double b) const {
    double a = 1;
    for (int n = 0; n < 20; ++n) {
      const double slope = material_.mu * (1 + 1 / (a * a)) + material_.lambda * (1 - std::log(a * b)) / (a * a);
      a -= stress(a, b) / slope;
    }
    return a;
  }
  /// Outward from a radius of the inner circle, of fourth order; the stress left at the outer one.
  double integrate(double radius) {
    nodes_.assign(1, {radius, free_stretch(radius / inner)});
    const double h = step();
    for (int k = 0; k < intervals; ++k) {
      const double R = inner + k * h;
      const Node s = nodes_.back();
      const auto moved = [&](const Node& by, double w) { return Node{s.r + w * by.r, s.a + w * by.a}; };
      const Node k1 = rates(R, s), k2 = rates(R + 0.5 * h, moved(k1, 0.5 * h)),
                 k3 = rates(R + 0.5 * h, moved(k2, 0.5 * h)), k4 = rates(R + h, moved(k3, h));
      nodes_.push_back(
          {s.r + h / 6 * (k1.r + 2 * (k2.r + k3.r) + k4.r), s.a + h / 6 * (k1.a + 2 * (k2.a + k3.a) + k4.a)});
    }
    return stress(nodes_.back().a, nodes_.back().r);
  }
  Node interpolated(std::size_t k, double s) const {
    return {(1 - s) * nodes_[k].r + s * nodes_[k + 1].r, (1 - s) * nodes_[k].a + s * nodes_[k + 1].a};
  }

  Material material_;
  double omega_;
  std::vector<Node> nodes_;
};

/// After a turn, relative: angular momentum lost, and the largest change of the equivalent stress anywhere at any time.
struct Losses {
  double angular_momentum = 0, stress = 0;
};

double angular_momentum(const ElasticRun& run) {
  double sum = 0;
  run.for_each_active_cell([&](int g, int t, const Index<2>& cell, const Point<2>& X, const ElasticState& a) {
    sum += run.solver().cell_volume(g, t, cell) * cross(X + Point<2>(a[6], a[7]), velocity_of(a));
  });
  return sum;
}

std::vector<double> equivalent_stresses(const ElasticRun& run, const Material& material) {
  std::vector<double> stresses;
  run.for_each_active_cell([&](int, int, const Index<2>&, const Point<2>&, const ElasticState& a) {
    stresses.push_back(cauchy_stress_of(material, a).von_mises());
  });
  return stresses;
}

Losses losses_in_a_turn(int across) {
  const double omega = 0.4;
  const Material material = unit_speed(StressLaw::neo_hookean);
  ElasticSetup setup;
  setup.name = "ring";
  setup.options.material = material;
  setup.fitted = ring(0.5, 8 * across, across);
  ElasticRun run(setup, TurningRing(material, omega));
  const double momentum = angular_momentum(run);
  const std::vector<double> before = equivalent_stresses(run, material);
  Losses losses;
  for (int n = 1; n <= 40; ++n) {
    run.advance_to(n / 40.0 * 2 * pi / omega);
    const std::vector<double> now = equivalent_stresses(run, material);
    for (std::size_t k = 0; k < now.size(); ++k) losses.stress = std::max(losses.stress, std::abs(now[k] - before[k]));
  }
  losses.stress /= *std::max_element(before.begin(), before.end());
  losses.angular_momentum = 1 - angular_momentum(run) / momentum;
  return losses;
}

TEST(RotatingRing, LosesAngularMomentumAtThirdOrderAndKeepsItsStress) {
  const Losses coarse = losses_in_a_turn(14), middle = losses_in_a_turn(20), fine = losses_in_a_turn(28);
  EXPECT_LT(std::abs(middle.angular_momentum), 1.5e-3);
  expect_order(std::abs(coarse.angular_momentum), std::abs(fine.angular_momentum), 3);
  EXPECT_LT(middle.stress, 0.003);
  expect_order(coarse.stress, fine.stress, 1.9);
}

}  // namespace
}  // namespace mortise
