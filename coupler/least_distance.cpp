#include "mortise/coupler/least_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace mortise {
namespace {

using Vector = std::vector<double>;

constexpr double round_off = 1e-12;  // relative: smaller parts of a column count as zero
constexpr double infinity = std::numeric_limits<double>::infinity();

double dot(const Vector& a, const Vector& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }
double norm(const Vector& a) { return std::sqrt(dot(a, a)); }
void add(Vector& a, double factor, const Vector& b) {  // a += factor b
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
}

/// Orthogonal factors of the active columns, G = Q R, by Gram-Schmidt with reorthogonalisation.
class Factors {
 public:
  Factors(const std::vector<Vector>& columns, const std::vector<int>& active) {
    for (const int j : active) {
      Vector q = columns[static_cast<std::size_t>(j)];
      Vector r = split(q);
      r.push_back(norm(q));
      for (double& value : q) value /= r.back();
      Q_.push_back(std::move(q));
      R_.push_back(std::move(r));
    }
  }

  /// Leaves in v its part orthogonal to Q and returns Qᵀ v.
  Vector split(Vector& v) const {
    Vector inside(Q_.size(), 0.0);
    for (int pass = 0; pass < 2; ++pass)
      for (std::size_t k = 0; k < Q_.size(); ++k) {
        const double part = dot(Q_[k], v);
        inside[k] += part;
        add(v, -part, Q_[k]);
      }
    return inside;
  }

  /// R⁻¹ b.
  Vector solve(Vector b) const {
    for (std::size_t k = b.size(); k-- > 0;) {
      b[k] /= R_[k][k];
      for (std::size_t i = 0; i < k; ++i) b[i] -= R_[k][i] * b[k];
    }
    return b;
  }

 private:
  std::vector<Vector> Q_, R_;  // by columns
};

class ActiveSet {
 public:
  ActiveSet(std::size_t rows, const std::vector<Vector>& columns, const Vector& h, double tolerance)
      : columns_(columns), h_(h), tolerance_(tolerance), given_up_(h.size(), false), x_(rows, 0.0) {}

  LeastDistance solve() {
    LeastDistance answer;
    const std::size_t limit = 20 * (h_.size() + 5);  // far beyond need; a guard against cycling by round-off
    for (std::size_t pivot = 0; pivot < limit; ++pivot) {
      const int j = most_violated();
      if (j < 0) break;
      if (add_constraint(j)) continue;
      given_up_[static_cast<std::size_t>(j)] = true;
      answer.violated.push_back(j);
    }
    std::ranges::sort(answer.violated);
    answer.x = x_;
    answer.multipliers.assign(h_.size(), 0.0);
    for (std::size_t k = 0; k < active_.size(); ++k)
      answer.multipliers[static_cast<std::size_t>(active_[k])] = multipliers_[k];
    return answer;
  }

 private:
  const Vector& column(int j) const { return columns_[static_cast<std::size_t>(j)]; }
  double violation(int j) const { return h_[static_cast<std::size_t>(j)] - dot(column(j), x_); }

  /// The most violated constraint that is neither active nor given up; −1: none is violated beyond round-off.
  int most_violated() const {
    constexpr double epsilon = 16 * std::numeric_limits<double>::epsilon();
    double largest = 0;
    for (const double value : h_) largest = std::max(largest, std::abs(value));
    int worst = -1;
    double worst_violation = 0;
    for (int j = 0; j < static_cast<int>(h_.size()); ++j) {
      if (given_up_[static_cast<std::size_t>(j)] || std::ranges::count(active_, j)) continue;
      const double here = violation(j);
      const double negligible = std::max(tolerance_, epsilon * (largest + norm(column(j)) * norm(x_)));
      if (!(here > negligible) || here <= worst_violation) continue;  // not a number: nothing to be done about it
      worst = j;
      worst_violation = here;
    }
    return worst;
  }

  /// Makes constraint j hold, dropping active ones on the way. False, and no change, if it contradicts the others.
  bool add_constraint(int j) {
    const ActiveSet before = *this;
    double multiplier = 0;
    while (true) {
      const Factors factors(columns_, active_);
      Vector direction = column(j);
      const Vector exchange = factors.solve(factors.split(direction));
      const auto [drop, drop_step] = first_to_drop(exchange, j);
      const bool independent = norm(direction) > round_off * norm(column(j));
      const double full_step = independent ? std::max(0.0, violation(j)) / dot(direction, direction) : infinity;
      const double step = std::min(drop_step, full_step);
      if (step == infinity) {
        active_ = before.active_;
        multipliers_ = before.multipliers_;
        x_ = before.x_;
        return false;
      }
      for (std::size_t k = 0; k < active_.size(); ++k)
        multipliers_[k] = std::max(0.0, multipliers_[k] - step * exchange[k]);
      multiplier += step;
      if (independent) add(x_, step, direction);
      if (full_step <= drop_step) break;
      active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(drop));
      multipliers_.erase(multipliers_.begin() + static_cast<std::ptrdiff_t>(drop));
    }
    active_.push_back(j);
    multipliers_.push_back(multiplier);
    return true;
  }

  /// Which multiplier reaches zero first when constraint j comes in, and after what step; infinity: none does.
  std::pair<std::size_t, double> first_to_drop(const Vector& exchange, int j) const {
    std::pair<std::size_t, double> first{0, infinity};
    for (std::size_t k = 0; k < exchange.size(); ++k) {
      if (exchange[k] * norm(column(active_[k])) <= round_off * norm(column(j))) continue;
      const double step = multipliers_[k] / exchange[k];
      if (step < first.second) first = {k, step};
    }
    return first;
  }

  const std::vector<Vector>& columns_;
  const Vector& h_;
  double tolerance_;
  std::vector<bool> given_up_;
  std::vector<int> active_;
  Vector multipliers_;  // of the active constraints
  Vector x_;
};

}  // namespace

LeastDistance least_distance(std::size_t rows, const std::vector<std::vector<double>>& columns,
                             const std::vector<double>& h, double tolerance) {
  return ActiveSet(rows, columns, h, tolerance).solve();
}

}  // namespace mortise
