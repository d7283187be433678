#include "mortise/cases/input/case_file.hpp"

#include <cstdlib>

#include "unit/cases/input/scratch_case.hpp"

namespace mortise {
namespace {

using test::plane_case, test::read_text, test::Scratch;

const std::string cases_root = MORTISE_SOURCE_DIR "/cases";

std::string error_of_case(const std::string& name) {
  try {
    read_case(name, {}, cases_root);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CaseFile, ReadsEverythingInAPlaneCase) {
  const CaseDescription c =
      read_text(plane_case + "motion = {x = \"t\"}\nangle = 30\n[output]\nframes = 3\npictures = [\"mach\"]\n");
  EXPECT_EQ(c.name, "scratch");
  EXPECT_EQ(c.title, "a cylinder");
  EXPECT_EQ(c.output, "output/scratch");
  EXPECT_EQ(c.grid_factor, 4);
  EXPECT_DOUBLE_EQ(c.spacing(), 0.025);
  EXPECT_EQ(c.domain_high[1], 1);
  EXPECT_EQ(c.cfl, 0.8);
  EXPECT_EQ(c.limiter, "mc");
  EXPECT_EQ(c.initial.left[3], 1);
  EXPECT_EQ(c.bodies[0].motion_x, "t");
  EXPECT_EQ(c.bodies[0].angle, 30);
  EXPECT_EQ(c.frames, 3);
  EXPECT_EQ(c.pictures, std::vector<std::string>{"mach"});
}

TEST(CaseFile, KeepsTextAndOverrides) {
  const CaseDescription c = read_text(plane_case, {"fluid.limiter=none", "time.end=0.25"});
  EXPECT_EQ(c.text, plane_case + "# --set fluid.limiter=none\n# --set time.end=0.25\n");
  EXPECT_EQ(c.limiter, "none");
  EXPECT_EQ(c.time_end, 0.25);
}

TEST(CaseFile, UnknownCase) {
  const std::string error = error_of_case("shock_rigid_stick");
  EXPECT_EQ(error.rfind("there is no case \"shock_rigid_stick\", did you mean \"shock_rigid_sticks\"? (known: ", 0), 0u)
      << error;
  EXPECT_EQ(error_of_case("some/where.toml"), "there is no case file \"some/where.toml\"");
}

TEST(CaseFile, NamesFoldersAndPaths) {
  EXPECT_EQ(read_case("sod", {}, cases_root).name, "sod");
  EXPECT_EQ(read_case(cases_root + "/sod/case.toml", {}, "nowhere").name, "sod");
  EXPECT_EQ(read_case(cases_root + "/sod/", {}, "nowhere").name, "sod");
  EXPECT_EQ(read_case("sod", {}, cases_root).folder, cases_root + "/sod");
}

TEST(CaseFile, ReadingWritesNothing) {
  const Scratch scratch;
  const std::string path = scratch.write("one.toml", plane_case);
  read_case(path, {}, "nowhere");
  EXPECT_THROW(read_case(path, {"time.cfl=2"}, "nowhere"), InputError);
  int files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(scratch.folder())) ++files;
  EXPECT_EQ(files, 1);
}

TEST(CaseFile, DescribesEveryKeyOnce) {
  const std::string text = describe_keys();
  for (const char* key : {"title\n", "time.cfl\n", "bodies.N.density\n", "bodies.N.motion.x\n",
                          "initial.regions.N.where\n", "probes.N.name\n"})
    EXPECT_NE(text.find(key), std::string::npos) << key;
  EXPECT_NE(text.find("a number in (0, 1]; default 0.9"), std::string::npos);
  EXPECT_NE(text.find("time.end\n    time at which the run ends\n    a number > 0; required\n"), std::string::npos);
  EXPECT_EQ(text.find("\ntime.cfl\n"), text.rfind("\ntime.cfl\n"));
}

class ShippedCase : public testing::TestWithParam<std::string> {};

TEST_P(ShippedCase, ReadsAndSaysWhatItShows) {
  const CaseDescription c = read_case(GetParam(), {}, cases_root);
  EXPECT_EQ(c.name, GetParam());
  EXPECT_NE(c.title, c.name);
  EXPECT_FALSE(c.reference.empty());
  EXPECT_TRUE(std::filesystem::exists(c.folder + "/README.md"));
}

TEST_P(ShippedCase, CommentsEveryKey) {
  std::ifstream file(read_case(GetParam(), {}, cases_root).path);
  std::string line;
  while (std::getline(file, line)) {
    if (line.find('=') != std::string::npos) {
      EXPECT_NE(line.find(" # "), std::string::npos) << line;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShippedCase, testing::ValuesIn(case_names(cases_root)),
                         [](const auto& instance) { return instance.param; });

TEST(ShippedCases, AreAllThere) {
  const std::vector<std::string> names = case_names(cases_root);
  for (const char* name :
       {"shock_rigid_sticks", "massless_ellipse", "many_cylinders", "rigid_piston", "sod", "free_stream"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
}

TEST(ShippedCases, VariantsOfTheirReadmes) {
  const auto reads = [](const std::string& name, const std::vector<std::string>& overrides) {
    return read_case(name, overrides, cases_root);
  };
  EXPECT_EQ(reads("shock_rigid_sticks", {"bodies.0.density=0"}).bodies[0].density, 0.0);
  EXPECT_NEAR(reads("shock_rigid_sticks", {}).inflow[1], 1.25, 1e-14);
  EXPECT_EQ(reads("massless_ellipse", {"bodies.0.density=1", "scheme=traditional"}).scheme, "traditional");
  EXPECT_THROW(reads("massless_ellipse", {"scheme=traditional"}), InputError);
  const CaseDescription smooth =
      reads("rigid_piston",
            {"bodies.0.shape=slab", "bodies.0.width=0.2", "bodies.0.mass=0.5",
             "bodies.0.force.x=t < 1 ? 0.5*sin(pi*t)^4 : 0", "initial.left=[1,0,1]", "initial.right=[1,0,1]"});
  EXPECT_EQ(smooth.bodies[0].width, 0.2);
  EXPECT_EQ(smooth.initial.right[3], 1.0);
  EXPECT_EQ(reads("rigid_piston", {"bodies.0.motion.x=-t^4/4"}).bodies[0].force_x, "");
  EXPECT_EQ(reads("shock_on_massless_body", {"bodies.0.mass=1e9", "exact=none"}).exact, "");
  EXPECT_EQ(reads("weak_shock_on_free_cylinder", {"bodies.0.density=14"}).bodies[0].density, 14.0);
}

}  // namespace
}  // namespace mortise
