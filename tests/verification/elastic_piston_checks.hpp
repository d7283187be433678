// Maximum errors of the smoothly receding elastic piston, and their orders.
#pragma once

#include <gtest/gtest.h>

#include "verification/case_runner.hpp"

namespace mortise::testing {

using Errors = std::map<std::string, double>;

inline const std::vector<std::string> along_fields = {"fluid.density",      "fluid.velocity_x", "fluid.temperature",
                                                      "solid.displacement", "solid.velocity",   "solid.stress"};
inline const std::vector<std::string> turned_fields = {"fluid.density",     "fluid.velocity_x",   "fluid.velocity_y",
                                                       "fluid.temperature", "solid.displacement", "solid.velocity",
                                                       "solid.stress"};

/// The strip in the plane, its normal at `angle` degrees, with exact data at its ends.
inline Overrides strip(double angle, double width) {
  const std::string half = std::to_string(0.5 * width);
  return {"dimension=2",
          set("grid.angle", angle),
          "grid.low=[-" + half + ",0]",
          "grid.high=[" + half + ",1]",
          "initial.state=[0.1,0,0,0.07142857142857142]",
          "boundaries={left=\"exact\", right=\"exact\", top=\"exact\"}",
          "solids.0.sides={left=\"exact\", right=\"exact\", back=\"exact\"}"};
}

inline Errors errors_of(const Overrides& overrides, double factor, const std::vector<std::string>& names) {
  CaseRun<2> run("elastic_piston", overrides + Overrides{set("grid.factor", factor)});
  EXPECT_TRUE(run.run().finished()) << run.reason();
  const auto all = run.errors();
  Errors largest;
  for (const std::string& name : names) largest[name] = all.at(name).max;
  return largest;
}

/// Mean order between two grids; returns the errors on the finer one.
inline Errors expect_order(const Overrides& overrides, double coarse, double fine, double least,
                           const std::vector<std::string>& names) {
  const Errors before = errors_of(overrides, coarse, names), after = errors_of(overrides, fine, names);
  for (const auto& [name, error] : after)
    EXPECT_GE(std::log(before.at(name) / error) / std::log(fine / coarse), least) << name << " " << error;
  return after;
}

}  // namespace mortise::testing
