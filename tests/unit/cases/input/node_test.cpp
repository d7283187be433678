#include "mortise/cases/input/node.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

const std::string sample =
    "word = \"w\"\n"
    "[deep.er]\n"
    "  list = [1, 2.5, [true]]\n"
    "day = 2020-01-02\n";

TEST(Node, FindsByDottedPath) {
  const Node root = parse_toml(sample, "f.toml");
  EXPECT_EQ(root.find("word")->text, "w");
  EXPECT_EQ(root.find("deep.er.list.0")->integer, 1);
  EXPECT_EQ(root.find("deep.er.list.0")->number, 1.0);
  EXPECT_EQ(root.find("deep.er.list.1")->number, 2.5);
  EXPECT_TRUE(root.find("deep.er.list.2.0")->boolean);
  EXPECT_EQ(root.find("deep.er.list.3"), nullptr);
  EXPECT_EQ(root.find("deep.er.list.x"), nullptr);
  EXPECT_EQ(root.find("word.x"), nullptr);
  EXPECT_EQ(root.find(""), &root);
}

TEST(Node, KnowsItsPlace) {
  const Node root = parse_toml(sample, "f.toml");
  EXPECT_EQ(root.place, "f.toml");
  EXPECT_EQ(root.find("word")->place, "f.toml:1:8");
  EXPECT_EQ(root.find("word")->key_place, "f.toml:1:1");
  EXPECT_EQ(root.find("deep.er.list")->key_place, "f.toml:3:3");
  EXPECT_EQ(root.find("deep.er.list.1")->place, "f.toml:3:14");
}

TEST(Node, ShowsValues) {
  const Node root = parse_toml(sample, "f.toml");
  EXPECT_EQ(root.shown(), "a table");
  EXPECT_EQ(root.find("word")->shown(), "\"w\"");
  EXPECT_EQ(root.find("deep.er.list")->shown(), "an array of 3");
  EXPECT_EQ(root.find("deep.er.list.0")->shown(), "1");
  EXPECT_EQ(root.find("deep.er.list.1")->shown(), "2.5");
  EXPECT_EQ(root.find("deep.er.list.2.0")->shown(), "true");
  EXPECT_EQ(root.find("deep.er.day")->shown(), "the date 2020-01-02");
}

TEST(Node, SyntaxErrorHasAPlace) {
  try {
    parse_toml("a = 1\nb = = 2\n", "f.toml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("f.toml:2:5: ", 0), 0u) << error.what();
  }
}

TEST(Node, OverrideValuesAreTomlOrWords) {
  const auto kind = [](const char* text) { return parse_override_value(text, "p").kind; };
  EXPECT_EQ(kind("1"), Node::Kind::integer);
  EXPECT_EQ(kind("1e-3"), Node::Kind::number);
  EXPECT_EQ(kind("false"), Node::Kind::boolean);
  EXPECT_EQ(kind("[1, 2]"), Node::Kind::array);
  EXPECT_EQ(kind("{x = 1}"), Node::Kind::table);
  EXPECT_EQ(parse_override_value("\"quoted\"", "p").text, "quoted");
  EXPECT_EQ(parse_override_value("none", "p").text, "none");
  EXPECT_EQ(parse_override_value("sin(t)", "p").text, "sin(t)");
  EXPECT_EQ(parse_override_value("1\nother = 2", "p").kind, Node::Kind::text);
  EXPECT_EQ(parse_override_value("", "p").text, "");
  const Node array = parse_override_value("[1, 2]", "p");
  EXPECT_TRUE(array.overridden && array.items[1].overridden);
  EXPECT_EQ(array.items[1].place, "p");
}

TEST(Node, RejectPlacesTheNearestTable) {
  const Node root = parse_toml(sample, "f.toml");
  EXPECT_THROW(reject(root, "deep.er.nothing", "s"), InputError);
  try {
    reject(root, "deep.er.nothing.at.all", "sentence");
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), "f.toml:2:1: sentence");
  }
}

RC_GTEST_PROP(Node, ShortestReadsBack, (double value)) {
  RC_PRE(std::isfinite(value));
  RC_ASSERT(std::stod(shortest(value)) == value);
}

}  // namespace
}  // namespace mortise
