#include "mortise/cases/study/noise.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace mortise {
namespace {

using std::numbers::pi;
constexpr int waves_of_noise = 32;

/// In [−1, 1]; the standard fixes the numbers of the engine, but not those of its distributions.
double random_number(std::mt19937& engine) { return 2 * (static_cast<double>(engine()) / 4294967295.0) - 1; }

}  // namespace

template <int Dim>
Noise<Dim>::Noise(unsigned seed, double spacing, bool along_x) : along_x_(along_x) {
  std::mt19937 engine(seed);
  for (std::vector<PlaneWave>& waves : waves_)
    for (int k = 0; k < waves_of_noise; ++k) {
      PlaneWave& wave = waves.emplace_back();
      for (int d = 0; d < (along_x ? 1 : Dim); ++d) wave.number[d] = pi / spacing * random_number(engine);
      wave.phase = pi * random_number(engine);
    }
}

template <int Dim>
double Noise<Dim>::sum(const std::vector<PlaneWave>& waves, const Point<Dim>& x) {
  double sum = 0;
  for (const PlaneWave& wave : waves) sum += std::sin(wave.number.dot(x) + wave.phase);
  return sum / std::sqrt(0.5 * waves_of_noise);
}

template <int Dim>
Point<Dim> Noise<Dim>::vector(const Point<Dim>& x) const {
  Point<Dim> v = Point<Dim>::Zero();
  for (int d = 0; d < (along_x_ ? 1 : Dim); ++d) v[d] = sum(waves_[static_cast<std::size_t>(1 + d)], x);
  return v;
}

template <int Dim>
void disturb(SimulationSetup<Dim>& setup, double spacing, bool along_x, double amplitude, unsigned seed) {
  auto noise = [spacing, along_x, number = 16 * seed]() mutable { return Noise<Dim>(number++, spacing, along_x); };
  setup.initial = [initial = setup.initial, of_gas = noise(), amplitude, gamma = setup.fluid.gas.gamma](
                      const Point<Dim>& x, double t) {
    Primitive<Dim> W = initial(x, t);
    const Point<Dim> u = amplitude * std::sqrt(gamma * W.pressure / W.density) * of_gas.vector(x);
    for (std::size_t d = 0; d < Dim; ++d) W.velocity[d] += u[static_cast<int>(d)];
    W.pressure *= 1 + amplitude * gamma * of_gas.scalar(x);
    return W;
  };
  if constexpr (Dim == 2)
    for (SolidSetup& solid : setup.solids)
      solid.initial = [initial = solid.initial, of_solid = noise(),
                       speed = amplitude * solid.elastic.options.material.pressure_wave_speed()](const Point<2>& X,
                                                                                                 double t) {
        ElasticState state = initial(X, t);
        const Point<2> v = speed * of_solid.vector(X);
        state[0] += v[0];
        state[1] += v[1];
        return state;
      };
}

template class Noise<1>;
template class Noise<2>;
template void disturb<1>(SimulationSetup<1>&, double, bool, double, unsigned);
template void disturb<2>(SimulationSetup<2>&, double, bool, double, unsigned);

}  // namespace mortise
