// What is found to be long and thin, and what is not, held against meshes of which it is known.
#include "plugins/processors/wire_radius/wire_radius.h"

#include "benchmarks/wire_radius/wire_scores.h"

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace foredraw::wire_radius_test {
namespace {

using bench::KnownMesh;

FoundWires found_in(const KnownMesh& mesh, const WireOptions& options = {}) {
  return find_wires(mesh.positions, mesh.indices, options);
}

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

KnownMesh made(const std::string& name, std::uint64_t seed = 201) {
  for (KnownMesh& mesh : bench::made_meshes(seed)) {
    if (mesh.name == name) return std::move(mesh);
  }
  throw std::invalid_argument(name);
}

/// Triangles of wires have wire vertices alone, one of which moves; those of others have none that moves.
void expect_sound(const KnownMesh& mesh, const FoundWires& found) {
  ASSERT_EQ(found.wire_of.size(), mesh.indices.size() / 3);
  ASSERT_EQ(found.half_width.size(), mesh.positions.size());
  std::set<std::uint32_t> used;
  for (std::size_t t = 0; t < found.wire_of.size(); ++t) {
    bool all = true, moves = false;
    for (std::size_t i = 3 * t; i < 3 * t + 3; ++i) {
      const float half = found.half_width[mesh.indices[i]];
      all &= half != 0;
      moves |= half > 0;
    }
    const bool is_wire = found.wire_of[t] != FoundWires::none;
    ASSERT_EQ(is_wire, is_wire ? all && moves : moves) << mesh.name << ", triangle " << t;
    if (is_wire) used.insert(found.wire_of[t]);
  }
  ASSERT_EQ(used.size(), found.wires.size()) << mesh.name;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const auto finite = [](const glm::vec3& a) {
      return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
    };
    ASSERT_TRUE(finite(found.to_centre[v]) && finite(found.axis[v]) && std::isfinite(found.half_width[v]));
    if (found.half_width[v] == 0) {
      ASSERT_EQ(found.to_centre[v], glm::vec3(0));
    }
  }
}

TEST(WireRadius, FindsMadeWiresWithTheirCentreAndRadius) {
  bench::WireScore all;
  for (const std::uint64_t seed : {201, 202, 203}) {
    for (const KnownMesh& mesh : bench::made_meshes(seed)) {
      const FoundWires found = found_in(mesh);
      expect_sound(mesh, found);
      const bench::WireScore of = bench::score(mesh, found);
      EXPECT_GE(of.recall(), 0.95) << seed << ' ' << mesh.name;
      EXPECT_GE(of.precision(), 0.9) << seed << ' ' << mesh.name;
      all.add(of);
    }
  }
  EXPECT_GE(all.recall(), 0.98);
  EXPECT_GE(all.precision(), 0.99);
  EXPECT_LE(median(all.centre_error), 0.05);
  EXPECT_LE(median(all.radius_error), 0.01);
}

/// By hand, and by length. Models outside the repository's corpus are left out.
TEST(WireRadius, FindsWhatPeopleCallWires) {
  const std::filesystem::path root = FOREDRAW_SOURCE_DIR;
  bench::WireScore all;
  for (const KnownMesh& mesh :
       bench::labelled_meshes(root / "benchmarks/wire_radius/labels.tsv", root / "benchmarks/corpus")) {
    const FoundWires found = found_in(mesh);
    expect_sound(mesh, found);
    all.add(bench::score(mesh, found));
  }
  EXPECT_GT(all.known, 1000);
  EXPECT_GE(all.recall(), 0.95);
  EXPECT_GE(all.precision(), 0.95);
}

TEST(WireRadius, LeavesAloneWhatIsNoWire) {
  for (const char* name : {"road marking", "plank", "bumper", "sword", "finger", "sail hem", "bar 5:1:1", "fat ring",
                           "egg", "blade of grass"}) {
    EXPECT_TRUE(found_in(made(name)).wires.empty()) << name;
  }
}

TEST(WireRadius, SaysWhyNot) {
  const auto says = [](const FoundWires& found, WireRefusal why) {
    return std::ranges::any_of(found.refused, [&](const RefusedWire& refused) { return refused.why == why; });
  };
  EXPECT_TRUE(says(found_in(made("bar 5:1:1"), {.slender = 6}), WireRefusal::stout));
  EXPECT_TRUE(says(found_in(made("plank"), {.aspect = 3.5}), WireRefusal::flat));
  EXPECT_TRUE(says(found_in(made("road marking")), WireRefusal::decal));
  EXPECT_TRUE(says(found_in(made("flat rope"), {.ribbons = false}), WireRefusal::ribbon));
  EXPECT_TRUE(says(found_in(made("catenary"), {.least_length = 100}), WireRefusal::small));
}

TEST(WireRadius, OptionsMoveTheBounds) {
  EXPECT_EQ(found_in(made("bar 5:1:1"), {.slender = 4}).wires.size(), 1u);
  EXPECT_EQ(found_in(made("plank"), {.aspect = 8}).wires.size(), 1u);
  EXPECT_EQ(found_in(made("road marking"), {.decal = 0}).wires.size(), 1u);
  EXPECT_TRUE(found_in(made("net"), {.ribbons = false}).wires.empty());
}

TEST(WireRadius, RingsAreClosed) {
  const FoundWires found = found_in(made("ring"));
  ASSERT_EQ(found.wires.size(), 1u);
  EXPECT_TRUE(found.wires[0].closed);
  EXPECT_NEAR(found.wires[0].length, 6.28, 0.1);
}

/// What the post is welded to stays where it is, and so do the corners that it shares with the post.
TEST(WireRadius, JointsStay) {
  const KnownMesh mesh = made("lamp post");
  const FoundWires found = found_in(mesh);
  ASSERT_EQ(found.wires.size(), 1u);
  std::size_t joints = 0, moved = 0;
  for (std::size_t v = 0; v < mesh.half_width.size(); ++v) {
    joints += found.half_width[v] < 0;
    moved += found.half_width[v] > 0;
    if (mesh.half_width[v] > 0) {
      EXPECT_GT(found.half_width[v], 0) << "one of the two rings between the ends";
    }
    if (mesh.positions[v].y < 0.5f || mesh.positions[v].y > 5.5f) {
      EXPECT_EQ(found.half_width[v], 0) << "foot or head";
    }
  }
  EXPECT_GT(joints, 0u);
  EXPECT_GT(moved, 0u);
}

/// Where ribbons cross, a vertex is on the borders of two: each of its triangles knows its own ribbon's centre line.
TEST(WireRadius, RibbonsOfANetEachHaveTheirCentreLine) {
  const KnownMesh mesh = made("net");
  const FoundWires found = found_in(mesh);
  ASSERT_FALSE(found.copies.empty());
  ASSERT_TRUE(std::ranges::is_sorted(found.corners, {}, &FoundWires::Corner::index));
  std::vector<glm::vec3> axis, to_centre;
  for (const std::uint32_t v : mesh.indices) {
    axis.push_back(found.axis[v]);
    to_centre.push_back(found.to_centre[v]);
  }
  for (const FoundWires::Corner& corner : found.corners) {
    const FoundWires::Copy& copy = found.copies[corner.copy];
    EXPECT_EQ(copy.vertex, mesh.indices[corner.index]);
    EXPECT_GT(copy.half_width, 0);
    axis[corner.index] = copy.axis;
    to_centre[corner.index] = copy.to_centre;
  }
  std::size_t along = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    ASSERT_EQ(found.wire_of[i / 3], 0u);
    glm::vec3 longest(0);
    for (std::size_t e = 0; e < 3; ++e) {
      const glm::vec3 edge = mesh.positions[mesh.indices[i + (e + 1) % 3]] - mesh.positions[mesh.indices[i + e]];
      if (glm::length(edge) > glm::length(longest)) longest = edge;
    }
    if (glm::length(longest) < 0.2f) continue;  // a crossing
    ++along;
    for (std::size_t c = i; c < i + 3; ++c) {
      EXPECT_GT(std::abs(glm::dot(axis[c], glm::normalize(longest))), 0.99f);
      EXPECT_LT(std::abs(glm::dot(to_centre[c], glm::normalize(longest))), 0.2f * glm::length(to_centre[c]));
    }
  }
  EXPECT_GT(along, mesh.indices.size() / 6);
}

/// Of ribbons two quads broad, whose ends are pointed where they meet, as in the rigging of ships: each knows its own
/// line, and not what is square to its ends.
TEST(WireRadius, RibbonsOfANetWithPointedEndsKnowTheirLines) {
  constexpr float half = 0.02f;
  constexpr int nodes = 6;
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
  const auto add = [&](const glm::vec3& at) {
    positions.push_back(at);
    return static_cast<std::uint32_t>(positions.size() - 1);
  };
  const auto ribbon = [&](const glm::vec3& from, const glm::vec3& to) {
    const glm::vec3 along = half * glm::normalize(to - from), aside(-along.y, along.x, 0);
    const std::uint32_t a = add(from), b = add(to);
    for (const float side : {-1.0f, 1.0f}) {
      const std::uint32_t c = add(from + along + side * aside), d = add(to - along + side * aside);
      for (const std::uint32_t v : {a, c, d}) indices.push_back(v);
      for (const std::uint32_t v : {a, d, b}) indices.push_back(v);
    }
  };
  for (int i = 0; i < nodes; ++i) {
    for (int k = 0; k + 1 < nodes; ++k) {
      const auto x = static_cast<float>(k), y = static_cast<float>(i);
      ribbon({x, y, 0}, {x + 1, y, 0});
      ribbon({y, x, 0}, {y, x + 1, 0});
    }
  }
  const FoundWires found = find_wires(positions, indices);
  ASSERT_EQ(found.wires.size(), 1u);
  EXPECT_EQ(found.wires[0].kind, WireKind::net);
  EXPECT_NEAR(found.wires[0].radius, half, 0.1f * half);
  std::vector<FoundWires::Copy> of_corner;
  for (const std::uint32_t v : indices)
    of_corner.push_back({v, found.to_centre[v], found.axis[v], found.half_width[v]});
  for (const FoundWires::Corner& corner : found.corners) of_corner[corner.index] = found.copies[corner.copy];
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const bool is_level = (i / 12) % 2 == 0;
    const FoundWires::Copy& of = of_corner[i];
    const glm::vec3 centre = positions[indices[i]] + of.to_centre;
    EXPECT_GT(std::abs(is_level ? of.axis.x : of.axis.y), 0.999f) << i;
    EXPECT_NEAR(of.half_width, half, 0.01f * half) << i;
    const float line = is_level ? centre.y : centre.x;
    EXPECT_NEAR(line, std::round(line), 0.01f * half) << i;
  }
}

TEST(WireRadius, FixedTrianglesHoldWhatTheyJoin) {
  const KnownMesh mesh = made("catenary");
  const std::size_t triangles = mesh.indices.size() / 3;
  KnownMesh longer = mesh;
  longer.indices.insert(longer.indices.end(), {0, 1, static_cast<std::uint32_t>(mesh.positions.size())});
  longer.positions.push_back(mesh.positions[0] + glm::vec3(0, 5, 0));
  const FoundWires found = find_wires(longer.positions, longer.indices, {}, {}, triangles);
  ASSERT_EQ(found.wires.size(), 1u);
  EXPECT_EQ(found.wire_of.back(), FoundWires::none);
  EXPECT_LT(found.half_width[0], 0);
  EXPECT_LT(found.half_width[1], 0);
}

/// Neither the unit nor where it stands matters.
TEST(WireRadius, IsTheSameAtEveryScale) {
  const KnownMesh mesh = made("coil");
  const FoundWires found = found_in(mesh);
  for (const float scale : {0x1p-90f, 0x1p90f}) {
    KnownMesh scaled = mesh;
    for (glm::vec3& at : scaled.positions) at *= scale;
    const FoundWires again = found_in(scaled);
    ASSERT_EQ(again.wires.size(), found.wires.size());
    EXPECT_EQ(again.wire_of, found.wire_of);
    for (std::size_t v = 0; v < found.half_width.size(); ++v)
      ASSERT_EQ(again.half_width[v], found.half_width[v] * scale);
  }
}

TEST(WireRadius, TurnedTrianglesAndSecondSidesDoNotMatter) {
  KnownMesh mesh = made("flat rope");
  const FoundWires found = found_in(mesh);
  const std::size_t count = mesh.indices.size();
  for (std::size_t i = 0; i < count; i += 3) {
    const std::uint32_t corners[] = {mesh.indices[i + 2], mesh.indices[i + 1], mesh.indices[i]};
    mesh.indices.insert(mesh.indices.end(), std::begin(corners), std::end(corners));
    mesh.wire_of.push_back(0);
  }
  const FoundWires again = found_in(mesh);
  ASSERT_EQ(again.wires.size(), 1u);
  EXPECT_EQ(again.half_width, found.half_width);
  expect_sound(mesh, again);
  KnownMesh tube = made("catenary");
  for (std::size_t i = 0; i < tube.indices.size(); i += 3) std::swap(tube.indices[i], tube.indices[i + 1]);
  EXPECT_EQ(found_in(tube).wire_of, found_in(made("catenary")).wire_of) << "inside out";
}

TEST(WireRadius, OfNothingIsNothing) {
  const FoundWires found = find_wires({}, {});
  EXPECT_TRUE(found.wires.empty() && found.wire_of.empty());
}

}  // namespace
}  // namespace foredraw::wire_radius_test
