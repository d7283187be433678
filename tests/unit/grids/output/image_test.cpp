#include "mortise/grids/output/image.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <numbers>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/atomic_file.hpp"
#include "scratch_folder.hpp"

namespace mortise {
namespace {

using test::ScratchFolder;

int count(const Image& image, Rgb color) {
  int found = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) found += image.at(x, y) == color ? 1 : 0;
  return found;
}

TEST(Image, PngDecodesToTheSamePixels) {
  const ScratchFolder folder;
  Image image(7, 5);
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 7; ++x)
      image.at(x, y) = {static_cast<std::uint8_t>(40 * x), static_cast<std::uint8_t>(60 * y), 9};
  write_png(image, folder / "a.png");
  png_image decoded{};
  decoded.version = PNG_IMAGE_VERSION;
  ASSERT_TRUE(png_image_begin_read_from_file(&decoded, (folder / "a.png").c_str()));
  EXPECT_EQ(decoded.width, 7U);
  EXPECT_EQ(decoded.height, 5U);
  decoded.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(decoded));
  ASSERT_TRUE(png_image_finish_read(&decoded, nullptr, pixels.data(), 0, nullptr));
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 7; ++x) {
      const std::size_t k = 3 * static_cast<std::size_t>(7 * y + x);
      EXPECT_EQ((Rgb{pixels[k], pixels[k + 1], pixels[k + 2]}), image.at(x, y)) << x << ' ' << y;
    }
}

TEST(Image, PngIsReproducibleAndUndated) {
  const ScratchFolder folder;
  write_png(Image(20, 10, {1, 2, 3}), folder / "a.png");
  write_png(Image(20, 10, {1, 2, 3}), folder / "b.png");
  const std::string bytes = read_file(folder / "a.png");
  EXPECT_EQ(bytes, read_file(folder / "b.png"));
  for (const char* chunk : {"tIME", "tEXt", "iTXt"}) EXPECT_EQ(bytes.find(chunk), std::string::npos);
  EXPECT_EQ(folder.files(), 2);
  EXPECT_THROW(write_png(Image(2, 2), folder / "no/a.png"), EnvironmentError);
}

TEST(Image, PolygonTakesThePixelsWhoseCentresItHolds) {
  Image image(10, 10);
  image.fill_polygon({{2.4, 3.6}, {6.6, 3.6}, {6.6, 7.4}, {2.4, 7.4}}, black);
  EXPECT_EQ(count(image, black), 5 * 3);  // centres 2.5 … 6.5 by 4.5 … 6.5
  EXPECT_EQ(image.at(2, 4), black);
  EXPECT_EQ(image.at(6, 6), black);
  EXPECT_EQ(image.at(2, 3), white);
}

TEST(Image, NeighbouringPolygonsShareNoPixelAndLeaveNone) {
  Image image(64, 64, {0, 0, 0});
  const Point<2> middle(31.7, 30.2);
  const int sectors = 13;
  const auto corner = [&](int k) {
    const double angle = 2 * std::numbers::pi * k / sectors;
    return Point<2>(middle + 25 * Point<2>(std::cos(angle), std::sin(angle)));
  };
  std::vector<Point<2>> hull;
  for (int k = 0; k < sectors; ++k) {
    image.fill_polygon({middle, corner(k), corner((k + 1) % sectors)}, {200, 0, 0}, 0.5);
    hull.push_back(corner(k));
  }
  Image once(64, 64, {0, 0, 0});
  once.fill_polygon(hull, {200, 0, 0}, 0.5);
  EXPECT_GT(count(once, {100, 0, 0}), 1500);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) EXPECT_EQ(image.at(x, y), once.at(x, y)) << x << ' ' << y;
}

TEST(Image, LineCoversItsAreaOnce) {
  for (const double angle : {0.0, 0.3, 1.1}) {
    Image image(100, 100);
    const Point<2> along(std::cos(angle), std::sin(angle)), start(20.3, 15.8);
    image.draw_polyline({start, start + 30 * along, start + 60 * along}, 3, black);
    double ink = 0;
    for (int y = 0; y < 100; ++y)
      for (int x = 0; x < 100; ++x) ink += (255 - image.at(x, y).red) / 255.0;
    EXPECT_NEAR(ink, 60 * 3 + std::numbers::pi * 1.5 * 1.5, 3) << angle;  // with two round ends
  }
}

TEST(Image, DrawingStaysInsideTheClip) {
  Image image(30, 30);
  image.clip_to(10, 12, 20, 18);
  image.fill_polygon({{-100, -100}, {200, -100}, {200, 200}, {-100, 200}}, black);
  image.draw_polyline({{-1e9, 15}, {1e9, 15}, {1e9, 1e9}}, 50, black);
  EXPECT_EQ(count(image, black), 10 * 6);
  EXPECT_EQ(image.at(10, 12), black);
  EXPECT_EQ(image.at(9, 12), white);
  EXPECT_EQ(image.at(20, 17), white);
}

TEST(Image, BlendIsExactAtItsEnds) {
  EXPECT_EQ(blend(Rgb{10, 20, 30}, Rgb{200, 100, 0}, 0), (Rgb{10, 20, 30}));
  EXPECT_EQ(blend(Rgb{10, 20, 30}, Rgb{200, 100, 0}, 1), (Rgb{200, 100, 0}));
  EXPECT_EQ(blend(Rgb{0, 0, 0}, Rgb{200, 100, 50}, 0.5), (Rgb{100, 50, 25}));
}

}  // namespace
}  // namespace mortise
