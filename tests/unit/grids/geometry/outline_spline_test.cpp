#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/geometry/outline.hpp"

namespace mortise {
namespace {

using std::numbers::pi;

std::vector<Point<2>> on_ellipse(int count, double a, double b) {
  std::vector<Point<2>> points;
  for (int k = 0; k < count; ++k)
    points.emplace_back(a * std::cos(2 * pi * k / count), b * std::sin(2 * pi * k / count));
  return points;
}

class OutlineFile : public testing::Test {
 protected:
  void write(const std::string& text) const { std::ofstream(path_) << text; }
  std::string complaint() const {
    try {
      Outline::spline_from_file(path_);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  void TearDown() override { std::filesystem::remove(path_); }

  const std::string path_ =
      testing::TempDir() + "outline_" + testing::UnitTest::GetInstance()->current_test_info()->name() + ".txt";
};

TEST(OutlineSpline, ConvergesToAnEllipseAtFourthOrder) {
  const double exact = pi * 0.7 * 0.35;
  const double coarse = std::abs(Outline::spline(on_ellipse(32, 0.7, 0.35)).area() - exact);
  const double fine = std::abs(Outline::spline(on_ellipse(64, 0.7, 0.35)).area() - exact);
  EXPECT_LT(coarse, 1e-4);
  EXPECT_GT(std::log2(coarse / fine), 3.7);
}

TEST(OutlineSpline, PassesThroughItsPoints) {
  const std::vector<Point<2>> points{{1, 0}, {0.3, 0.8}, {-0.9, 0.1}, {-0.2, -0.6}};
  const Outline outline = Outline::spline(points);
  EXPECT_GE(outline.polygon().size(), 2000u);
  for (const Point<2>& point : points) EXPECT_LT(std::abs(outline.tree().nearest(point).distance), 1e-15);
}

TEST(OutlineSpline, ARepeatedEndPointIsDropped) {
  auto points = on_ellipse(20, 1, 0.5);
  const double open = Outline::spline(points).area();
  points.push_back(points.front());
  EXPECT_EQ(Outline::spline(points).area(), open);
}

TEST(OutlineSpline, TooFewOrCoincidentPointsAreRejected) {
  EXPECT_THROW(Outline::spline({{0, 0}, {1, 0}, {0, 1}}), InputError);
  EXPECT_THROW(Outline::spline({{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}}), InputError);
  EXPECT_THROW(Outline::spline({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), InputError) << "crosses itself";
}

TEST_F(OutlineFile, ReadsBlanksCommasAndComments) {
  std::string text = "# an ellipse\n\n";
  int k = 0;
  for (const Point<2>& x : on_ellipse(40, 0.7, 0.35)) {
    text += std::to_string(x.x()) + (k % 2 ? "  " : ", ") + std::to_string(x.y()) + (k % 3 ? "\n" : "\t# point\r\n");
    ++k;
  }
  write(text);
  EXPECT_NEAR(Outline::spline_from_file(path_).area(), pi * 0.7 * 0.35, 2e-5);
}

TEST_F(OutlineFile, ABadLineIsNamed) {
  write("1 0\n0 1\n-1 zero\n0 -1\n");
  EXPECT_EQ(complaint(), path_ + ":3: expected two numbers \"x y\" or \"x,y\", found \"-1 zero\"");
  write("1 0\n0 1 2\n-1 0\n0 -1\n");
  EXPECT_EQ(complaint(), path_ + ":2: expected two numbers \"x y\" or \"x,y\", found \"0 1 2\"");
  write("1 0\n0 1\n0 1\n0 -1\n");
  EXPECT_EQ(complaint(), path_ + ":3: the point repeats the one before");
}

TEST_F(OutlineFile, AnOpenOutlineIsNamed) {
  std::string text;
  for (int k = 0; k <= 20; ++k)
    text += std::to_string(std::cos(pi * k / 20)) + " " + std::to_string(std::sin(pi * k / 20)) + "\n";
  write(text);
  EXPECT_THAT(complaint(), testing::StartsWith(path_ + ": the outline is open"));
}

TEST_F(OutlineFile, ACrossingOutlineIsNamed) {
  std::string text;
  for (int k = 0; k < 40; ++k)
    text += std::to_string(std::cos(2 * pi * k / 40)) + " " + std::to_string(std::sin(4 * pi * k / 40)) + "\n";
  write(text);
  EXPECT_EQ(complaint(), path_ + ": the outline crosses or touches itself");
}

TEST_F(OutlineFile, TooFewPointsAndMissingFilesAreNamed) {
  write("0 0\n1 0\n0 1\n");
  EXPECT_EQ(complaint(), path_ + ": a spline outline needs at least 4 points, found 3");
  std::filesystem::remove(path_);
  EXPECT_EQ(complaint(), "cannot read the outline file \"" + path_ + "\"");
}

}  // namespace
}  // namespace mortise
