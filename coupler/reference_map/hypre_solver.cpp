#include "mortise/coupler/reference_map/hypre_solver.hpp"

#include <HYPRE_struct_ls.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mortise/coupler/reference_map/point_exchange.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

using Box = std::array<std::array<HYPRE_Int, 2>, 2>;  // lowest, highest index

/// One box per tile; a matrix row per point: itself, then its neighbours in the order of `offsets`.
class HypreSolver : public PressureSolver {
 public:
  explicit HypreSolver(const PressureProblem& problem)
      : problem_(problem), comm_(problem.grid->forest.communicator().raw()) {
    static const HYPRE_Int started = HYPRE_Init();
    (void)started;
    list_boxes();
    HYPRE_StructGridCreate(comm_, 2, &grid_);
    for (Box& box : boxes_) HYPRE_StructGridSetExtents(grid_, box[0].data(), box[1].data());
    std::array<HYPRE_Int, 2> period{};
    for (std::size_t d = 0; d < 2; ++d)
      if (problem.grid->periodic[d]) period[d] = problem.grid->cells[d];
    HYPRE_StructGridSetPeriodic(grid_, period.data());
    HYPRE_StructGridAssemble(grid_);
    HYPRE_StructStencilCreate(2, entries(), &stencil_);
    for (int k = 0; k < entries(); ++k) {
      std::array<HYPRE_Int, 2> offset{offsets[static_cast<std::size_t>(k)][0], offsets[static_cast<std::size_t>(k)][1]};
      HYPRE_StructStencilSetElement(stencil_, k, offset.data());
    }
    HYPRE_StructMatrixCreate(comm_, grid_, stencil_, &matrix_);
    HYPRE_StructMatrixInitialize(matrix_);
    for (HYPRE_StructVector* v : {&b_, &x_}) {
      HYPRE_StructVectorCreate(comm_, grid_, v);
      HYPRE_StructVectorInitialize(*v);
    }
  }
  ~HypreSolver() override {
    free_solver();
    HYPRE_StructVectorDestroy(b_);
    HYPRE_StructVectorDestroy(x_);
    HYPRE_StructMatrixDestroy(matrix_);
    HYPRE_StructStencilDestroy(stencil_);
    HYPRE_StructGridDestroy(grid_);
  }
  HypreSolver(const HypreSolver&) = delete;
  HypreSolver& operator=(const HypreSolver&) = delete;

  int solve(const Field<2>& right, const Field<2>* density, Field<2>& pressure, double) override {
    const bool was_constant = solver_ && constant_;
    constant_ = density == nullptr;
    if (!(constant_ && was_constant)) set_matrix(density);
    put(right, b_, problem_.singular() ? mean(right) : 0);
    put(pressure, x_, problem_.singular() ? fixed_value(pressure) : 0);
    if (!(constant_ && was_constant)) make_solver();
    HYPRE_StructPCGSolve(solver_, matrix_, b_, x_);
    HYPRE_Int iterations = 0;
    double left = 0;
    HYPRE_StructPCGGetNumIterations(solver_, &iterations);
    HYPRE_StructPCGGetFinalRelativeResidualNorm(solver_, &left);
    HYPRE_ClearAllErrors();
    if (!(left <= problem_.tolerance || iterations == 0))
      throw NumericalError("the pressure did not converge in " + std::to_string(most_iterations) +
                           " iterations of multigrid");
    take(pressure);
    return static_cast<int>(iterations);
  }

 private:
  static constexpr std::array<std::array<int, 2>, 9> offsets{
      {{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
  static constexpr int most_iterations = 200;

  bool nodes() const { return problem_.place == PressurePlace::nodes; }
  int entries() const { return nodes() ? 9 : 5; }
  const ComponentGrid<2>& grid() const { return *problem_.grid; }
  const TileShape<2>& shape() const { return grid().shape; }

  void list_boxes() {
    for (int t = 0; t < grid().forest.local_count(); ++t) {
      const Index<2> first = grid().first_cell(t);
      Box box;
      for (std::size_t d = 0; d < 2; ++d) {
        const bool last = first[d] + shape().cells[d] == grid().cells[d];
        box[0][d] = first[d];
        box[1][d] = first[d] + shape().cells[d] - (nodes() && last && !grid().periodic[d] ? 0 : 1);
      }
      boxes_.push_back(box);
    }
  }
  /// Calls visit(i, j) for the points of a tile's box, by their index in the tile.
  template <class Visit>
  void for_each_point(int tile, Visit&& visit) const {
    const Box& box = boxes_[static_cast<std::size_t>(tile)];
    for (int j = 0; j <= box[1][1] - box[0][1]; ++j)
      for (int i = 0; i <= box[1][0] - box[0][0]; ++i) visit(i, j);
  }

  /// The point (grid-wide, periodic directions wrap) is a Dirichlet node, or the one that is held at 0 where the
  /// pressure is known up to a constant: its equation follows from the others.
  bool fixed(int i, int j) const {
    const auto wrap = [&](int k, std::size_t d) {
      return grid().periodic[d] ? (k + grid().cells[d]) % grid().cells[d] : k;
    };
    if (problem_.singular()) return wrap(i, 0) == 0 && wrap(j, 1) == 0;
    const auto at = [&](std::size_t side, int k, int place) {
      return nodes() && problem_.ends[side] == PressureEnd::dirichlet && k == place;
    };
    return at(0, i, 0) || at(1, i, grid().cells[0]) || at(2, j, 0) || at(3, j, grid().cells[1]);
  }

  /// Matrix row of cell (i, j) of a tile whose first cell is `first`.
  void cell_row(const Index<2>& first, const double* density, int i, int j, double* row) const {
    const double aspect = grid().spacing[1] / grid().spacing[0];
    const auto rho = [&](int k, int l) { return density ? density[shape().at(k, l)] : 1.0; };
    const Index<2> c{first[0] + i, first[1] + j};
    std::fill_n(row, 5, 0.0);
    if (fixed(c[0], c[1])) {
      row[0] = 1;
      return;
    }
    double sum = 0;
    for (std::size_t k = 1; k < 5; ++k) {
      const std::size_t side = k - 1, d = side / 2;
      const double scale = d == 0 ? aspect : 1 / aspect;
      const bool at_end = !grid().periodic[d] && c[d] == (side % 2 == 0 ? 0 : grid().cells[d] - 1);
      const double weight = scale * 2 / (rho(i, j) + (at_end ? rho(i, j) : rho(i + offsets[k][0], j + offsets[k][1])));
      row[k] = at_end || fixed(c[0] + offsets[k][0], c[1] + offsets[k][1]) ? 0 : -weight;
      sum += !at_end ? weight : problem_.ends[side] == PressureEnd::dirichlet ? 2 * weight : 0;
    }
    row[0] = sum;
  }

  /// Matrix row of node (i, j): four cells around it, those beyond a side have no share. Fixed nodes stand alone.
  void node_row(const Index<2>& first, const double* density, int i, int j, double* row) const {
    const double a = grid().spacing[1] / grid().spacing[0], b = 1 / a;
    const Index<2> n{first[0] + i, first[1] + j};
    std::fill_n(row, 9, 0.0);
    if (fixed(n[0], n[1])) {
      row[0] = 1;
      return;
    }
    const auto outside = [&](int c, std::size_t d) { return !grid().periodic[d] && (c < 0 || c >= grid().cells[d]); };
    for (const int dj : {-1, 1})
      for (const int di : {-1, 1}) {
        const int ci = di < 0 ? i - 1 : i, cj = dj < 0 ? j - 1 : j;
        if (outside(first[0] + ci, 0) || outside(first[1] + cj, 1)) continue;
        const double volume = density ? 1 / density[shape().at(ci, cj)] : 1.0;
        row[0] += volume * (a + b) / 3;
        const auto add = [&](std::size_t entry, double value) {
          if (!fixed(n[0] + offsets[entry][0], n[1] + offsets[entry][1])) row[entry] += volume * value;
        };
        add(di < 0 ? 1 : 2, b / 6 - a / 3);
        add(dj < 0 ? 3 : 4, a / 6 - b / 3);
        add(static_cast<std::size_t>(5 + (di > 0 ? 1 : 0) + (dj > 0 ? 2 : 0)), -(a + b) / 6);
      }
  }

  void set_matrix(const Field<2>* density) {
    std::vector<HYPRE_Int> numbers;
    for (int k = 0; k < entries(); ++k) numbers.push_back(k);
    for (std::size_t t = 0; t < boxes_.size(); ++t) {
      const Index<2> first = grid().first_cell(static_cast<int>(t));
      const double* const rho = density ? density->tile(static_cast<int>(t)).component(0) : nullptr;
      values_.clear();
      for_each_point(static_cast<int>(t), [&](int i, int j) {
        std::array<double, 9> row{};
        if (nodes())
          node_row(first, rho, i, j, row.data());
        else
          cell_row(first, rho, i, j, row.data());
        values_.insert(values_.end(), row.begin(), row.begin() + entries());
      });
      HYPRE_StructMatrixSetBoxValues(matrix_, boxes_[t][0].data(), boxes_[t][1].data(), entries(), numbers.data(),
                                     values_.data());
    }
    HYPRE_StructMatrixAssemble(matrix_);
  }

  /// Mean of the points, tile by tile.
  double mean(const Field<2>& field) const {
    struct TileSum {
      double sum;
      std::int64_t count;
    };
    std::vector<TileSum> mine;
    for (std::size_t t = 0; t < boxes_.size(); ++t) {
      TileSum tile{0, 0};
      const double* const p = field.tile(static_cast<int>(t)).component(0);
      for_each_point(static_cast<int>(t), [&](int i, int j) { tile.sum += p[shape().at(i, j)], ++tile.count; });
      mine.push_back(tile);
    }
    TileSum all{0, 0};
    for (const TileSum& tile : grid().forest.communicator().gather_all(mine))
      all.sum += tile.sum, all.count += tile.count;
    return all.sum / static_cast<double>(all.count);
  }

  /// Value at the first point of the grid, which is held at 0.
  double fixed_value(const Field<2>& field) const {
    const Neighbor first = grid().forest.find({0, 0});
    const bool here = first.rank == grid().forest.communicator().rank();
    const double value = here ? field.tile(first.local).component(0)[shape().at(0, 0)] : -1e300;
    return grid().forest.communicator().max(value);
  }

  void put(const Field<2>& field, HYPRE_StructVector vector, double less) {
    for (std::size_t t = 0; t < boxes_.size(); ++t) {
      const Index<2> first = grid().first_cell(static_cast<int>(t));
      const double* const p = field.tile(static_cast<int>(t)).component(0);
      values_.clear();
      for_each_point(static_cast<int>(t), [&](int i, int j) {
        values_.push_back(fixed(first[0] + i, first[1] + j) ? 0 : p[shape().at(i, j)] - less);
      });
      HYPRE_StructVectorSetBoxValues(vector, boxes_[t][0].data(), boxes_[t][1].data(), values_.data());
    }
    HYPRE_StructVectorAssemble(vector);
  }

  void take(Field<2>& field) {
    for (std::size_t t = 0; t < boxes_.size(); ++t) {
      const Box& box = boxes_[t];
      double* const p = field.tile(static_cast<int>(t)).component(0);
      values_.resize(static_cast<std::size_t>((box[1][0] - box[0][0] + 1) * (box[1][1] - box[0][1] + 1)));
      HYPRE_StructVectorGetBoxValues(x_, boxes_[t][0].data(), boxes_[t][1].data(), values_.data());
      const double* value = values_.data();
      for_each_point(static_cast<int>(t), [&](int i, int j) { p[shape().at(i, j)] = *value++; });
    }
    const double less = problem_.singular() ? mean(field) : 0;
    for (std::size_t t = 0; t < boxes_.size(); ++t) {
      double* const p = field.tile(static_cast<int>(t)).component(0);
      for_each_point(static_cast<int>(t), [&](int i, int j) { p[shape().at(i, j)] -= less; });
    }
    exchange_.fill(field);
  }

  void make_solver() {
    free_solver();
    HYPRE_StructPFMGCreate(comm_, &multigrid_);
    HYPRE_StructPFMGSetMaxIter(multigrid_, 1);
    HYPRE_StructPFMGSetTol(multigrid_, 0);
    HYPRE_StructPFMGSetZeroGuess(multigrid_);
    HYPRE_StructPFMGSetRelaxType(multigrid_, nodes() ? 1 : 2);  // Jacobi; red-black, symmetric
    HYPRE_StructPCGCreate(comm_, &solver_);
    HYPRE_StructPCGSetTol(solver_, problem_.tolerance);
    HYPRE_StructPCGSetTwoNorm(solver_, 1);
    HYPRE_StructPCGSetMaxIter(solver_, most_iterations);
    HYPRE_StructPCGSetPrecond(solver_, HYPRE_StructPFMGSolve, HYPRE_StructPFMGSetup, multigrid_);
    HYPRE_StructPCGSetup(solver_, matrix_, b_, x_);
  }
  void free_solver() {
    if (!solver_) return;
    HYPRE_StructPCGDestroy(solver_);
    HYPRE_StructPFMGDestroy(multigrid_);
    solver_ = nullptr;
  }

  PressureProblem problem_;
  MPI_Comm comm_;
  PointExchange exchange_{*problem_.grid, 1};
  std::vector<Box> boxes_;
  std::vector<double> values_;
  bool constant_ = false;  // the matrix is that of density 1
  HYPRE_StructGrid grid_{};
  HYPRE_StructStencil stencil_{};
  HYPRE_StructMatrix matrix_{};
  HYPRE_StructVector b_{}, x_{};
  HYPRE_StructSolver solver_{}, multigrid_{};
};

}  // namespace

std::unique_ptr<PressureSolver> make_hypre_solver(const PressureProblem& problem) {
  return std::make_unique<HypreSolver>(problem);
}

}  // namespace mortise
