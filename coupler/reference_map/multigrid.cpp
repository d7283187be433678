#include "mortise/coupler/reference_map/multigrid.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mortise/coupler/reference_map/multigrid_level.hpp"
#include "mortise/grids/core/simd.hpp"

namespace mortise {
namespace {

constexpr int fewest_cells = 4;  // along a side: no coarser grids

double largest_magnitude(const double* values, int count) {
  Pack most{};
  int k = 0;
  for (; k + simd_width <= count; k += simd_width) most = larger_magnitude(most, load(values + k));
  double largest = horizontal_max(most);
  for (; k < count; ++k) largest = std::max(largest, std::abs(values[k]));
  return largest;
}

class Multigrid : public Preconditioner {
 public:
  explicit Multigrid(const PressureProblem& problem) : problem_(problem) {
    Index<2> cells = problem.grid->cells;
    const double aspect = problem.grid->spacing[1] / problem.grid->spacing[0];
    levels_.emplace_back(problem.place, problem.ends, cells, aspect);
    while (cells[0] % 2 == 0 && cells[1] % 2 == 0 && std::min(cells[0], cells[1]) >= 2 * fewest_cells) {
      cells = {cells[0] / 2, cells[1] / 2};
      levels_.emplace_back(problem.place, problem.ends, cells, aspect);
    }
    coarsest_steps_ =
        static_cast<int>(std::ceil(1.5 * std::sqrt(levels_.back().all().high / levels_.back().all().low)));
  }

  void set(const VariableOperator& matrix) override {
    levels_.front().set_finest(matrix);
    for (std::size_t l = 1; l < levels_.size(); ++l) levels_[l].average(levels_[l - 1]);
  }

  void apply(const double* r, double* z) override {
    MultigridLevel& finest = levels_.front();
    const Index<2> n = finest.points();
    const double largest = largest_magnitude(r, n[0] * n[1]), scale = largest > 0 ? 1 / largest : 1;
    for (int j = 0; j < n[1]; ++j) {
      float* const to = finest.b.data() + finest.at(0, j);
      const double* const from = r + static_cast<std::ptrdiff_t>(j) * n[0];
      for (int i = 0; i < n[0]; ++i) to[i] = static_cast<float>(scale * from[i]);
    }
    cycle();
    for (int j = 0; j < n[1]; ++j) {
      const float* const from = finest.x.data() + finest.at(0, j);
      double* const to = z + static_cast<std::ptrdiff_t>(j) * n[0];
      for (int i = 0; i < n[0]; ++i) to[i] = largest * static_cast<double>(from[i]);
    }
  }

  double bound() const override { return 1.3; }
  double contraction() const override { return 0.25; }

 private:
  void cycle() {
    const std::size_t last = levels_.size() - 1;
    for (std::size_t l = 0; l < last; ++l) {
      levels_[l].smooth(true, steps, levels_[l].rough());
      levels_[l + 1].restrict_from(levels_[l]);
    }
    levels_[last].smooth(true, coarsest_steps_, levels_[last].all());
    for (std::size_t l = last; l-- > 0;) {
      levels_[l].correct_from(levels_[l + 1]);
      levels_[l].smooth(false, steps, levels_[l].rough());
    }
  }

  static constexpr int steps = 2;
  PressureProblem problem_;
  std::vector<MultigridLevel> levels_;
  int coarsest_steps_ = 1;
};

}  // namespace

bool suits_multigrid(const Index<2>& cells) {
  Index<2> n = cells;
  while (n[0] % 2 == 0 && n[1] % 2 == 0 && std::min(n[0], n[1]) >= 2 * fewest_cells) n = {n[0] / 2, n[1] / 2};
  // There are about two steps there for each cell of the longer side, against ten on the finest grid. With 90² cells,
  // of which one can make 45², a rotor three times as dense as the liquid takes half the time that transforms take.
  const double finest = static_cast<double>(cells[0]) * cells[1];
  return 2.0 * std::max(n[0], n[1]) * n[0] * n[1] <= 24 * finest;
}

std::unique_ptr<Preconditioner> make_multigrid(const PressureProblem& problem) {
  return std::make_unique<Multigrid>(problem);
}

}  // namespace mortise
