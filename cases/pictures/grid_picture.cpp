#include <algorithm>
#include <array>

#include "mortise/cases/pictures/picture_kinds.hpp"

namespace mortise {
namespace {

/// Edge colours, background first, then in turn for the body-fitted grids.
constexpr Rgb background_ink{112, 126, 145};
constexpr std::array<Rgb, 5> body_inks{Rgb{196, 62, 40}, Rgb{20, 120, 96}, Rgb{120, 60, 160}, Rgb{190, 120, 10},
                                       Rgb{30, 90, 180}};
constexpr Rgb solid_ground{255, 236, 204};

Rgb ink_of(std::size_t grid) { return grid == 0 ? background_ink : body_inks[(grid - 1) % body_inks.size()]; }

/// One component grid on the pixels of the axes.
class Mesh {
 public:
  Mesh(const GridSnapshot& grid, const Axes& axes) : grid_(grid) {
    nodes_.reserve(grid.node_count());
    for (std::size_t k = 0; k < grid.node_count(); ++k) nodes_.push_back(axes.pixel({grid.x[k], grid.y[k]}));
  }

  void fill(Image& image, std::uint8_t mask, Rgb color, double opacity) const {
    for (int j = 0; j < grid_.cells[1]; ++j)
      for (int i = 0; i < grid_.cells[0]; ++i)
        if (at(i, j) == mask)
          image.fill_polygon({node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)}, color, opacity);
  }

  /// The edges whose neighbours' smaller mask is `mask`: an edge between an active and a fringe cell is active.
  void draw_edges(Image& image, std::uint8_t mask, double width, Rgb color) const {
    for (int j = 0; j <= grid_.cells[1]; ++j)
      for (int i = 0; i <= grid_.cells[0]; ++i) {
        if (i < grid_.cells[0] && std::min(at(i, j), at(i, j - 1)) == mask)
          image.draw_polyline({node(i, j), node(i + 1, j)}, width, color);
        if (j < grid_.cells[1] && std::min(at(i, j), at(i - 1, j)) == mask)
          image.draw_polyline({node(i, j), node(i, j + 1)}, width, color);
      }
  }

 private:
  std::uint8_t at(int i, int j) const {
    const bool inside = i >= 0 && i < grid_.cells[0] && j >= 0 && j < grid_.cells[1];
    return inside ? grid_.mask[grid_.cell(i, j)] : std::uint8_t{mask_hole};
  }
  const Point<2>& node(int i, int j) const { return nodes_[grid_.node(i, j)]; }

  const GridSnapshot& grid_;
  std::vector<Point<2>> nodes_;  // pixels
};

}  // namespace

void draw_grids(Image& image, const Axes& axes, const Snapshot& snapshot, double unit) {
  const double pen = 0.8 * unit;
  for (std::size_t g = 0; g < snapshot.grids.size(); ++g) {
    const Mesh mesh(snapshot.grids[g], axes);
    const Rgb strong = ink_of(g), faint = blend(white, strong, 0.6);
    mesh.fill(image, mask_fringe, blend(white, strong, 0.18), 0.7);
    const Rgb ground = snapshot.grids[g].solid ? solid_ground : white;
    if (g > 0 || snapshot.grids[g].solid) mesh.fill(image, mask_active, ground, 0.7);  // the grid below shines through
    mesh.draw_edges(image, mask_fringe, pen, faint);
    mesh.draw_edges(image, mask_active, pen, strong);
  }
}

}  // namespace mortise
