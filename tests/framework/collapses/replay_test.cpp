#include <foredraw/collapses/replay.h>

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <limits>

namespace foredraw::replay_test {
namespace {

/// Two triangles that share an edge, and a third beside them: 0 1 2, 2 1 3, 2 3 4.
const testing::TestMesh strip{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}}, {0, 1, 2, 2, 1, 3, 2, 3, 4}};

CollapseSequence good() {
  return {.collapses = {{0, 1, 0.5f, 0.1f}, {4, 3, 0, 0.2f}},
          .pairs = {{0, 1}, {4, 3}},
          .first_pair = {0, 1, 2},
          .places = {0.5f, 0, 0, 1, 1, 0}};
}

std::string mistake(const CollapseSequence& sequence, std::span<const std::uint32_t> part = {}) {
  return replay(sequence, strip.positions, strip.indices, part).mistake;
}

TEST(Replay, CountsWhatIsLeft) {
  const Replay run = replay(good(), strip.positions, strip.indices);
  EXPECT_EQ(run.mistake, "");
  EXPECT_EQ(run.triangles, (std::vector<std::uint32_t>{3, 2, 1}));
}

TEST(Replay, NoneIsFullDetailToTheBit) {
  const Collapsed full = collapsed(good(), 0, strip.positions, strip.indices);
  EXPECT_EQ(full.indices, strip.indices);
  EXPECT_EQ(full.places, strip.positions);
}

/// Whichever two of the corners it are, as vertices or by their places.
TEST(Replay, TrianglesOfTwoPointsAreNotThere) {
  testing::TestMesh mesh = strip;
  mesh.positions.push_back(mesh.positions[0]);
  mesh.indices.insert(mesh.indices.end(), {0, 0, 1, 1, 0, 0, 0, 1, 0, 5, 0, 1, 1, 5, 0, 0, 1, 5});
  const Replay run = replay(good(), mesh.positions, mesh.indices);
  EXPECT_EQ(run.mistake, "");
  EXPECT_EQ(run.triangles, (std::vector<std::uint32_t>{3, 2, 1}));
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_EQ(collapsed(good(), n, mesh.positions, mesh.indices).indices,
              collapsed(good(), n, strip.positions, strip.indices).indices);
  }
}

TEST(Replay, CornersTakeTheVertexThatStandsForThem) {
  const Collapsed one = collapsed(good(), 1, strip.positions, strip.indices);
  EXPECT_EQ(one.indices, (std::vector<std::uint32_t>{2, 1, 3, 2, 3, 4}));
  EXPECT_EQ(one.origin, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(one.places[1], glm::vec3(0.5f, 0, 0));
  const Collapsed two = collapsed(good(), 2, strip.positions, strip.indices);
  EXPECT_EQ(two.indices, (std::vector<std::uint32_t>{2, 1, 3}));
  EXPECT_EQ(two.vertex[4], 3u);
}

TEST(Replay, RefusesWhatDoesNotRun) {
  const auto with = [](const auto& change) {
    CollapseSequence sequence = good();
    change(sequence);
    return mistake(sequence);
  };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(with([](auto& s) { s.collapses[0].removed = 9; }), "");
  EXPECT_NE(with([](auto& s) { s.collapses[0].kept = 0; }), "");
  EXPECT_NE(with([](auto& s) { s.collapses[1].kept = 0; }), "");       // gone
  EXPECT_NE(with([](auto& s) { s.collapses[1].error = 0.05f; }), "");  // falls
  EXPECT_NE(with([&](auto& s) { s.collapses[1].error = nan; }), "");
  EXPECT_NE(with([&](auto& s) { s.collapses[1].blend = nan; }), "");
  EXPECT_NE(with([](auto& s) { s.collapses[1].blend = 1.5f; }), "");
  EXPECT_NE(with([&](auto& s) { s.places[4] = nan; }), "");
  EXPECT_NE(with([](auto& s) { s.places.pop_back(); }), "");
  EXPECT_NE(with([](auto& s) { s.first_pair = {0, 2, 1}; }), "");
  EXPECT_NE(with([](auto& s) { s.first_pair = {0, 2}; }), "");
  EXPECT_NE(with([](auto& s) { s.first_pair.clear(); }), "");
  EXPECT_NE(with([](auto& s) { s.pairs[0].removed = 3; }), "");
  EXPECT_NE(with([](auto& s) { s.pairs[0].kept = 99; }), "");
  EXPECT_EQ(mistake({.first_pair = {0}}), "");
  CollapseSequence unpaired{.collapses = {{3, 4, 0, 0}}, .first_pair = {0, 0}};
  EXPECT_EQ(mistake(unpaired), "collapse 0 leaves a corner without a vertex");
  EXPECT_NE(mistake(good(), std::vector<std::uint32_t>{0, 1, 1, 1, 1}), "");
}

/// The same triangles carried from point to point: what a damaged file may ask for.
TEST(Replay, GivesUpWhereOnePointGathersAll) {
  testing::TestMesh fan;
  CollapseSequence sequence{.first_pair = {0}};
  constexpr std::uint32_t points = 3000;
  for (std::uint32_t i = 0; i < points; ++i) {
    fan.positions.push_back(glm::vec3(i, 0, 0));
    fan.positions.push_back(glm::vec3(i, 1, 0));
    fan.positions.push_back(glm::vec3(i, 2, 0));
    fan.indices.insert(fan.indices.end(), {3 * i, 3 * i + 1, 3 * i + 2});
    if (i == 0) continue;
    sequence.collapses.push_back({3 * (i - 1), 3 * i, 0, 0});
    sequence.pairs.push_back({3 * (i - 1), 3 * i});
    sequence.first_pair.push_back(i);
  }
  EXPECT_NE(replay(sequence, fan.positions, fan.indices).mistake, "");
}

}  // namespace
}  // namespace foredraw::replay_test
