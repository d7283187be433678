#include "mortise/cases/pictures/colormap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace mortise {
namespace {

/// CIE lightness L* (0 … 100) of an sRGB colour.
double lightness(Rgb c) {
  const auto linear = [](int v) { return v <= 10 ? v / 255.0 / 12.92 : std::pow((v / 255.0 + 0.055) / 1.055, 2.4); };
  const double Y = 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
  return Y > 0.008856 ? 116 * std::cbrt(Y) - 16 : 903.3 * Y;
}

TEST(ColorMap, SequentialLightnessRisesEvenly) {
  const ColorMap& map = sequential_map();
  EXPECT_LT(lightness(map.front()), 15);
  EXPECT_GT(lightness(map.back()), 90);
  for (std::size_t k = 16; k < map.size(); k += 16) {
    const double rise = lightness(map[k]) - lightness(map[k - 16]);
    EXPECT_GT(rise, 3) << k;
    EXPECT_LT(rise, 7) << k;
  }
}

TEST(ColorMap, DivergingIsNeutralAndLightestInTheMiddle) {
  const ColorMap& map = diverging_map();
  EXPECT_LE(std::abs(map[127].red - map[127].blue), 3);
  EXPECT_GT(map.front().blue, map.front().red + 80);
  EXPECT_GT(map.back().red, map.back().blue + 80);
  for (std::size_t k = 0; k < 127; ++k) {
    EXPECT_LE(lightness(map[k]), lightness(map[k + 1]) + 0.3) << k;
    EXPECT_NEAR(lightness(map[k]), lightness(map[255 - k]), 7) << k;
  }
}

TEST(ColorMap, StressDarkensEvenlyFromPaleToRed) {
  const ColorMap& map = stress_map();
  EXPECT_GT(lightness(map.front()), 90);
  EXPECT_GT(map.back().red, map.back().blue + 70);
  for (std::size_t k = 16; k < map.size(); k += 16) {
    EXPECT_GT(lightness(map[k - 16]) - lightness(map[k]), 2.5) << k;
    EXPECT_LT(lightness(map[k - 16]) - lightness(map[k]), 6) << k;
  }
}

TEST(ColorMap, NoJumpsAndNoClippedEnds) {
  for (const ColorMap* map : {&sequential_map(), &diverging_map(), &stress_map(), &grey_map()})
    for (std::size_t k = 1; k < map->size(); ++k) {
      const Rgb a = (*map)[k - 1], b = (*map)[k];
      const int change = std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue);
      EXPECT_GT(change, 0) << k;
      EXPECT_LE(change, 12) << k;
    }
}

TEST(ColorMap, ValuesOutsideGetTheEnds) {
  EXPECT_EQ(color_at(grey_map(), -3), black);
  EXPECT_EQ(color_at(grey_map(), 0), black);
  EXPECT_EQ(color_at(grey_map(), 1), white);
  EXPECT_EQ(color_at(grey_map(), 1e300), white);
  EXPECT_EQ(color_at(grey_map(), 0.5), (Rgb{128, 128, 128}));
}

}  // namespace
}  // namespace mortise
