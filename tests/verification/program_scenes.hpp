// Small scenes in which a dependence on ranks, on skipping or on a restart would show.
#pragma once

#include "verification/clip.hpp"
#include "verification/program_run.hpp"

namespace mortise::testing {

/// Five sticks hit by a shock, whose grids come to overlap each other, on 18 background tiles; probes in front, in the
/// wake and inside a stick. Writes the case file into the folder and returns the arguments that run it to t = 0.6.
inline Arguments sticks(const ScratchFolder& folder) {
  const std::string probes =
      "\n[[probes]]\nname = \"wake\"\nposition = [0.7, 0.0]\n\n[[probes]]\nname = \"inside\"\nposition = [-0.5, 0.0]\n";
  write_file(folder / "sticks.toml", read_file(MORTISE_SOURCE_DIR "/cases/shock_rigid_sticks/case.toml") + probes);
  return {folder / "sticks.toml",
          "--quiet",
          "--frames",
          "3",
          "--set",
          "grid.factor=4",
          "--set",
          "grid.tile=[30, 20]",
          "--set",
          "time.end=0.6",
          "--set",
          "output.checkpoint_interval=0.1"};
}

/// A piston that moves through several tiles, leaving some and entering others.
inline Arguments piston() {
  return {"rigid_piston",  "--quiet", "--frames",    "4",     "--set",
          "grid.factor=8", "--set",   "grid.tile=8", "--set", "output.checkpoint_interval=0.1"};
}

/// Neo-Hookean sticks on overlapping grids, in space and in every stick, just hit by a shock.
inline Arguments soft_sticks() {
  return {"shock_deformable_sticks",
          "--quiet",
          "--frames",
          "2",
          "--set",
          "grid.factor=5",
          "--set",
          "grid.tile=[20, 20]",
          "--set",
          "initial.position=-0.6",
          "--set",
          "time.end=0.06",
          "--set",
          "output.pictures=[\"schlieren\", \"stress\", \"grids\"]",
          "--set",
          "output.picture_width=300",
          "--set",
          "output.checkpoint_interval=0.02"};
}

/// A linear plate with a hole full of gas, reached by a wave; the plate takes substeps.
inline Arguments hole_in_plate() {
  return {"cylinder_in_solid",
          "--quiet",
          "--frames",
          "2",
          "--set",
          "grid.factor=1.5",
          "--set",
          "time.end=0.6",
          "--set",
          "output.picture_width=300",
          "--set",
          "output.checkpoint_interval=0.2"};
}

/// A soft disk that spins up the fluid around it, on 16 tiles, with a probe in each.
inline Arguments spinning_disk() {
  return {"spinning_disk", "--quiet",
          "--frames",      "2",
          "--set",         "grid.tile=[16, 16]",
          "--set",         "time.end=0.1",
          "--set",         "output.picture_width=300",
          "--set",         "output.checkpoint_interval=0.03",
          "--set",         "probes=[{name=\"inside\", position=[0.25, 0]}, {name=\"outside\", position=[0.6, 0]}]"};
}

/// A body whose parts meet each other, on 16 tiles.
inline Arguments closing_clip() {
  return {"spinning_disk", "--quiet",
          "--frames",      "2",
          "--set",         "grid.tile=[16, 16]",
          "--set",         "time.end=0.4",
          "--set",         "output.picture_width=300",
          "--set",         "output.checkpoint_interval=0.1",
          "--set",         "solids=" + thrown_clip};
}

}  // namespace mortise::testing
