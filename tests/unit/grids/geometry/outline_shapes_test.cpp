#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/geometry/outline.hpp"

namespace mortise {
namespace {

using std::numbers::pi;

std::string complaint(const std::function<Outline()>& make) {
  try {
    make();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// A rectangle, less four squares of side r at its corners, plus four quarter disks.
double rounded_rectangle_moment(double w, double h, double r) {
  const double sharp = w * h * (w * w + h * h) / 12;
  const double sx = (w - r) / 2, sy = (h - r) / 2, square = r * r * (sx * sx + sy * sy) + r * r * r * r / 6;
  const double cx = w / 2 - r, cy = h / 2 - r, quarter = pi * r * r / 4;
  const double disk =
      pi * r * r * r * r / 8 + 2 * quarter * (4 * r / (3 * pi)) * (cx + cy) + quarter * (cx * cx + cy * cy);
  return sharp - 4 * square + 4 * disk;
}

TEST(OutlineShapes, RoundedRectangleHasTheFilletArithmetic) {
  const Outline stick = Outline::rounded_rectangle(0.1, 0.5, 0.038);
  EXPECT_NEAR(stick.area(), 0.05 - (4 - pi) * 0.038 * 0.038, 1e-15);
  EXPECT_NEAR(stick.perimeter(), 1.2 - (8 - 2 * pi) * 0.038, 1e-14);
  EXPECT_NEAR(stick.second_moment(), rounded_rectangle_moment(0.1, 0.5, 0.038), 1e-15);
  EXPECT_LT(stick.centroid().norm(), 1e-16);
}

TEST(OutlineShapes, TinyFilletsGiveTheSharpRectangle) {
  const Outline stick = Outline::rounded_rectangle(0.1, 0.5, 1e-5);
  EXPECT_NEAR(stick.area(), 0.05, 1e-10);
  EXPECT_NEAR(stick.second_moment(), 0.001083333333, 1e-10);
}

TEST(OutlineShapes, LargestFilletGivesACapsule) {
  const Outline capsule = Outline::rounded_rectangle(0.2, 0.6, 0.1);
  EXPECT_NEAR(capsule.area(), 0.2 * 0.4 + pi * 0.01, 1e-14);
  EXPECT_NEAR(capsule.bounds().high.y(), 0.3, 1e-15);
}

TEST(OutlineShapes, FilletsAreArcs) {
  const Outline stick = Outline::rounded_rectangle(0.1, 0.5, 0.038);
  int on_fillet = 0;
  for (const Point<2>& x : stick.polygon()) {
    const Point<2> from_center = x - Point<2>(0.012, 0.212);
    if (from_center.x() <= 1e-12 || from_center.y() <= 1e-12) continue;
    EXPECT_NEAR(from_center.norm(), 0.038, 1e-15);
    ++on_fillet;
  }
  EXPECT_GE(on_fillet, 40);
}

TEST(OutlineShapes, RectangleIsMirrored) {
  const Outline stick = Outline::rounded_rectangle(0.1, 0.5, 0.038);
  const double half = stick.perimeter() / 2;
  for (const double s : {0.01, 0.2, 0.24, 0.26, 0.4, 0.5}) {
    const Point<2> x = stick.at(s), mirrored_y = stick.at(-s), mirrored_x = stick.at(half - s);
    EXPECT_LT((mirrored_y - Point<2>(x.x(), -x.y())).norm(), 1e-14);
    EXPECT_LT((mirrored_x - Point<2>(-x.x(), x.y())).norm(), 1e-14);
  }
}

TEST(OutlineShapes, InwardCornersAndClockwiseOrderAreFine) {
  const std::vector<Point<2>> corners{{0, 0}, {1, 0}, {1, 0.4}, {0.4, 0.4}, {0.4, 1}, {0, 1}};
  // Five outward fillets take (1 − π/4) r² each, the inward one gives it.
  const double exact = 0.64 - 4 * (1 - pi / 4) * 0.01;
  EXPECT_NEAR(Outline::rounded_polygon(corners, 0.1).area(), exact, 1e-14);
  EXPECT_NEAR(Outline::rounded_polygon({corners.rbegin(), corners.rend()}, 0.1).area(), exact, 1e-14);
}

TEST(OutlineShapes, WrongSizesAreOneClearSentence) {
  EXPECT_EQ(complaint([] { return Outline::circle(-1); }), "the radius must be positive and finite, not -1");
  EXPECT_EQ(complaint([] { return Outline::ellipse(1, 0); }),
            "the second semi-axis must be positive and finite, not 0");
  EXPECT_EQ(complaint([] { return Outline::rounded_rectangle(1, std::numeric_limits<double>::infinity(), 0.1); }),
            "the height must be positive and finite, not inf");
  EXPECT_THAT(complaint([] { return Outline::rounded_rectangle(0.1, 0.5, 0.06); }),
              testing::HasSubstr("a fillet of 0.06 does not fit on the edge of length 0.1"));
  EXPECT_EQ(complaint([] {
              return Outline::rounded_polygon({{0, 0}, {1, 0}}, 0.1);
            }),
            "a polygon needs at least 3 corners, not 2");
}

TEST(OutlineShapes, CrossingPolygonsAreRejected) {
  EXPECT_EQ(complaint([] {
              return Outline::rounded_polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, 0.01);
            }),
            "the polygon crosses or touches itself");
  EXPECT_EQ(complaint([] {
              return Outline::rounded_polygon({{0, 0}, {1, 0}, {1, 0}, {0, 1}}, 0.01);
            }),
            "the polygon crosses or touches itself");
}

}  // namespace
}  // namespace mortise
