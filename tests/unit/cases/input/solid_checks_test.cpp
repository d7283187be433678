#include "mortise/cases/input/solid_checks.hpp"

#include <gtest/gtest.h>

#include "unit/cases/input/scratch_case.hpp"

namespace mortise {
namespace {

using test::error_of, test::read_text, test::with;

const std::string material = "[solids.material]\ndensity = 2\nlambda = 3\nmu = 4\n";
const std::string gas =
    "[time]\nend = 0.5\n"
    "[initial]\nkind = \"uniform\"\nstate = [1, 0, 0, 0.75]\n";

/// A soft disk in a gas.
const std::string disk = "[grid]\nfactor = 4\nlow = [-1, -1]\nhigh = [1, 1]\n" + gas +
                         "[[solids]]\nshape = \"circle\"\nradius = 0.3\nposition = [0.1, 0.2]\n" + material;

/// Gas beside a strip, on a line.
const std::string strip = "dimension = 1\n[grid]\nkind = \"layer\"\nfactor = 4\nlow = 0\nhigh = 1\n" +
                          with(gas, "[1, 0, 0, 0.75]", "[1, 0, 0.75]") +
                          "[[solids]]\nshape = \"strip\"\nthickness = 0.5\n" + material;

/// Gas in an elastic annulus, on one ring.
const std::string ring = "[grid]\nkind = \"layer\"\nfactor = 4\ninner_radius = 0.25\nouter_radius = 0.5\n" + gas +
                         "[[solids]]\nshape = \"annulus\"\ninner_radius = 0.5\nouter_radius = 1\ngas = \"inside\"\n" +
                         material;

/// A solid alone.
const std::string plate =
    "[grid]\nfactor = 4\n[time]\nend = 1\n[[solids]]\nshape = \"plate\"\nlow = [0, 0]\nhigh = [1, 1]\n" + material;

std::string after(const std::string& message, const std::string& place) {
  EXPECT_EQ(message.rfind(place + ": ", 0), 0u) << message;
  return message.substr(std::min(message.size(), place.size() + 2));
}

/// The sentence for one --set, without the place.
std::string error_with(const std::string& text, const std::string& assignment) {
  return after(error_of(text, {assignment}), "--set " + assignment);
}

TEST(SolidChecks, DefaultsOfAnImmersedSolid) {
  const CaseDescription c = read_text(disk);
  ASSERT_EQ(c.solids.size(), 1u);
  EXPECT_EQ(c.scheme, "projection");
  EXPECT_EQ(c.solids[0].name, "circle_0");
  EXPECT_EQ(c.solids[0].gas, "outside");
  EXPECT_EQ(c.solids[0].material.law, "neo_hookean");
  EXPECT_EQ(c.solids[0].initial.kind, "rest");
  EXPECT_EQ(c.solid.limiter, "mc");
  EXPECT_EQ(c.coupling.reference_pressure, 0.75);
  EXPECT_EQ(c.coupling.load, "current");
  EXPECT_TRUE(c.has_gas);
  EXPECT_EQ(read_text(disk, {"fluid.limiter=none"}).solid.limiter, "none");
  EXPECT_EQ(read_text(disk, {"coupling.reference_pressure=0.5"}).coupling.reference_pressure, 0.5);
}

TEST(SolidChecks, ReferencePressureIsThatAheadOfTheShock) {
  const std::string shock =
      with(disk, "kind = \"uniform\"\nstate", "kind = \"shock\"\nmach = 2\nposition = -0.8\nahead");
  EXPECT_EQ(read_text(shock).coupling.reference_pressure, 0.75);
  const std::string riemann = with(disk, "kind = \"uniform\"\nstate = [1, 0, 0, 0.75]",
                                   "kind = \"riemann\"\nleft = [1, 0, 0, 1]\nright = [1, 0, 0, 2]");
  EXPECT_NE(error_of(riemann).find("the key \"coupling.reference_pressure\" is missing"), std::string::npos);
}

TEST(SolidChecks, ScaleMultipliesDensityAndModuli) {
  const MaterialDescription m = read_text(disk, {"solid.scale=0.1"}).solids[0].material;
  EXPECT_DOUBLE_EQ(m.density, 0.2);
  EXPECT_DOUBLE_EQ(m.lambda, 0.3);
  EXPECT_DOUBLE_EQ(m.mu, 0.4);
}

TEST(SolidChecks, Material) {
  EXPECT_EQ(error_with(disk, "solids.0.material.mu=0"), "solids.0.material.mu = 0 is not allowed: it must be > 0");
  EXPECT_EQ(error_with(disk, "solids.0.material.density=-1"),
            "solids.0.material.density = -1 is not allowed: it must be > 0");
  EXPECT_EQ(error_with(disk, "solids.0.material.lambda=-5"),
            "solids.0.material.lambda = -5 is not allowed: λ + μ must be > 0, so λ > -4");
  EXPECT_EQ(error_with(disk, "solids.0.material.law=neohookean"),
            "solids.0.material.law = \"neohookean\" is not known, did you mean \"neo_hookean\"? (allowed: linear, "
            "saint_venant_kirchhoff, neo_hookean)");
  EXPECT_NE(error_of(with(disk, "mu = 4\n", "")).find("the key \"solids.0.material.mu\" is missing"),
            std::string::npos);
}

TEST(SolidChecks, InterfacesNeedAScheme) {
  for (const char* scheme : {"projection", "traditional", "traditional-subiterated", "anti-traditional"})
    EXPECT_EQ(error_of(disk, {std::string("scheme=") + scheme}), "");
  for (const std::string scheme : {"none", "rigid"})
    EXPECT_EQ(error_with(disk, "scheme=" + scheme),
              "scheme = \"" + scheme +
                  "\" leaves the interface of solids.0 (circle_0) without a scheme: use projection, traditional, "
                  "traditional-subiterated, anti-traditional, reference-map");
  EXPECT_EQ(read_text(plate).scheme, "none");
  EXPECT_EQ(
      error_with(plate, "scheme=projection"),
      "scheme = \"projection\" needs an elastic solid in gas and the case has none: use none, or omit the scheme");
}

TEST(SolidChecks, RigidAndElasticTogether) {
  const CaseDescription c =
      read_text(disk + "[[bodies]]\nshape = \"circle\"\nradius = 0.1\nposition = [0, -0.5]\ndensity = 0\n");
  EXPECT_EQ(c.scheme, "projection");
  EXPECT_EQ(c.bodies.size(), 1u);
  EXPECT_NE(error_of(disk + "[[bodies]]\nshape = \"circle\"\nradius = 0.1\ndensity = 1\nname = \"circle_1\"\n")
                .find("solids.0.name = \"circle_1\" is the name of another one, too"),
            std::string::npos);
}

TEST(SolidChecks, ShapesTakeTheirKeys) {
  EXPECT_NE(
      error_of(disk, {"solids.0.thickness=1"})
          .find("\"solids.0.thickness\" does not belong to shape = \"circle\" (which takes radius, position, angle)"),
      std::string::npos);
  EXPECT_NE(error_of(with(disk, "radius = 0.3\n", "")).find("the key \"solids.0.radius\" is missing"),
            std::string::npos);
  EXPECT_EQ(error_with(disk, "solids.0.gas=inside"),
            "solids.0.gas = \"inside\" is not there for shape = \"circle\" (allowed: outside, none)");
  EXPECT_EQ(error_with(ring, "solids.0.outer_radius=0.5"),
            "solids.0.outer_radius = 0.5 must be greater than inner_radius = 0.5");
  EXPECT_EQ(error_with(plate, "solids.0.hole=0.7"), "solids.0.hole = 0.7 around (0, 0) reaches outside the plate");
}

TEST(SolidChecks, Sides) {
  EXPECT_EQ(error_with(disk, "solids.0.sides.outer=fixed"),
            "solids.0.sides.outer is not a side of this solid: all of its surface is an interface");
  EXPECT_EQ(error_with(ring, "solids.0.traction.inner=1"),
            "solids.0.traction.inner is not a side of this solid: it has outer");
  EXPECT_EQ(error_with(plate, "solids.0.sides.left=periodic"),
            "solids.0.sides: opposite sides must be periodic both or neither");
  EXPECT_EQ(error_with(ring, "solids.0.sides.outer=exact")
                .rfind("solids.0.sides.outer = \"exact\" needs an exact solution that knows the solid", 0),
            0u);
  EXPECT_NE(error_of(ring, {"solids.0.sides.outer=free", "solids.0.traction.outer=t"}).find("are both given"),
            std::string::npos);
  const CaseDescription c = read_text(strip);
  EXPECT_EQ(c.solids[0].left.kind, "periodic");
  EXPECT_EQ(c.solids[0].back.kind, "free");
}

TEST(SolidChecks, BoundariesOfGasAndSolidCoincide) {
  EXPECT_EQ(error_of(strip), "");
  EXPECT_EQ(error_of(ring), "");
  EXPECT_EQ(
      error_with(strip, "grid.low=0.1"),
      "grid.low starts the gas at 0.1 along the normal, but the wall of solids.0 (strip_0) is at 0: the boundaries "
      "of gas and solid must coincide");
  EXPECT_EQ(
      error_with(ring, "grid.outer_radius=0.6"),
      "grid.outer_radius = 0.6 is not solids.0.inner_radius = 0.5: the boundaries of gas and solid must coincide");
  const std::string hole = with(with(ring, "kind = \"layer\"\n", ""), "inner_radius = 0.25\nouter_radius = 0.5\n",
                                "low = [-0.6, -0.6]\nhigh = [0.6, 0.6]\n");
  EXPECT_EQ(error_of(hole), "");
  EXPECT_EQ(
      error_with(hole, "grid.high=[0.6, 0.4]").rfind("grid.low … grid.high does not contain the gas of radius 0.5", 0),
      0u);
}

TEST(SolidChecks, AnInterfaceBelongsToOneSolid) {
  const std::string two =
      ring + "[[solids]]\nshape = \"annulus\"\ninner_radius = 0.5\nouter_radius = 0.8\ngas = \"inside\"\n" + material;
  EXPECT_NE(
      error_of(two).find("solids.1 (annulus_1) and solids.0 (annulus_0) would share one interface with the gas: an "
                         "interface belongs to one solid"),
      std::string::npos);
}

TEST(SolidChecks, LayersNeedAStripOrAnnulus) {
  EXPECT_NE(error_of(disk, {"grid.kind=layer"}).find("grid.kind = \"layer\" needs one solid: a strip, or an annulus"),
            std::string::npos);
  EXPECT_NE(error_of(strip, {"grid.kind=overlapping"}).find("solids.0 is a strip, which needs grid.kind = \"layer\""),
            std::string::npos);
  EXPECT_EQ(error_with(ring, "boundaries.left=wall"), "boundaries.left is not there: the gas is a ring");
}

TEST(SolidChecks, InitialState) {
  const std::string wave = plate + "[solids.initial]\nkind = \"plane_wave\"\namplitude = 0.1\n";
  EXPECT_EQ(error_of(wave), "");
  EXPECT_EQ(
      error_with(wave, "solids.0.initial.amplitude=1"),
      "solids.0.initial.amplitude = 1 is not allowed: J = 1 − amplitude would be 0 behind the front, it must be > 0");
  EXPECT_NE(error_of(plate, {"solids.0.initial.kind=exact"}).find("needs an exact solution that knows the solid"),
            std::string::npos);
}

TEST(SolidChecks, SolidsAloneNeedNoGas) {
  const CaseDescription c = read_text(plate);
  EXPECT_FALSE(c.has_gas);
  EXPECT_EQ(c.solids[0].material.law, "linear");
  EXPECT_NE(error_of(disk + "[[solids]]\nshape = \"plate\"\nlow = [0, 0]\nhigh = [1, 1]\n" + material)
                .find("solids.1 (plate_1) has gas = \"none\", but there is gas in the scene"),
            std::string::npos);
  EXPECT_NE(error_of(with(disk, "low = [-1, -1]\n", "")).find("the key \"grid.low\" is missing"), std::string::npos);
}

TEST(SolidChecks, ExactSolutionsNeedTheirSolid) {
  EXPECT_NE(error_of(disk, {"exact=elastic_piston"})
                .find("exact = \"elastic_piston\" needs one elastic solid with shape = strip"),
            std::string::npos);
  EXPECT_NE(error_of(strip, {"exact=elastic_piston", "solids.0.material.law=neo_hookean"})
                .find("needs material.law = linear, not neo_hookean"),
            std::string::npos);
}

TEST(SolidChecks, PicturesHaveSomethingToShow) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(read_text(plate).pictures, Names{"stress"});
  EXPECT_EQ(read_text(disk).pictures, Names{"schlieren"});
  EXPECT_EQ(read_text(disk, {"output.pictures=[\"stress\"]"}).pictures, Names{"stress"});
  EXPECT_EQ(error_with(plate, "output.pictures=[\"pressure\"]"),
            "the picture \"pressure\" of output.pictures needs gas; allowed without: stress, velocity, grids");
  EXPECT_EQ(error_with(test::plane_case, "output.pictures=[\"stress\"]"),
            "the picture \"stress\" of output.pictures needs an elastic solid");
}

}  // namespace
}  // namespace mortise
