// The stroke font of draw_text. A glyph is its width and some strokes on a grid: each point is a digit x and a
// hexadecimal digit y, with the baseline at y = 3, the top of small letters at 9 and of capitals at c = 12. A stroke
// that starts with ~ is a quadratic B-spline of its points (closed when it ends where it starts), others are straight.
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "mortise/grids/output/image.hpp"

namespace mortise {
namespace {

constexpr int baseline = 3, capital_height = 9;
constexpr double letter_spacing = 2.5, pen = 1.15;  // in units of the grid

const char* glyph(char c) {
  static constexpr auto table = std::to_array<std::pair<char, const char*>>({
      {' ', "2"},
      {'.', "0 0303"},
      {',', "1 1401"},
      {':', "0 0303 0808"},
      {';', "1 1401 1818"},
      {'!', "0 0c06 0303"},
      {'\'', "0 0c0a"},
      {'"', "2 0c0a 2c2a"},
      {'-', "4 0747"},
      {'+', "4 0747 2529"},
      {'=', "4 0646 0848"},
      {'_', "5 0252"},
      {'/', "4 024c"},
      {'|', "0 0d02"},
      {'(', "2 ~2d0b0422"},
      {')', "2 ~0d2b2402"},
      {'[', "2 2d0d0222"},
      {']', "2 0d2d2202"},
      {'<', "4 4a0743"},
      {'>', "4 0a4703"},
      {'*', "4 2b27 0a48 4a08"},
      {'%', "6 6c03 ~09292c0c09 ~4363664643"},
      {'?', "5 ~0a0c5c582826 2323"},
      {'#', "6 132c 435c 0666 0969"},
      {'&', "6 631a ~1a1c5c5a17 ~1707034366"},
      {'0', "5 ~035357585c0c080703"},
      {'1', "3 0a2c23"},
      {'2', "5 ~0a0c5c5803 0353"},
      {'3', "5 ~0a0c5c5828 ~2858530305"},
      {'4', "5 434c0555"},
      {'5', "5 4c0c08 ~082858531304"},
      {'6', "5 ~0353590903 ~4c1c0906"},
      {'7', "5 0c5c23"},
      {'8', "5 ~08585c0c08 ~0353580803"},
      {'9', "5 ~06565c0c06 ~13435659"},
      {'A', "6 033c63 1656"},
      {'B', "5 030c 0c2c ~2c5c5828 0828 ~28585323 0323"},
      {'C', "6 ~6a6c0c036365"},
      {'D', "6 030c 0c2c ~2c6c6323 0323"},
      {'E', "5 5c0c0353 0848"},
      {'F', "5 5c0c03 0848"},
      {'G', "6 ~6a6c0c036367 6747"},
      {'H', "6 030c 636c 0868"},
      {'I', "2 131c 0c2c 0323"},
      {'J', "4 ~4c43430305"},
      {'K', "5 030c 5c07 2953"},
      {'L', "5 0c0353"},
      {'M', "6 030c376c63"},
      {'N', "6 030c636c"},
      {'O', "6 ~03636c0c03"},
      {'P', "5 030c 0c2c ~2c5c5727 0727"},
      {'Q', "6 ~03636c0c03 4562"},
      {'R', "5 030c 0c2c ~2c5c5727 0727 2753"},
      {'S', "5 ~5a5c0c0857530305"},
      {'T', "6 0c6c 3c33"},
      {'U', "6 0c07 ~07036367 676c"},
      {'V', "6 0c336c"},
      {'W', "8 0c234b638c"},
      {'X', "6 036c 0c63"},
      {'Y', "6 0c386c 3833"},
      {'Z', "6 0c6c0363"},
      {'a', "5 ~0353590903 5953"},
      {'b', "5 ~0353590903 030c"},
      {'c', "5 ~585909035354"},
      {'d', "5 ~0353590903 535c"},
      {'e', "5 0656 ~565909035354"},
      {'f', "3 ~3c1c19 1913 0939"},
      {'g', "5 ~0353590903 5953 ~53500001"},
      {'h', "5 030c ~06095956 5653"},
      {'i', "0 0309 0c0c"},
      {'j', "2 2924 ~242000 2c2c"},
      {'k', "4 030c 4905 1643"},
      {'l', "0 030c"},
      {'m', "8 0309 ~06094946 4643 ~46498986 8683"},
      {'n', "5 0309 ~06095956 5653"},
      {'o', "5 ~0353590903"},
      {'p', "5 ~0353590903 0009"},
      {'q', "5 ~0353590903 5059"},
      {'r', "3 0309 ~060939"},
      {'s', "4 ~4849090646430304"},
      {'t', "3 1c15 ~151333 0939"},
      {'u', "5 0906 ~06035356 5953"},
      {'v', "4 092349"},
      {'w', "6 0913395369"},
      {'x', "4 0349 0943"},
      {'y', "4 0923 4910"},
      {'z', "4 09490343"},
  });
  for (const auto& [character, strokes] : table)
    if (character == c) return strokes;
  return "5 03535c0c03";
}

double glyph_width(char c) { return glyph(c)[0] - '0'; }

using Stroke = std::vector<Point<2>>;

/// The quadratic B-spline that starts and ends at the first and last control point, or is closed if they agree.
Stroke smooth(const Stroke& control) {
  const bool closed = control.front() == control.back();
  const std::size_t n = control.size() - (closed ? 1 : 0);
  Stroke curve;
  for (std::size_t k = closed ? 0 : 1; k < (closed ? n : n - 1); ++k) {
    const Point<2>&before = control[(k + n - 1) % n], &here = control[k], &after = control[(k + 1) % n];
    const Point<2> start = !closed && k == 1 ? before : Point<2>(0.5 * (before + here));
    const Point<2> end = !closed && k + 2 == n ? after : Point<2>(0.5 * (here + after));
    for (int s = 0; s <= 8; ++s) {
      const double t = s / 8.0;
      curve.push_back((1 - t) * (1 - t) * start + 2 * t * (1 - t) * here + t * t * end);
    }
  }
  return curve;
}

/// The strokes of a glyph, x to the right from its left edge and y up from the baseline, in units of the grid.
std::vector<Stroke> strokes(char c) {
  std::vector<Stroke> result;
  bool curved = false;
  const auto finish = [&] {
    if (!result.empty() && curved) result.back() = smooth(result.back());
  };
  const char* at = glyph(c) + 1;
  for (; *at; ++at) {
    if (*at == ' ') {
      finish();
      curved = at[1] == '~';
      if (curved) ++at;
      result.emplace_back();
    } else {
      const int x = at[0] - '0', y = at[1] <= '9' ? at[1] - '0' : at[1] - 'a' + 10;
      result.back().emplace_back(x, y - baseline);
      ++at;
    }
  }
  finish();
  return result;
}

/// right, down: one unit of the grid along the text and from top to bottom, in pixels.
void draw(Image& image, Point<2> origin, std::string_view text, const Point<2>& right, const Point<2>& down,
          Rgb color) {
  for (const char c : text) {
    for (Stroke& stroke : strokes(c)) {
      for (Point<2>& point : stroke) point = origin + point.x() * right - point.y() * down;
      image.draw_polyline(stroke, pen * right.norm(), color);
    }
    origin += (glyph_width(c) + letter_spacing) * right;
  }
}

}  // namespace

double text_width(std::string_view text, double size) {
  double width = text.empty() ? 0 : -letter_spacing;
  for (const char c : text) width += glyph_width(c) + letter_spacing;
  return width * size / capital_height;
}

void draw_text(Image& image, double x, double y, std::string_view text, double size, Rgb color, Align align) {
  const double unit = size / capital_height, width = text_width(text, size);
  const double shift = align == Align::left ? 0 : align == Align::center ? 0.5 * width : width;
  draw(image, {x - shift, y}, text, {unit, 0}, {0, unit}, color);
}

void draw_text_upwards(Image& image, double x, double y, std::string_view text, double size, Rgb color) {
  const double unit = size / capital_height;
  draw(image, {x, y + 0.5 * text_width(text, size)}, text, {0, -unit}, {unit, 0}, color);
}

}  // namespace mortise
