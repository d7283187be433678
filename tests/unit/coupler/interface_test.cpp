#include "mortise/coupler/interface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "mortise/grids/core/error.hpp"
#include "unit/coupler/interface_scene.hpp"

namespace mortise {
namespace {

using Pieces = std::vector<Transfer::Piece>;

/// Shares of all faces sum to 1, and pieces have the same length seen from both sides.
void expect_consistent(const Transfer& transfer, const std::vector<double>& s, const std::vector<double>& f) {
  std::vector<double> of_structure(s.size() - 1), of_fluid(f.size() - 1);
  const double range = std::abs(s.back() - s.front());
  for (const Transfer::Piece& piece : transfer.pieces()) {
    const auto i = std::size_t(piece.structure), b = std::size_t(piece.fluid);
    of_structure[i] += piece.of_structure;
    of_fluid[b] += piece.of_fluid;
    EXPECT_NEAR(piece.of_structure * std::abs(s[i + 1] - s[i]), piece.of_fluid * std::abs(f[b + 1] - f[b]),
                3e-10 * range);
    EXPECT_GT(piece.of_structure, 0);
  }
  for (const double sum : of_structure) EXPECT_NEAR(sum, 1, 1e-15);
  for (const double sum : of_fluid) EXPECT_NEAR(sum, 1, 1e-15);
}

std::vector<double> random_nodes(std::mt19937& random, int faces, double start, double length) {
  std::uniform_real_distribution<double> step(0.2, 1);
  std::vector<double> nodes = {0};
  for (int i = 0; i < faces; ++i) nodes.push_back(nodes.back() + step(random));
  const double all = nodes.back();
  for (double& node : nodes) node = start + length * (node / all);
  return nodes;
}

TEST(Transfer, DividesFacesAtTheNodesOfBothSides) {
  const std::vector<double> s = {0, 1, 2, 4}, f = {0, 1.5, 4};
  const Transfer transfer(s, f, false);
  const Pieces expected = {{0, 0, 1, 2.0 / 3}, {1, 0, 0.5, 1.0 / 3}, {1, 1, 0.5, 0.2}, {2, 1, 1, 0.8}};
  ASSERT_EQ(transfer.pieces().size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_EQ(transfer.pieces()[k].structure, expected[k].structure);
    EXPECT_EQ(transfer.pieces()[k].fluid, expected[k].fluid);
    EXPECT_NEAR(transfer.pieces()[k].of_structure, expected[k].of_structure, 1e-15);
    EXPECT_NEAR(transfer.pieces()[k].of_fluid, expected[k].of_fluid, 1e-15);
  }
  EXPECT_FALSE(transfer.matching());
  EXPECT_EQ(transfer.structure_faces(), 3);
  EXPECT_EQ(transfer.fluid_faces(), 2);
}

TEST(Transfer, IsConsistentForAnyDivisionDirectionAndStart) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 400; ++trial) {
    const bool periodic = trial & 1;
    const double start = periodic ? 7.3 * (trial % 11) - 30 : -1.5;
    auto s = random_nodes(random, 1 + trial % 13, -1.5, 2.7), f = random_nodes(random, 1 + trial % 17, start, 2.7);
    if (trial & 2) std::reverse(s.begin(), s.end());
    if (trial & 4) std::reverse(f.begin(), f.end());
    SCOPED_TRACE(trial);
    expect_consistent(Transfer(s, f, periodic), s, f);
  }
}

TEST(Transfer, MatchingFacesHaveOnePieceWithSharesOfExactlyOne) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-3e-11, 3e-11);
  for (int trial = 0; trial < 200; ++trial) {
    const bool periodic = trial & 1, turned = trial & 2;
    const int faces = 3 + trial % 40, first = periodic ? trial % faces : 0;
    const auto s = random_nodes(random, faces, 0.1, 5.1);
    // The fluid's division starts at node `first` of the structure's, some turns away.
    std::vector<double> f;
    for (int i = first; i <= first + faces; ++i)
      f.push_back(s[std::size_t(i % faces)] + 5.1 * (i / faces + (periodic ? trial % 5 - 2 : 0)));
    for (std::size_t i = 1; i + 1 < f.size(); ++i) f[i] += noise(random);
    if (turned) std::reverse(f.begin(), f.end());
    const Transfer transfer(s, f, periodic);
    SCOPED_TRACE(trial);
    EXPECT_TRUE(transfer.matching());
    ASSERT_EQ(transfer.pieces().size(), std::size_t(faces));
    for (const Transfer::Piece& piece : transfer.pieces()) {
      EXPECT_EQ(piece.of_structure, 1);
      EXPECT_EQ(piece.of_fluid, 1);
      EXPECT_EQ(piece.structure, ((turned ? faces - 1 - piece.fluid : piece.fluid) + first) % faces);
    }
  }
}

TEST(Transfer, OneFaceAgainstMany) {
  const std::vector<double> one = {0, 1}, many = testing::even_nodes(7, 1);
  const Transfer transfer(one, many, false);
  EXPECT_EQ(transfer.pieces().size(), 7u);
  for (const Transfer::Piece& piece : transfer.pieces()) {
    EXPECT_EQ(piece.of_fluid, 1);
    EXPECT_NEAR(piece.of_structure, 1.0 / 7, 1e-15);
  }
}

TEST(Transfer, RefusesDivisionsOfDifferentCurves) {
  const std::vector<double> s = {0, 1, 2}, longer = {0, 1, 2.1}, elsewhere = {1, 2, 3}, folded = {0, 1.5, 1, 2},
                            none = {0};
  EXPECT_THROW(Transfer(s, longer, false), InputError);
  EXPECT_THROW(Transfer(s, longer, true), InputError);
  EXPECT_THROW(Transfer(s, elsewhere, false), InputError);
  EXPECT_NO_THROW(Transfer(s, elsewhere, true));
  EXPECT_THROW(Transfer(s, folded, false), InputError);
  EXPECT_THROW(Transfer(none, s, false), InputError);
}

}  // namespace
}  // namespace mortise
