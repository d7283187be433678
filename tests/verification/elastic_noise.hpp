// An elastic solid and gas in a closed tube, disturbed by noise: what stays, and what grows.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "mortise/cases/driver/totals.hpp"
#include "verification/case_runner.hpp"

namespace mortise::testing {

/// 16 cells of gas and as many of solid, z_s/z_f given; the gas ends at a wall, the back of the solid is free.
class NoisyTube {
 public:
  NoisyTube(double impedances, double amplitude, const Overrides& more = {})
      : scene_(build_scene<2>(read_case("elastic_piston", overrides(impedances) + more, MORTISE_SOURCE_DIR "/cases"))) {
    SimulationSetup<2>& setup = scene_.setup;
    const Noise u(amplitude, 1), p(amplitude, 2), v(amplitude, 3);
    setup.initial = [gas = setup.initial, u, p](const Point<2>& x, double t) {
      Primitive<2> W = gas(x, t);
      W.velocity[0] += u(x);
      W.pressure *= 1 + p(x);
      return W;
    };
    setup.solids.at(0).initial = [solid = setup.solids.at(0).initial, v](const Point<2>& X, double t) {
      ElasticState state = solid(X, t);
      state[0] += v(X);
      return state;
    };
    simulation_ = std::make_unique<Simulation<2>>(Communicator(), setup);
    simulation_->initialize();
  }

  double step() { return simulation_->advance(1e9); }
  const Simulation<2>& simulation() const { return *simulation_; }

  InterfaceState interface() const { return simulation_->interfaces().at(0); }
  double wall_speed() const {
    double fastest = 0;
    for (const Point<2>& v : interface().node_velocities) fastest = std::max(fastest, v.norm());
    return fastest;
  }

 private:
  static constexpr double gas_impedance = 0.1, cells = 16;  // ρ c of the case

  static Overrides overrides(double impedances) {
    return {set("grid.factor", cells / 10), "exact=none",
            "boundaries.right=wall",        "time.end=1e9",
            "solids.0.sides.back=free",     set("solid.scale", impedances * gas_impedance / std::sqrt(3.0))};
  }

  /// One number for every layer of cells, |x| < 1.
  class Noise {
   public:
    Noise(double amplitude, unsigned seed) {
      std::mt19937 random(seed);
      std::uniform_real_distribution<double> value(-amplitude, amplitude);
      for (double& one : values_) one = value(random);
    }
    double operator()(const Point<2>& x) const {
      return values_[std::min<std::size_t>(static_cast<std::size_t>(std::abs(x.x()) * cells), values_.size() - 1)];
    }

   private:
    std::array<double, static_cast<std::size_t>(cells)> values_{};
  };

  Scene<2> scene_;
  std::unique_ptr<Simulation<2>> simulation_;
};

}  // namespace mortise::testing
