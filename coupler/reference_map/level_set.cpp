#include "mortise/coupler/reference_map/level_set.hpp"

#include <algorithm>
#include <cmath>

namespace mortise {

LevelSet::LevelSet(const Outline& outline, double spacing, double margin) : inverse_spacing_(1 / spacing) {
  box_ = outline.bounds().grown(margin);
  for (int d = 0; d < 2; ++d) {
    cells_[static_cast<std::size_t>(d)] =
        std::max(1, static_cast<int>(std::ceil((box_.high[d] - box_.low[d]) / spacing)));
    box_.high[d] = box_.low[d] + cells_[static_cast<std::size_t>(d)] * spacing;
  }
  values_.reserve(static_cast<std::size_t>(cells_[0] + 1) * static_cast<std::size_t>(cells_[1] + 1));
  for (int j = 0; j <= cells_[1]; ++j)
    for (int i = 0; i <= cells_[0]; ++i)
      values_.push_back(outline.tree().nearest(box_.low + spacing * Point<2>(i, j)).distance);
}

double LevelSet::operator()(double x, double y) const {
  const double u = (x - box_.low.x()) * inverse_spacing_, v = (y - box_.low.y()) * inverse_spacing_;
  const double cu = std::clamp(u, 0.0, static_cast<double>(cells_[0])),
               cv = std::clamp(v, 0.0, static_cast<double>(cells_[1]));
  const int i = std::min(static_cast<int>(cu), cells_[0] - 1), j = std::min(static_cast<int>(cv), cells_[1] - 1);
  const double a = cu - i, b = cv - j;
  const auto row = static_cast<std::size_t>(cells_[0] + 1);
  const double* node = values_.data() + static_cast<std::size_t>(j) * row + static_cast<std::size_t>(i);
  const double inside = (1 - b) * ((1 - a) * node[0] + a * node[1]) + b * ((1 - a) * node[row] + a * node[row + 1]);
  const double beyond = std::fabs(u - cu) + std::fabs(v - cv);
  return beyond > 0 ? inside + beyond / inverse_spacing_ : inside;
}

}  // namespace mortise
