#include "mortise/cases/study/histories_of.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/atomic_file.hpp"
#include "unit/grids/output/scratch_folder.hpp"

namespace mortise {
namespace {

TEST(History, HoldsTheRowsOfOneItem) {
  const test::ScratchFolder folder;
  const std::string path = folder / "bodies.csv";
  write_file(path, "t,body,x\n0,a,1\n0,b,5\n1,a,2\n1,b,6\n3,a,4\n");
  const auto history = read_history(path, "a");
  EXPECT_EQ(history.at("t"), (std::vector<double>{0, 1, 3}));
  EXPECT_EQ(history.at("x"), (std::vector<double>{1, 2, 4}));
  EXPECT_DOUBLE_EQ(history_at(history, "x", 2), 3);
  EXPECT_DOUBLE_EQ(history_at(history, "x", 9), 4);
  EXPECT_DOUBLE_EQ(history_at(history, "x", -1), 1);
  EXPECT_THROW(read_history(path, "c"), EnvironmentError);
}

TEST(FittedFrequency, IsThatOfADampedOscillation) {
  std::vector<double> t, u;
  for (int k = 0; k <= 300; ++k) {
    t.push_back(0.1 * k);
    u.push_back(std::exp(-0.002 * t.back()) * std::cos(2.2 * t.back() + 0.4));
  }
  EXPECT_NEAR(fitted_frequency(t, u, 2.1), 2.2, 2e-4);
}

}  // namespace
}  // namespace mortise
