#include "mortise/cases/pictures/axes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mortise {
namespace {

std::vector<std::string> labels(double low, double high, int count) {
  std::vector<std::string> texts;
  for (const Tick& tick : ticks(low, high, count)) texts.push_back(tick.label);
  return texts;
}

TEST(Axes, TicksAreRoundAndEquallyPrecise) {
  EXPECT_EQ(labels(-1.5, 3, 9),
            (std::vector<std::string>{"-1.5", "-1.0", "-0.5", "0.0", "0.5", "1.0", "1.5", "2.0", "2.5", "3.0"}));
  EXPECT_EQ(labels(0, 100, 5), (std::vector<std::string>{"0", "20", "40", "60", "80", "100"}));
  EXPECT_EQ(labels(0.7141, 0.7149, 4), (std::vector<std::string>{"0.7142", "0.7144", "0.7146", "0.7148"}));
  EXPECT_EQ(labels(1, 1.00005, 5),
            (std::vector<std::string>{"1", "1.00001", "1.00002", "1.00003", "1.00004", "1.00005"}));
  EXPECT_EQ(labels(0, 2e-7, 2), (std::vector<std::string>{"0", "1e-07", "2e-07"}));
}

TEST(Axes, NoTicksForAnEmptyOrInfiniteRange) {
  EXPECT_TRUE(ticks(1, 1, 5).empty());
  EXPECT_TRUE(ticks(2, 1, 5).empty());
  EXPECT_TRUE(ticks(1, 1 + 1e-15, 5).empty()) << "multiples of the step would not differ";
  EXPECT_TRUE(ticks(0, std::nan(""), 5).empty());
}

TEST(Axes, PixelsRunDownwards) {
  const Axes axes{10, 20, 110, 70, {{-1, 0}, {1, 1}}};
  EXPECT_EQ(axes.pixel({-1, 1}), Point<2>(10, 20));
  EXPECT_EQ(axes.pixel({1, 0}), Point<2>(110, 70));
  EXPECT_EQ(axes.pixels({{0, 0.5}}).at(0), Point<2>(60, 45));
}

TEST(Axes, LabelsAreShortWithoutMinusZero) {
  EXPECT_EQ(label(-0.0), "0");
  EXPECT_EQ(label(0.25), "0.25");
  EXPECT_EQ(label(1234.5678), "1235");
  EXPECT_EQ(fixed(0.7, 4), "0.7000");
}

TEST(Axes, LongLabelsAreMadeToFit) {
  Image image(200, 40);
  draw_label(image, 10, 30, "a label too long for its place", 12, 60, Align::left);
  bool any = false;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 72; ++x) any = any || !(image.at(x, y) == white);
    for (int x = 73; x < 200; ++x) EXPECT_EQ(image.at(x, y), white) << x << ' ' << y;
  }
  EXPECT_TRUE(any);
}

}  // namespace
}  // namespace mortise
