#include "mortise/cases/input/overrides.hpp"

#include <gtest/gtest.h>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

Node sample_root() { return parse_toml("title = \"a\"\n[[bodies]]\nposition = [0, 0]\n[[bodies]]\n", "f.toml"); }

std::string error_of_override(const std::string& argument) {
  Node root = sample_root();
  try {
    apply_override(root, argument);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Overrides, ChangeAddAndMakeTables) {
  Node root = sample_root();
  apply_override(root, "title=b=c");
  apply_override(root, "time.end=0.5");
  apply_override(root, "bodies.0.position.1=2.5");
  apply_override(root, "bodies.1.motion.x=sin(t)");
  apply_override(root, "fluid={limiter = \"none\"}");
  EXPECT_EQ(root.find("title")->text, "b=c");
  EXPECT_EQ(root.find("time.end")->number, 0.5);
  EXPECT_EQ(root.find("bodies.0.position.1")->number, 2.5);
  EXPECT_EQ(root.find("bodies.0.position.0")->number, 0.0);
  EXPECT_EQ(root.find("bodies.1.motion.x")->text, "sin(t)");
  EXPECT_EQ(root.find("fluid.limiter")->text, "none");
  EXPECT_EQ(root.find("time.end")->place, "--set time.end=0.5");
  EXPECT_FALSE(root.find("bodies.0.position.0")->overridden);
}

TEST(Overrides, SpacesAroundTheSignDoNotCount) {
  Node root = sample_root();
  apply_override(root, "fluid.limiter = none");
  EXPECT_EQ(root.find("fluid.limiter")->text, "none");
}

TEST(Overrides, TheLastOneCounts) {
  Node root = sample_root();
  apply_override(root, "time.end=1");
  apply_override(root, "time.end=2");
  EXPECT_EQ(root.find("time")->items.size(), 1u);
  EXPECT_EQ(root.find("time.end")->integer, 2);
}

TEST(Overrides, Errors) {
  EXPECT_EQ(error_of_override("bodies.2.density=1"),
            "--set bodies.2.density=1: there is no entry 2 in bodies, whose entries are 0 to 1");
  EXPECT_EQ(error_of_override("bodies.x.density=1"),
            "--set bodies.x.density=1: there is no entry x in bodies, whose entries are 0 to 1");
  EXPECT_EQ(error_of_override("bodies.0.position.2=1"),
            "--set bodies.0.position.2=1: there is no entry 2 in bodies.0.position, whose entries are 0 to 1");
  EXPECT_EQ(error_of_override("probes.0.name=a"),
            "--set probes.0.name=a: there is no array \"probes\" in the case file to take entry 0 of");
  EXPECT_EQ(error_of_override("title.x=1"), "--set title.x=1: title is \"a\" and has no key \"x\"");
  EXPECT_EQ(error_of_override("time.end"), "--set time.end: expected key=value, for example time.end=0.5");
  EXPECT_EQ(error_of_override("=1"), "--set =1: expected key=value, for example time.end=0.5");
  EXPECT_EQ(error_of_override("time..end=1"), "--set time..end=1: the key \"time..end\" has an empty part");
}

}  // namespace
}  // namespace mortise
