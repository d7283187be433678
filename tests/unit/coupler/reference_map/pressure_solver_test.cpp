// Pressure equations against manufactured solutions and against each other.
#include "mortise/coupler/reference_map/pressure_solver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mortise/coupler/reference_map/fast_transform.hpp"
#include "mortise/coupler/reference_map/multigrid.hpp"
#include "mortise/coupler/reference_map/variable_operator.hpp"
#include "mortise/grids/core/error.hpp"
#include "mortise/grids/forest/ghost_exchange.hpp"

namespace mortise {
namespace {

using enum PressureEnd;
using Ends = std::array<PressureEnd, 4>;

constexpr std::array<Ends, 7> all_ends{{{periodic, periodic, periodic, periodic},
                                        {neumann, neumann, neumann, neumann},
                                        {dirichlet, dirichlet, dirichlet, dirichlet},
                                        {neumann, dirichlet, neumann, neumann},
                                        {dirichlet, neumann, periodic, periodic},
                                        {periodic, periodic, neumann, dirichlet},
                                        {dirichlet, dirichlet, dirichlet, neumann}}};

/// Oblong cells, several tiles.
ComponentGrid<2> make_grid(const Ends& ends, Index<2> cells = {24, 16}) {
  ComponentGrid<2> grid("grid", Communicator(), cells, {ends[0] == periodic, ends[2] == periodic},
                        TileShape<2>({8, 8}));
  grid.spacing = Point<2>(1.0 / cells[0], 1.5 / cells[1]);
  return grid;
}

/// A number for each point or cell of the whole grid, without symmetry.
double noise(int i, int j) { return std::sin(12.9898 * i + 78.233 * j + 0.3 * i * j); }

/// An operator applied to known values, on the whole grid and on tiles.
struct Known {
  Known(const ComponentGrid<2>& grid, PressurePlace place, const Ends& ends, double ratio)
      : problem{&grid, place, ends, 1e-12}, points(grid.cells) {
    for (std::size_t d = 0; d < 2; ++d)
      if (place == PressurePlace::nodes && !grid.periodic[d]) ++points[d];
    const auto count = static_cast<std::size_t>(points[0] * points[1]);
    VariableOperator matrix(problem, points);
    std::vector<double> rho;
    for (int j = 0; j < grid.cells[1]; ++j)
      for (int i = 0; i < grid.cells[0]; ++i) rho.push_back(density(i, j, ratio));
    matrix.set_density(rho.data());
    p.resize(count);
    double sum = 0;
    for (int j = 0; j < points[1]; ++j)
      for (int i = 0; i < points[0]; ++i) sum += p[index(i, j)] = fixed(i, j) ? 0 : noise(i, j);
    if (problem.singular())
      for (double& value : p) value -= sum / static_cast<double>(count);
    std::vector<double> padded(matrix.padded());
    for (int j = 0; j < points[1]; ++j)
      for (int i = 0; i < points[0]; ++i)
        padded[static_cast<std::size_t>(matrix.first() + j * matrix.stride() + i)] = p[index(i, j)];
    b.resize(count + VariableOperator::slack);
    matrix.apply(padded.data(), b.data());
  }
  static double density(int i, int j, double ratio) {
    return ratio == 1 ? 1 : std::hypot(i - 11.0, j - 7.0) < 5 ? ratio : 1;
  }
  std::size_t index(int i, int j) const { return static_cast<std::size_t>(j * points[0] + i); }
  bool fixed(int i, int j) const {
    if (problem.place == PressurePlace::cells) return false;
    const Ends& e = problem.ends;
    return (e[0] == dirichlet && i == 0) || (e[1] == dirichlet && i == points[0] - 1) ||
           (e[2] == dirichlet && j == 0) || (e[3] == dirichlet && j == points[1] - 1);
  }
  PressureProblem problem;
  Index<2> points;
  std::vector<double> p, b;
};

/// Largest difference of `solver`'s answer from the known values, up to a constant where the problem is singular.
double error_of(const std::string& solver, const ComponentGrid<2>& grid, const Known& known, double ratio) {
  Field<2> right(grid.shape, 1, grid.forest.local_count()), p = Field<2>(grid.shape, 1, grid.forest.local_count()),
                                                            rho = Field<2>(grid.shape, 1, grid.forest.local_count());
  const int more = known.problem.place == PressurePlace::nodes ? 1 : 0;
  for (int t = 0; t < grid.forest.local_count(); ++t) {
    const Index<2> first = grid.first_cell(t);
    for_each_cell<2>(grid.shape, 2, [&](const Index<2>& c) {
      const int i = first[0] + c[0], j = first[1] + c[1];
      const auto wrap = [](int k, int n) { return (k + n) % n; };
      rho.tile(t).component(0)[grid.shape.at(c)] =
          Known::density(wrap(i, grid.cells[0]), wrap(j, grid.cells[1]), ratio);
      if (c[0] < 0 || c[1] < 0 || c[0] >= grid.shape.cells[0] + more || c[1] >= grid.shape.cells[1] + more) return;
      right.tile(t).component(0)[grid.shape.at(c)] = known.b[known.index(i % known.points[0], j % known.points[1])];
    });
  }
  const auto pressure = make_pressure_solver(solver, known.problem);
  pressure->solve(right, ratio == 1 ? nullptr : &rho, p, 0);
  double low = 1e300, high = -1e300;
  for (int t = 0; t < grid.forest.local_count(); ++t)
    for_each_cell<2>(grid.shape, 0, [&](const Index<2>& c) {
      const Index<2> first = grid.first_cell(t);
      const double difference =
          p.tile(t).component(0)[grid.shape.at(c)] - known.p[known.index(first[0] + c[0], first[1] + c[1])];
      low = std::min(low, difference), high = std::max(high, difference);
    });
  return known.problem.singular() ? high - low : std::max(std::abs(low), std::abs(high));
}

TEST(PressureSolver, AnswersAreExactForAllEndsPlacesAndDensities) {
  for (const std::string& solver : pressure_solver_keys())
    for (const PressurePlace place : {PressurePlace::cells, PressurePlace::nodes})
      for (std::size_t k = 0; k < all_ends.size(); ++k)
        for (const double ratio : {1.0, 3.0, 100.0}) {
          const ComponentGrid<2> grid = make_grid(all_ends[k]);
          const Known known(grid, place, all_ends[k], ratio);
          EXPECT_LT(error_of(solver, grid, known, ratio), ratio == 1 && solver == "transform" ? 1e-12 : 1e-8)
              << solver << (place == PressurePlace::cells ? " cells" : " nodes") << " ends " << k << " ratio " << ratio;
        }
}

/// One V-cycle leaves so much of an error e as the conjugate gradients count on, in the norm √(eᵀA e).
TEST(PressureSolver, MultigridContractsAsItSays) {
  for (const PressurePlace place : {PressurePlace::cells, PressurePlace::nodes})
    for (std::size_t k = 0; k < all_ends.size(); ++k)
      for (const auto& [ratio, cells] : std::vector<std::pair<double, Index<2>>>{
               {1, {64, 48}}, {3, {64, 48}}, {100, {64, 48}}, {3, {90, 50}}, {3, {36, 12}}}) {
        const ComponentGrid<2> grid = make_grid(all_ends[k], cells);
        ASSERT_TRUE(suits_multigrid(cells));
        const Known known(grid, place, all_ends[k], ratio);
        VariableOperator matrix(known.problem, known.points);
        std::vector<double> rho;
        for (int j = 0; j < grid.cells[1]; ++j)
          for (int i = 0; i < grid.cells[0]; ++i) rho.push_back(Known::density(i, j, ratio));
        matrix.set_density(rho.data());
        const auto multigrid = make_multigrid(known.problem);
        multigrid->set(matrix);
        std::vector<double> z(known.b.size()), e(matrix.padded()), Ae(known.b.size());
        const auto energy = [&](const auto& value) {
          double sum = 0;
          for (int j = 0; j < known.points[1]; ++j)
            for (int i = 0; i < known.points[0]; ++i)
              e[static_cast<std::size_t>(matrix.first() + j * matrix.stride() + i)] = value(known.index(i, j));
          matrix.apply(e.data(), Ae.data());
          for (int j = 0; j < known.points[1]; ++j)
            for (int i = 0; i < known.points[0]; ++i) sum += value(known.index(i, j)) * Ae[known.index(i, j)];
          return sum;
        };
        multigrid->apply(known.b.data(), z.data());
        const double before = energy([&](std::size_t n) { return known.p[n]; }),
                     after = energy([&](std::size_t n) { return known.p[n] - z[n]; });
        EXPECT_LT(after, std::pow(multigrid->contraction(), 2) * before)
            << (place == PressurePlace::cells ? " cells" : " nodes") << " ends " << k << " ratio " << ratio << " on "
            << cells[0] << " cells";
      }
  EXPECT_FALSE(suits_multigrid({45, 45}));
  EXPECT_FALSE(suits_multigrid({450, 450}));
}

/// cos kπx cos lπy between Neumann sides is an eigenvector of both matrices, and tends to one of −∇² at second order.
TEST(PressureSolver, ModesBetweenWallsTendToThoseOfTheLaplacian) {
  for (const PressurePlace place : {PressurePlace::cells, PressurePlace::nodes}) {
    double before = 0;
    for (const int n : {16, 32, 64}) {
      ComponentGrid<2> grid("grid", Communicator(), {n, n}, {false, false}, TileShape<2>({n, n}));
      grid.spacing = Point<2>(1.0 / n, 1.0 / n);
      const int m = place == PressurePlace::nodes ? n + 1 : n;
      const double shift = place == PressurePlace::nodes ? 0 : 0.5;
      FastTransform transform({&grid, place, {neumann, neumann, neumann, neumann}, 1e-10}, {m, m});
      std::vector<double> b(static_cast<std::size_t>(m * m)), p(b.size());
      const auto mode = [&](int i, int j) {
        return std::cos(2 * std::numbers::pi * (i + shift) / n) * std::cos(std::numbers::pi * (j + shift) / n);
      };
      const auto share = [&](int i) { return place == PressurePlace::nodes && (i == 0 || i == n) ? 0.5 : 1.0; };
      for (int j = 0; j < m; ++j)
        for (int i = 0; i < m; ++i)
          b[static_cast<std::size_t>(j * m + i)] =
              5 * std::numbers::pi * std::numbers::pi * mode(i, j) * share(i) * share(j) / n / n;
      transform.solve(b.data(), p.data());
      double error = 0;
      for (int j = 0; j < m; ++j)
        for (int i = 0; i < m; ++i)
          error = std::max(error, std::abs(p[static_cast<std::size_t>(j * m + i)] - mode(i, j)));
      EXPECT_LT(error, 4.0 / n / n * 5);
      if (before > 0) {
        EXPECT_GT(std::log2(before / error), 1.95);
      }
      before = error;
    }
  }
}

TEST(PressureSolver, UnknownKeyIsAnsweredWithTheNearest) {
  try {
    make_pressure_solver("transfrom", {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean \"transform\"?"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace mortise
