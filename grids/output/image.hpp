// Pictures: RGB pixels, and just enough drawing for fields, bodies, lines and labels. Same calls, same bytes.
// Coordinates are in pixels, x to the right, y down; the centre of pixel (i, j) is (i + ½, j + ½).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "mortise/grids/core/types.hpp"

namespace mortise {

struct Rgb {
  std::uint8_t red = 0, green = 0, blue = 0;  // sRGB

  bool operator==(const Rgb&) const = default;
};

inline constexpr Rgb white{255, 255, 255}, black{0, 0, 0};

/// a + t (b − a), 0 ≤ t ≤ 1, in sRGB.
Rgb blend(Rgb a, Rgb b, double t);

/// The pixels x0 ≤ x < x1, y0 ≤ y < y1.
struct Pixels {
  int x0, y0, x1, y1;
};

/// visit(row, first, end) for the runs of pixels within `clip` whose centres lie inside a closed polygon (even-odd
/// rule).
void for_each_run(const std::vector<Point<2>>& corners, const Pixels& clip,
                  const std::function<void(int y, int x0, int x1)>& visit);

class Image {
 public:
  Image(int width, int height, Rgb background = white);

  int width() const { return width_; }
  int height() const { return height_; }
  Rgb& at(int x, int y) {
    return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
  }
  const Rgb& at(int x, int y) const { return const_cast<Image&>(*this).at(x, y); }

  /// Drawing leaves pixels outside this rectangle (x0 ≤ x < x1, y0 ≤ y < y1) alone.
  void clip_to(int x0, int y0, int x1, int y1);
  void clip_to_all() { clip_to(0, 0, width_, height_); }

  /// Colours the pixels whose centres lie inside the closed polygon (even-odd rule); polygons that share an edge share
  /// no pixel and leave none out.
  void fill_polygon(const std::vector<Point<2>>& corners, Rgb color, double opacity = 1);
  /// Antialiased polyline of the given width in pixels, with round joints and ends, covered once however it bends.
  void draw_polyline(const std::vector<Point<2>>& points, double width, Rgb color, bool closed = false);

 private:
  void mix(int x, int y, Rgb color, double opacity) { at(x, y) = blend(at(x, y), color, opacity); }

  int width_, height_;
  int clip_x0_ = 0, clip_y0_ = 0, clip_x1_, clip_y1_;
  std::vector<Rgb> pixels_;  // row-major, top row first
};

/// Width in pixels of a line of text whose capitals are `size` pixels high.
double text_width(std::string_view text, double size);

enum class Align { left, center, right };

/// A line of ASCII text in a built-in stroke font; (x, y) is on the baseline. Other characters become boxes.
void draw_text(Image& image, double x, double y, std::string_view text, double size, Rgb color,
               Align align = Align::left);

/// The text turned by a quarter, reading upwards; (x, y) is the middle of the baseline.
void draw_text_upwards(Image& image, double x, double y, std::string_view text, double size, Rgb color);

/// Writes an 8-bit RGB PNG without date or text chunks, atomically. Throws EnvironmentError.
void write_png(const Image& image, const std::string& path);

}  // namespace mortise
