#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "mortise/grids/output/image.hpp"

namespace mortise {
namespace {

/// The pixels of a text, as a string that can be compared.
std::string drawn(const std::string& text, double size = 14) {
  Image image(200, 40);
  draw_text(image, 10, 28, text, size, black);
  std::string pixels;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 200; ++x) pixels += static_cast<char>(image.at(x, y).red);
  return pixels;
}

TEST(Font, EveryPrintableCharacterInUseIsDistinct) {
  std::set<std::string> shapes;
  const std::string characters =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.,:;!'\"-+=_/|()[]<>*%?#&";
  for (const char c : characters) {
    const std::string shape = drawn(std::string(1, c));
    EXPECT_NE(shape, drawn(" ")) << c << " is invisible";
    EXPECT_NE(shape, drawn("\x7f")) << c << " is drawn as unknown";
    shapes.insert(shape);
  }
  EXPECT_EQ(shapes.size(), characters.size());
}

TEST(Font, WidthIsAdditiveAndScales) {
  EXPECT_DOUBLE_EQ(text_width("density", 20), 2 * text_width("density", 10));
  EXPECT_EQ(text_width("", 10), 0);
  const double gap = text_width("nn", 9) - 2 * text_width("n", 9);
  EXPECT_NEAR(text_width("t = 0.7", 9), text_width("t = ", 9) + gap + text_width("0.7", 9), 1e-12);
}

TEST(Font, TextLiesWhereItIsAligned) {
  for (const Align align : {Align::left, Align::center, Align::right}) {
    Image image(300, 60);
    draw_text(image, 150, 40, "HEH", 20, black, align);
    int left = 300, right = 0, top = 60, bottom = 0;
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 300; ++x)
        if (image.at(x, y).red < 128) {
          left = std::min(left, x);
          right = std::max(right, x);
          top = std::min(top, y);
          bottom = std::max(bottom, y);
        }
    const double width = text_width("HEH", 20), start = align == Align::left     ? 150
                                                        : align == Align::center ? 150 - width / 2
                                                                                 : 150 - width;
    EXPECT_NEAR(left, start, 2);
    EXPECT_NEAR(right, start + width, 2);
    EXPECT_NEAR(top, 20, 2);
    EXPECT_NEAR(bottom, 40, 2);
  }
}

TEST(Font, UpwardsIsTheQuarterTurn) {
  Image flat(120, 120), upright(120, 120);
  draw_text(flat, 60, 60, "Rj4", 18, black, Align::center);
  draw_text_upwards(upright, 60, 60, "Rj4", 18, black);
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 120; ++x) EXPECT_NEAR(upright.at(y, 119 - x).red, flat.at(x, y).red, 2) << x << ' ' << y;
}

}  // namespace
}  // namespace mortise
