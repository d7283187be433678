#include "mortise/coupler/reference_map/solid_edges.hpp"

#include <cmath>

#include "mortise/coupler/reference_map/map_branches.hpp"

namespace mortise {
namespace {

// Where the share of a solid fades out, liquid beyond its surface would be dragged along by the solid's shear stress,
// and the solid be braked by it. Therefore shear across the surface fades this part of the blur width further inside,
// and the fluid's viscosity reaches so much deeper. Measured on rm_convergence: the error of the velocity falls
// from 8.8e-3 to 4.9e-3 on 90² cells, from 3.5e-3 to 2.0e-3 on 180².
constexpr double shear_inset = 0.3, viscosity_inset = 0.5;

constexpr double least_determinant = 0.25;  // |det ∂ξ/∂x − 1| is small where the map is whole
constexpr double contact_stiffness = 4;     // pressure of contacts, in shear moduli, where surfaces meet

struct Stress {
  Pack xx{}, xy{}, yy{};
};
struct Vector {
  Pack x, y;
};

/// τ of the elastic part of the deformation, F F_a⁻¹; `stretch` is a of F_a = Rᵀ diag(a, 1/a) R, c and s: of R.
MORTISE_INLINE Stress neo_hookean(const MapGradient<Pack>& G, double modulus, Pack stretch, double c, double s) {
  // With H = diag(a, 1/a) R G the elastic left Cauchy-Green tensor is b = (HᵀH)⁻¹.
  const Pack shrink = 1.0 / stretch;
  const Pack xx = stretch * (c * G.xx + s * G.yx), xy = stretch * (c * G.xy + s * G.yy);
  const Pack yx = shrink * (c * G.yx - s * G.xx), yy = shrink * (c * G.yy - s * G.xy);
  // The material keeps its volume: where the map does not quite, only the change of shape counts, b/J.
  const Pack det = xx * yy - xy * yx, inverse = 1.0 / det;
  const Pack bxx = inverse * (xy * xy + yy * yy), byy = inverse * (xx * xx + yx * yx),
             bxy = -(inverse * (xx * xy + yx * yy)), mean = (1.0 / 3) * (bxx + byy + 1.0);
  return {modulus * (bxx - mean), modulus * bxy, modulus * (byy - mean)};
}

/// τ, its shear across surfaces of normal n taken `shear` times, all else `share` times: tension along a surface and,
/// by way of the pressure, what presses on it make the stiffness of bars and flags against bending.
MORTISE_INLINE Stress weighted(const Stress& tau, const Vector& n, Pack shear, Pack share) {
  const Pack inverse = 1.0 / max(n.x * n.x + n.y * n.y, broadcast(1e-30));
  const Pack xx = inverse * (n.x * n.x), xy = inverse * (n.x * n.y), yy = inverse * (n.y * n.y);
  // n·τ·t with t = (−n_y, n_x), and n ⊗ t + t ⊗ n = ((−2 xy, xx − yy), (xx − yy, 2 xy)).
  const Pack across = (shear - share) * ((xx - yy) * tau.xy + xy * (tau.yy - tau.xx));
  return {share * tau.xx - 2.0 * across * xy, share * tau.xy + across * (xx - yy), share * tau.yy + 2.0 * across * xy};
}

/// A pressure `amount` along n and as much tension across.
MORTISE_INLINE Stress push_along(const Vector& n, Pack amount) {
  const Pack size2 = n.x * n.x + n.y * n.y, scale = select(size2 > 0, Pack(amount / size2), Pack{});
  return {-(scale * (n.x * n.x) - 0.5 * amount), -(scale * (n.x * n.y)), -(scale * (n.y * n.y) - 0.5 * amount)};
}

/// Edges of one direction (0: west ones, 1: south ones) of a tile's cells, four or eight in a row at a time.
class Edges {
 public:
  Edges(const EdgeSolids& tile, int direction, const TileWindow& window)
      : shape_(tile.grid->shape),
        direction_(direction),
        back_(direction == 0 ? 1 : shape_.stride),
        across_(direction == 0 ? shape_.stride : 1),
        along_step_(1 / tile.grid->spacing[direction]),
        across_step_(0.25 / tile.grid->spacing[1 - direction]),
        window_(window & TileWindow{{0, 0}, {shape_.cells[0] + (direction == 0), shape_.cells[1] + (direction == 1)}}),
        stress_((direction == 0 ? tile.fields->stress_x : tile.fields->stress_y).tile(tile.tile)),
        viscosity_(tile.fields->viscosity.tile(tile.tile).component(direction)) {}

  /// visit(i, j, k, own): edges before the cells from offset k on, own: those that count.
  template <class Visit>
  MORTISE_INLINE void visit(const EdgeBody& body, double width, Visit visit) const {
    const double *const layer = body.map->component(3), *const phi = body.map->component(2);
    for (int j = window_.low[1]; j < window_.high[1]; ++j)
      for (int i = window_.low[0]; i < window_.high[0]; i += simd_width) {
        const std::size_t k = shape_.at(i, j);
        const Pack level = middle(phi + k);
        const PackMask own = (load(layer + k) < unknown_layer) & (load(layer + k - back_) < unknown_layer) &
                             (level < width) & lanes_below(window_.high[0] - i);
        if (any(own)) visit(i, j, k, own, level);
      }
  }

  MORTISE_INLINE Pack middle(const double* q) const { return 0.5 * (load(q) + load(q - back_)); }
  /// ∇q on the edge.
  MORTISE_INLINE Vector slope(const double* q) const {
    const Pack along = along_step_ * (load(q) - load(q - back_));
    const Pack aside = across_step_ * ((load(q + across_) - load(q - across_)) +
                                       (load(q - back_ + across_) - load(q - back_ - across_)));
    return direction_ == 0 ? Vector{along, aside} : Vector{aside, along};
  }
  /// The jump of linearly reconstructed q: a third difference.
  MORTISE_INLINE Pack jump(const double* q) const {
    return -0.25 * ((load(q + back_) - load(q - 2 * back_)) - 3.0 * (load(q) - load(q - back_)));
  }
  MORTISE_INLINE void add(std::size_t k, PackMask own, const Stress& stress) const {
    double *const normal = stress_.component(0) + k, *const other = stress_.component(1) + k;
    const Pack a = direction_ == 0 ? stress.xx : stress.xy, b = direction_ == 0 ? stress.xy : stress.yy;
    store(normal, load(normal) + select(own, a, Pack{}));
    store(other, load(other) + select(own, b, Pack{}));
  }
  MORTISE_INLINE void add_viscosity(std::size_t k, PackMask own, Pack amount) const {
    store(viscosity_ + k, max(load(viscosity_ + k) + select(own, amount, Pack{}), Pack{}));
  }

 private:
  const TileShape<2>& shape_;
  int direction_;
  std::ptrdiff_t back_, across_;
  double along_step_, across_step_;
  TileWindow window_;
  TileBlock& stress_;
  double* viscosity_;
};

/// The stretch of the actuation on edges; 1 elsewhere.
Pack stretch_on(const FlowBody& body, PackMask own, Pack X, Pack Y, double time) {
  Pack stretch = broadcast(1.0);
  for (int l = 0; l < simd_width; ++l)
    if (own[l]) stretch[l] = body.actuation({X[l], Y[l]}, time);
  return stretch;
}

}  // namespace

void add_elastic(const EdgeSolids& tile, const EdgeBody& body) {
  const double inverse_width = 1 / tile.width, modulus = body.body->shear_modulus;
  const double cosine = std::cos(body.body->axis), sine = std::sin(body.body->axis);
  const double impedance = tile.velocity ? tile.damping * std::sqrt(body.body->density * modulus) : 0;
  const double *const x = body.map->component(0), *const y = body.map->component(1);
  const bool active = static_cast<bool>(body.body->actuation);
  for (const int direction : {0, 1}) {
    const Edges edges(tile, direction, body.window);
    edges.visit(body, tile.width, [&](int, int, std::size_t k, PackMask own, Pack level) {
      const Vector gx = edges.slope(x + k), gy = edges.slope(y + k);
      MapGradient<Pack> G{gx.x, gx.y, gy.x, gy.y};
      // Where bands of two parts of a surface meet the map is torn.
      const Pack det = G.determinant();
      own = own & (det > least_determinant) & (det < 1 / least_determinant);
      if (body.folded) own = own & (G.xx * G.xx + G.xy * G.xy + G.yx * G.yx + G.yy * G.yy < branch_jump * branch_jump);
      // Lanes that do not count compute with an undeformed solid.
      G = {select(own, G.xx, broadcast(1.0)), select(own, G.xy, Pack{}), select(own, G.yx, Pack{}),
           select(own, G.yy, broadcast(1.0))};
      const Pack stretch =
          active ? stretch_on(*body.body, own, edges.middle(x + k), edges.middle(y + k), tile.time) : broadcast(1.0);
      Stress tau = neo_hookean(G, modulus, stretch, cosine, sine);
      if (impedance > 0) {
        const Pack u = impedance * edges.jump(tile.velocity->component(0) + k),
                   v = impedance * edges.jump(tile.velocity->component(1) + k);
        if (direction == 0)
          tau.xx = tau.xx + u, tau.xy = tau.xy + v;
        else
          tau.xy = tau.xy + u, tau.yy = tau.yy + v;
      }
      tau = weighted(tau, edges.slope(body.map->component(2) + k),
                     solid_share(level + shear_inset * tile.width, inverse_width), solid_share(level, inverse_width));
      edges.add(k, own, tau);
      edges.add_viscosity(k, own,
                          body.body->viscosity * solid_share(level, inverse_width) -
                              tile.fluid_viscosity * solid_share(level + viscosity_inset * tile.width, inverse_width));
    });
  }
}

void add_contact(const EdgeSolids& tile, const EdgeBody& body, const EdgeBody& other) {
  const double inverse_width = 1 / tile.width;
  const double modulus = contact_stiffness * std::min(body.body->shear_modulus, other.body->shear_modulus);
  const double *const mine = body.map->component(2), *const theirs = other.map->component(2);
  for (const int direction : {0, 1}) {
    const Edges edges(tile, direction, body.window & other.window);
    edges.visit(body, tile.width, [&](int, int, std::size_t k, PackMask own, Pack level) {
      const Pack their_level = edges.middle(theirs + k);
      own = own & (their_level < tile.width);
      const Vector a = edges.slope(theirs + k), b = edges.slope(mine + k);
      const Vector n{select(own, Pack(a.x - b.x), Pack{}), select(own, Pack(a.y - b.y), Pack{})};
      const Pack overlap = min(1.0 - level * inverse_width, 1.0 - their_level * inverse_width);
      edges.add(k, own,
                push_along(n, select(own, Pack(solid_share(level, inverse_width) * (modulus * overlap)), Pack{})));
    });
  }
}

void add_self_contact(const EdgeSolids& tile, const EdgeBody& body) {
  const double inverse_width = 1 / tile.width, modulus = contact_stiffness * body.body->shear_modulus;
  const double* const phi = body.map->component(2);
  const std::ptrdiff_t row = tile.grid->shape.stride;
  const Point<2>& h = tile.grid->spacing;
  const auto outward = [&](const MapBranch& branch, const double* q) {
    return Vector{(1 / h[0]) * branch_slope(branch, q, 1), (1 / h[1]) * branch_slope(branch, q, row)};
  };
  for (const int direction : {0, 1}) {
    const std::ptrdiff_t back = direction == 0 ? 1 : row;
    const Edges edges(tile, direction, body.window);
    edges.visit(body, tile.width, [&](int, int, std::size_t k, PackMask own, Pack level) {
      const MapBranch here(*body.map, k, h.maxCoeff());
      own = own & ~here.reaches(-back);
      if (!any(own)) return;
      const MapBranch there(*body.map, k - static_cast<std::size_t>(back), h.maxCoeff());
      const Vector a = outward(there, phi + k - back), b = outward(here, phi + k);
      const Vector n{select(own, Pack(a.x - b.x), Pack{}), select(own, Pack(a.y - b.y), Pack{})};
      const Pack overlap = 1.0 - level * inverse_width;
      // Each of the two parts pushes.
      edges.add(
          k, own,
          push_along(n, select(own, Pack(2.0 * solid_share(level, inverse_width) * (modulus * overlap)), Pack{})));
    });
  }
}

void add_wall_push(const EdgeSolids& tile, const EdgeBody& body, std::size_t side) {
  const ComponentGrid<2>& grid = *tile.grid;
  const std::size_t d = side / 2;
  const auto e = static_cast<Eigen::Index>(d);
  const double inverse_width = 1 / tile.width, modulus = contact_stiffness * body.body->shear_modulus;
  const Index<2> first = grid.first_cell(tile.tile);
  const double h = grid.spacing[e], end = side % 2 ? grid.cells[d] * h : 0.0;
  Pack steps{};
  for (int l = 0; l < simd_width; ++l) steps[l] = d == 0 ? l : 0;
  for (const int direction : {0, 1}) {
    const Edges edges(tile, direction, body.window);
    const double half = static_cast<int>(d) == direction ? 0.0 : 0.5;
    edges.visit(body, tile.width, [&](int i, int j, std::size_t k, PackMask own, Pack level) {
      const Pack at = (first[d] + (d == 0 ? i : j) + half + steps) * h;
      const Pack closeness = 1.0 - abs(Pack(at - end)) * (inverse_width / 3);
      own = own & (closeness > 0);
      const Vector n{broadcast(d == 0), broadcast(d == 1)};
      edges.add(k, own, push_along(n, solid_share(level, inverse_width) * (modulus * closeness)));
    });
  }
}

}  // namespace mortise
