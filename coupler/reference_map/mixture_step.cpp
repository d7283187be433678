#include "mortise/coupler/reference_map/mixture_step.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "mortise/coupler/reference_map/mixture_riemann.hpp"
#include "mortise/fluid/reconstruction.hpp"
#include "mortise/fluid/rows.hpp"
#include "mortise/fluid/step_kernels.hpp"

namespace mortise {
namespace {

/// Planes of doubles in the layout of a tile, reused from call to call; a thread's own.
double* scratch(std::size_t plane, int count) {
  thread_local std::vector<double> memory;
  const std::size_t wanted = plane * static_cast<std::size_t>(count) + 16;
  if (memory.size() < wanted) memory.assign(wanted, 1.0);
  return memory.data() + 8;
}

/// What the solids are at the faces of one direction, Σ over bodies of s times the quantity.
enum FaceData {
  normal_stress,
  tangential_stress,
  solid_mass,
  solid_energy,
  solid_pressure,
  normal_stiffness,
  tangential_stiffness,
  face_count
};

struct Maps {
  const double *x, *y, *phi, *layer;
};
Maps maps_of(const TileBlock& block) {
  return {block.component(0), block.component(1), block.component(2), block.component(3)};
}

/// A cell and its four neighbours hold ξ.
MORTISE_INLINE bool holds(const double* layer, std::ptrdiff_t s) {
  return layer[0] < unknown_layer && layer[-1] < unknown_layer && layer[1] < unknown_layer &&
         layer[-s] < unknown_layer && layer[s] < unknown_layer;
}

template <Limiter limiter>
class MixtureKernel {
 public:
  MixtureKernel(const MixtureTile& tile, double dt, const StepOptions& options)
      : tile_(tile),
        shape_(*tile.cells.shape),
        stride_(shape_.stride),
        plane_(shape_.plane),
        gamma_(options.gamma),
        courant_{dt / tile.cells.spacing[0], dt / tile.cells.spacing[1]},
        floor_(rows::limiter_floor<2>(options)),
        memory_(scratch(plane_, plane_count)) {}

  StepResult run() {
    for (const int direction : {0, 1}) compose_faces(direction);
    for (int j = -2; j < shape_.cells[1] + 2; ++j) make_primitive(j);
    for (int j = -1; j <= shape_.cells[1]; ++j) reconstruct(j);
    for (int j = 0; j < shape_.cells[1]; ++j) fluxes<0>(j);
    for (int j = 0; j <= shape_.cells[1]; ++j) fluxes<1>(j);
    Pack good = broadcast(1.0);
    for (int j = 0; j < shape_.cells[1]; ++j) good = update(j, good);
    bool admissible = true;
    for (int k = 0; k < simd_width; ++k) admissible = admissible && good[k] > 0;
    return {0, admissible};
  }

 private:
  using State = Primitive<2, Pack>;
  enum Plane {
    faces = 0,                   // two directions
    primitive = 2 * face_count,  // m, u, v, q, ρ⁻¹
    west = primitive + 5,
    east = west + 4,
    south = east + 4,
    north = south + 4,
    flux = north + 4,  // two directions
    plane_count = flux + 8
  };
  double* plane(int number) const { return memory_ + static_cast<std::size_t>(number) * plane_; }
  double* face_plane(int direction, FaceData what) const { return plane(faces + direction * face_count + what); }

  /// Faces of all cells from −1 to the last but one ghost: face k lies before cell k.
  void compose_faces(int direction) const {
    for (int what = 0; what < face_count; ++what)
      std::fill_n(face_plane(direction, static_cast<FaceData>(what)), plane_, 0.0);
    for (const TileBody& body : tile_.bodies) add_faces(direction, body);
  }

  void add_faces(int direction, const TileBody& body) const {
    const Maps map = maps_of(*body.map);
    const std::ptrdiff_t back = direction == 0 ? 1 : stride_, across = direction == 0 ? stride_ : 1;
    const double inverse_width = 1 / tile_.blur;
    const double along_step = 1 / tile_.cells.spacing[static_cast<std::size_t>(direction)];
    const double across_step = 0.25 / tile_.cells.spacing[static_cast<std::size_t>(1 - direction)];
    const int i_high = shape_.cells[0] + (direction == 0 ? 2 : 1), j_high = shape_.cells[1] + (direction == 0 ? 1 : 2);
    for (int j = -1; j < j_high; ++j)
      for (int i = -1; i < i_high; i += simd_width) {
        const std::size_t k = shape_.at(i, j);
        const Pack phi = 0.5 * (load(map.phi + k) + load(map.phi + k - back));
        const Pack near = select(phi < tile_.blur, broadcast(1.0), Pack{});
        if (horizontal_max(near) == 0) continue;
        const auto along = [&](const double* q) { return along_step * (load(q + k) - load(q + k - back)); };
        const auto aside = [&](const double* q) {
          return across_step * ((load(q + k + across) - load(q + k - across)) +
                                (load(q + k + across - back) - load(q + k - across - back)));
        };
        MapGradient<Pack> G;
        if (direction == 0)
          G = {along(map.x), aside(map.x), along(map.y), aside(map.y)};
        else
          G = {aside(map.x), along(map.x), aside(map.y), along(map.y)};
        const PackMask valid = (phi < tile_.blur) & (G.determinant() > 0);
        G.xx = select(valid, G.xx, broadcast(1.0));
        G.yy = select(valid, G.yy, broadcast(1.0));
        G.xy = select(valid, G.xy, Pack{});
        G.yx = select(valid, G.yx, Pack{});
        const SolidPoint<Pack> p = solid_point(*body.law, G);
        const Pack share = select(valid, solid_share(phi, inverse_width), Pack{});
        const auto add = [&](FaceData what, Pack value) {
          double* at = face_plane(direction, what) + k;
          store(at, load(at) + share * value);
        };
        add(normal_stress, direction == 0 ? p.xx : p.yy);
        add(tangential_stress, p.xy);
        add(solid_mass, p.density);
        add(solid_energy, p.energy);
        add(solid_pressure, broadcast(tile_.pressure));
        add(normal_stiffness, direction == 0 ? p.normal_x : p.normal_y);
        add(tangential_stiffness, direction == 0 ? p.tangential_x : p.tangential_y);
      }
  }

  void make_primitive(int j) const {
    const double *const mass = tile_.composition->component(composition::mass), *const energy =
                                                                                    tile_.composition->component(
                                                                                        composition::energy);
    for (int i = row_start; i < shape_.cells[0] + 2; i += simd_width) {
      const std::size_t k = shape_.at(i, j);
      Conserved<2, Pack> U = rows::load_conserved<2>(tile_.cells.now + k, plane_);
      const int count = shape_.cells[0] + 2 - i;
      if (count < simd_width) U = rows::valid_beyond<2>(count, U);
      const Pack inverse = 1.0 / U.density;
      const Pack u = U.momentum[0] * inverse, v = U.momentum[1] * inverse;
      Pack m = U.density, e = U.energy - 0.5 * (U.momentum[0] * u + U.momentum[1] * v);
      Pack of_solid = load(mass + k), energy_of_solid = load(energy + k);
      if (count < simd_width) {
        of_solid = select(lanes_below(count), of_solid, Pack{});
        energy_of_solid = select(lanes_below(count), energy_of_solid, Pack{});
      }
      store(plane(primitive) + k, m - of_solid);
      store(plane(primitive + 1) + k, u);
      store(plane(primitive + 2) + k, v);
      store(plane(primitive + 3) + k, (gamma_ - 1) * (e - energy_of_solid));
      store(plane(primitive + 4) + k, inverse);
    }
  }

  MORTISE_INLINE State primitive_at(std::size_t k) const {
    return rows::load_primitive<2>(plane(primitive) + k, plane_);
  }

  /// Where there is solid, slopes are not held back by the positivity of m and q.
  MORTISE_INLINE State half_slopes(const State& before, const State& here, const State& after, PackMask pure) const {
    const State a = here - before, b = after - here;
    State h;
    h.density = half_slope<limiter>(a.density, b.density, floor_.density);
    for (std::size_t d = 0; d < 2; ++d)
      h.velocity[d] = half_slope<limiter>(a.velocity[d], b.velocity[d], floor_.velocity[d]);
    h.pressure = half_slope<limiter>(a.pressure, b.pressure, floor_.pressure);
    h.density = select(pure, limit_magnitude(h.density, 0.9 * here.density), h.density);
    h.pressure = select(pure, limit_magnitude(h.pressure, 0.9 * here.pressure), h.pressure);
    return h;
  }

  void reconstruct(int j) const {
    const std::size_t s = static_cast<std::size_t>(stride_);
    const double* const share = tile_.composition->component(composition::share);
    for (int i = row_start; i < shape_.cells[0] + 2; i += simd_width) {
      const std::size_t k = shape_.at(i, j);
      const PackMask pure = load(share + k) == 0;
      const State W = primitive_at(k);
      HalfSlopes<2, Pack> h = {{half_slopes(primitive_at(k - 1), W, primitive_at(k + 1), pure),
                                half_slopes(primitive_at(k - s), W, primitive_at(k + s), pure)}};
      const Pack inverse = load(plane(primitive + 4) + k);
      State half = half_step(W, inverse, h, cartesian_terms(W, h, courant_.data()), gamma_);
      const Pack divergence = courant_[0] * h[0].velocity[0] + courant_[1] * h[1].velocity[1];
      half.pressure = half.pressure + (gamma_ * tile_.pressure) * (load(share + k) * divergence);
      const auto jump = [&](int direction, FaceData what, std::size_t step) {
        const double* f = face_plane(direction, what) + k;
        return (0.5 * courant_[static_cast<std::size_t>(direction)]) * (load(f + step) - load(f));
      };
      const Pack ax = jump(0, normal_stress, 1) + jump(1, tangential_stress, s),
                 ay = jump(0, tangential_stress, 1) + jump(1, normal_stress, s);
      half.velocity[0] = half.velocity[0] + inverse * ax;
      half.velocity[1] = half.velocity[1] + inverse * ay;
      if (horizontal_max(select(pure, broadcast(1.0), Pack{})) > 0) {
        State checked = half;
        HalfSlopes<2, Pack> slopes = h;
        ensure_positive_faces(W, checked, slopes);
        keep_where(~pure, half, checked);
        for (std::size_t d = 0; d < 2; ++d) keep_where(~pure, h[d], slopes[d]);
      }
      rows::store_primitive<2>(plane(west) + k, plane_, half - h[0]);
      rows::store_primitive<2>(plane(east) + k, plane_, half + h[0]);
      rows::store_primitive<2>(plane(south) + k, plane_, half - h[1]);
      rows::store_primitive<2>(plane(north) + k, plane_, half + h[1]);
    }
  }

  template <int direction>
  MORTISE_INLINE MixtureSide<Pack> side(const State& W, std::size_t k) const {
    const auto at = [&](FaceData what) { return load(face_plane(direction, what) + k); };
    MixtureSide<Pack> S;
    const Pack solid = at(solid_mass);
    S.density = max(W.density + solid, 0.1 * solid + 1e-200);
    S.normal = W.velocity[direction];
    S.tangential = W.velocity[1 - direction];
    S.pressure = W.pressure - at(normal_stress);
    S.energy = (1 / (gamma_ - 1)) * W.pressure + at(solid_energy) +
               (0.5 * S.density) * (S.normal * S.normal + S.tangential * S.tangential);
    S.speed = sqrt((gamma_ * max(W.pressure - at(solid_pressure), Pack{}) + at(normal_stiffness)) / S.density);
    return S;
  }

  template <int direction>
  void fluxes(int j) const {
    const std::size_t back = direction == 0 ? 1 : static_cast<std::size_t>(stride_);
    double* const F = plane(flux + 4 * direction);
    for (int i = 0; i < shape_.cells[0] + (direction == 0 ? 1 : 0); i += simd_width) {
      const std::size_t k = shape_.at(i, j);
      const State before = rows::load_primitive<2>(plane(direction == 0 ? east : north) + k - back, plane_);
      const State after = rows::load_primitive<2>(plane(direction == 0 ? west : south) + k, plane_);
      const MixtureFlux<Pack> f = mixture_flux(side<direction>(before, k), side<direction>(after, k),
                                               load(face_plane(direction, tangential_stress) + k),
                                               load(face_plane(direction, tangential_stiffness) + k));
      store(F + k, f.mass);
      store(F + k + plane_, direction == 0 ? f.normal : f.tangential);
      store(F + k + 2 * plane_, direction == 0 ? f.tangential : f.normal);
      store(F + k + 3 * plane_, f.energy);
    }
  }

  Pack update(int j, Pack good) const {
    const std::size_t s = static_cast<std::size_t>(stride_);
    for (int i = 0; i < shape_.cells[0]; i += simd_width) {
      const std::size_t k = shape_.at(i, j);
      const PackMask cells = lanes_below(shape_.cells[0] - i);
      for (std::size_t c = 0; c < 4; ++c) {
        const double *const F = plane(flux) + c * plane_ + k, *const G = plane(flux + 4) + c * plane_ + k;
        const Pack now = load(tile_.cells.now + c * plane_ + k);
        const Pack next = now - (courant_[0] * (load(F + 1) - load(F)) + courant_[1] * (load(G + s) - load(G)));
        store(tile_.cells.next + c * plane_ + k, next);
        const Pack bound = broadcast(std::numeric_limits<double>::max());
        PackMask fine = (next <= bound) & (next >= -bound);
        if (c == 0) fine = fine & (next > 0);
        good = select(fine | ~cells, good, Pack{});
      }
    }
    return good;
  }

  MixtureTile tile_;
  TileShape<2> shape_;
  std::ptrdiff_t stride_;
  std::size_t plane_;
  double gamma_;
  std::array<double, 2> courant_;
  Primitive<2> floor_;
  double* memory_;
};

}  // namespace

StepResult mixture_step(const MixtureTile& tile, double dt, const StepOptions& options) {
  return with_limiter(options.limiter,
                      [&]<Limiter limiter>() { return MixtureKernel<limiter>(tile, dt, options).run(); });
}

void compose(const TileShape<2>& shape, const std::array<double, 2>& spacing, std::span<const TileBody> bodies,
             double blur, TileBlock& composition) {
  for (int c = 0; c < composition::count; ++c) std::fill_n(composition.component(c), shape.plane, 0.0);
  const std::ptrdiff_t s = shape.stride;
  const double x_step = 0.5 / spacing[0], y_step = 0.5 / spacing[1], inverse_width = 1 / blur;
  for (const TileBody& body : bodies) {
    const Maps map = maps_of(*body.map);
    for (int j = 0; j < shape.cells[1]; ++j)
      for (int i = 0; i < shape.cells[0]; ++i) {
        const std::size_t k = shape.at(i, j);
        if (!(map.phi[k] < blur) || !holds(map.layer + k, s)) continue;
        const double *x = map.x + k, *y = map.y + k;
        const MapGradient<double> G = {x_step * (x[1] - x[-1]), y_step * (x[s] - x[-s]), x_step * (y[1] - y[-1]),
                                       y_step * (y[s] - y[-s])};
        if (!(G.determinant() > 0)) continue;
        const SolidPoint<double> p = solid_point(*body.law, G);
        const double share = solid_share(map.phi[k], inverse_width);
        composition.component(composition::mass)[k] += share * p.density;
        composition.component(composition::energy)[k] += share * p.energy;
        composition.component(composition::share)[k] += share;
        composition.component(composition::stiffness)[k] += share * std::max(p.normal_x, p.normal_y);
      }
  }
}

StepResult mixture_rate(const MixtureTile& tile, const StepOptions& options, double& restored) {
  constexpr double least = 1e-3;  // pressure of gas beside a solid, part of p̃_e
  const TileShape<2>& shape = *tile.cells.shape;
  const double gamma = options.gamma;
  StepResult result;
  double* const U = tile.cells.next;
  for (int j = 0; j < shape.cells[1]; ++j)
    for (int i = 0; i < shape.cells[0]; ++i) {
      const std::size_t k = shape.at(i, j);
      const double density = U[k], u = U[k + shape.plane] / density, v = U[k + 2 * shape.plane] / density;
      double& energy = U[k + 3 * shape.plane];
      const double share = tile.composition->component(composition::share)[k],
                   of_gas = std::max(1 - share, 0.0) * tile.pressure;
      const double rest =
          energy - 0.5 * density * (u * u + v * v) - tile.composition->component(composition::energy)[k];
      double p = (gamma - 1) * rest - share * tile.pressure;
      if (share > 0 && of_gas > 0 && p < least * of_gas) {
        energy += (least * of_gas - p) / (gamma - 1);
        restored += (least * of_gas - p) / (gamma - 1);
        p = least * of_gas;
      }
      if (share > 0) p = std::max(p, 0.0);
      const double c = std::sqrt((gamma * p + tile.composition->component(composition::stiffness)[k]) / density);
      const double rate = (std::fabs(u) + c) / tile.cells.spacing[0] + (std::fabs(v) + c) / tile.cells.spacing[1];
      const bool good = density > 0 && (share > 0 || p > 0) && std::isfinite(rate);
      result.admissible = result.admissible && good;
      result.rate = std::max(result.rate, good ? rate : std::numeric_limits<double>::infinity());
    }
  return result;
}

}  // namespace mortise
