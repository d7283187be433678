// The periodic cubic spline p(t) through p_i at t_i, t_{i+1} − t_i = h_i = |p_{i+1} − p_i|: its derivatives m_i satisfy
//   h_i m_{i−1} + 2 (h_{i−1} + h_i) m_i + h_{i−1} m_{i+1} = 3 [h_i (p_i − p_{i−1})/h_{i−1} + h_{i−1} (p_{i+1} −
//   p_i)/h_i]
// (continuity of p″; de Boor, A Practical Guide to Splines, chapter IV). Fourth order in the spacing of smooth data.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/geometry/cyclic_tridiagonal.hpp"
#include "mortise/grids/geometry/outline.hpp"

namespace mortise {

namespace {

constexpr double vertex_count = 2048;  // at least, on a whole outline
constexpr double open_gap = 5;         // times the largest other spacing

using Points = std::vector<Point<2>>;

Points spline_derivatives(const Points& p, const std::vector<double>& h) {
  const std::size_t n = p.size();
  CyclicTridiagonal matrix(n);
  Points right(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
    matrix.below[i] = h[i];
    matrix.diagonal[i] = 2 * (h[before] + h[i]);
    matrix.above[i] = h[before];
    right[i] = 3 * (h[i] / h[before] * (p[i] - p[before]) + h[before] / h[i] * (p[after] - p[i]));
  }
  return solve(matrix, std::move(right));
}

/// The two numbers of a line "x y" or "x,y"; false when it holds anything else.
bool parse_point(std::string text, Point<2>& point) {
  std::replace(text.begin(), text.end(), ',', ' ');
  const char *at = text.data(), *end = text.data() + text.size();
  const auto skip_blanks = [&] {
    at = std::find_if(at, end, [](char c) { return c != ' ' && c != '\t' && c != '\r'; });
  };
  for (int d = 0; d < 2; ++d) {
    skip_blanks();
    const auto [rest, failure] = std::from_chars(at, end, point[d]);
    if (failure != std::errc() || !std::isfinite(point[d])) return false;
    at = rest;
  }
  skip_blanks();
  return at == end;
}

Points read_points(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw InputError("cannot read the outline file \"" + path + "\"");
  Points points;
  int line = 0;
  for (std::string text; std::getline(file, text);) {
    ++line;
    const std::string content = text.substr(0, text.find('#'));
    if (content.find_first_not_of(" \t\r") == std::string::npos) continue;
    const std::string place = path + ":" + std::to_string(line) + ": ";
    Point<2> point;
    if (!parse_point(content, point))
      throw InputError(place + "expected two numbers \"x y\" or \"x,y\", found \"" + text + "\"");
    if (!points.empty() && point == points.back()) throw InputError(place + "the point repeats the one before");
    points.push_back(point);
  }
  if (file.bad()) throw InputError("cannot read the outline file \"" + path + "\"");
  return points;
}

void reject_open(const Points& points, const std::string& path) {
  double largest = 0;
  for (std::size_t k = 1; k < points.size(); ++k) largest = std::max(largest, (points[k] - points[k - 1]).norm());
  const double gap = (points.front() - points.back()).norm();
  if (gap > open_gap * largest)
    throw InputError(path + ": the outline is open: first and last point are " + std::to_string(gap) +
                     " apart, other neighbours at most " + std::to_string(largest));
}

}  // namespace

Outline Outline::spline(const std::vector<Point<2>>& given) {
  Points points = given;
  if (points.size() > 1 && points.front() == points.back()) points.pop_back();
  const std::size_t n = points.size();
  if (n < 4) throw InputError("a spline outline needs at least 4 different points, not " + std::to_string(n));
  std::vector<double> h(n);
  double total = 0;
  for (std::size_t i = 0; i < n; ++i) {
    h[i] = (points[(i + 1) % n] - points[i]).norm();
    total += h[i];
    if (!(h[i] > 0)) throw InputError("two neighbouring points of the spline outline coincide");
  }
  const Points derivative = spline_derivatives(points, h);
  Points vertices, tangents;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t after = (i + 1) % n;
    const int count = std::max(4, static_cast<int>(std::ceil(vertex_count * h[i] / total)));
    for (int k = 0; k < count; ++k) {
      const double t = static_cast<double>(k) / count, s = 1 - t;
      vertices.push_back(s * s * (1 + 2 * t) * points[i] + t * t * (1 + 2 * s) * points[after] +
                         s * t * h[i] * (s * derivative[i] - t * derivative[after]));
      tangents.push_back((6 * s * t / h[i] * (points[after] - points[i]) + s * (1 - 3 * t) * derivative[i] +
                          t * (1 - 3 * s) * derivative[after])
                             .normalized());
    }
  }
  return Outline(std::move(vertices), std::move(tangents));
}

Outline Outline::spline_from_file(const std::string& path) {
  const Points points = read_points(path);
  if (points.size() < 4)
    throw InputError(path + ": a spline outline needs at least 4 points, found " + std::to_string(points.size()));
  reject_open(points, path);
  try {
    return spline(points);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

}  // namespace mortise
