// Whole scenes packed: lattices that parts share, boxes over poses, what can not be packed, and what moves on.
#include "plugins/processors/vertex_pack/packed_boxes.h"

#include "support/other_units.h"
#include "support/packed_scenes.h"

#include <foredraw/packing/packed_precision.h>
#include <foredraw/viewing/pose_set.h>
#include <foredraw/viewing/posed_positions.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>

namespace foredraw::vertex_pack_scene_test {
namespace {

using testing::framed_scene;
using ::testing::HasSubstr;
using testing::notes_of;
using testing::packed;
using testing::packed_of;

bool is_outside(const PackedLayout& layout, const glm::vec3& position) {
  foredraw_packed_vertex vertex{{position.x, position.y, position.z}, {0, 0, 1}, {1, 0, 0, 1}, {0, 0}};
  std::uint32_t row[4];
  return (foredraw_packed_encode(&layout, &vertex, row) & FOREDRAW_PACKED_POSITION_OUTSIDE) != 0;
}

bool same_positions(const PackedLayout& a, const PackedLayout& b) {
  return std::equal(a.origin, a.origin + 3, b.origin) && a.step == b.step &&
         std::memcmp(a.field, b.field, sizeof a.field) == 0;
}

TEST(VertexPackScene, EveryVertexOfEveryLevelKeepsThePromise) {
  const Scene scene = packed(framed_scene());
  ASSERT_EQ(packed_of(scene).draws.size(), 2u);
  for (const PackedVertices::OfDraw& draw : packed_of(scene).draws) {
    ASSERT_EQ(draw.rows.size(), scene.draws[draw.draw].levels.size());
    EXPECT_FALSE(draw.posed);
    for (std::size_t l = 0; l < draw.rows.size(); ++l) {
      const VertexStreams& vertices = *scene.draws[draw.draw].levels[l].vertices;
      EXPECT_EQ(broken_promise(vertices, draw.layout, draw.rows[l].view()), "");
      const PackedErrors errors = packed_errors(vertices, draw.layout, draw.rows[l].view());
      EXPECT_GT(errors.most.position + errors.most.normal, 0);
      EXPECT_EQ(errors.handedness, 0u);
    }
  }
}

/// The same figure by other means: the promise is broken by one wrong bit of a row, wherever it is.
TEST(VertexPackScene, AWrongRowBreaksThePromise) {
  const Scene scene = packed(framed_scene());
  const PackedVertices::OfDraw& ball = packed_of(scene).draws[0];
  const VertexStreams& vertices = *scene.draws[0].full().vertices;
  std::vector<std::uint32_t> rows(ball.rows[0].view().begin(), ball.rows[0].view().end());
  for (std::uint32_t f = 0; f < FOREDRAW_PACKED_FIELDS; ++f) {
    const foredraw_packed_field& field = ball.layout.field[f];
    const std::uint32_t high = field.bits > 3 ? 3 : 0;
    rows[4 * 100 + field.word] ^= 1u << (field.shift + high);
    EXPECT_NE(broken_promise(vertices, ball.layout, rows), "") << f;
    rows[4 * 100 + field.word] ^= 1u << (field.shift + high);
  }
  EXPECT_EQ(broken_promise(vertices, ball.layout, rows), "");
  rows.pop_back();
  EXPECT_THAT(broken_promise(vertices, ball.layout, rows), HasSubstr("four words for each vertex"));
}

/// Two draws of a mesh meet in a plane: what was at one place is at one place.
TEST(VertexPackScene, PartsOfAMeshStayJoined) {
  testing::TestMesh ball = testing::sphere(40, 20), upper = ball, lower = ball;
  const std::size_t half = ball.indices.size() / 6 * 3;
  upper.indices.resize(half);
  lower.indices.erase(lower.indices.begin(), lower.indices.begin() + static_cast<std::ptrdiff_t>(half));
  for (std::size_t v = 0; v < ball.positions.size(); ++v) {
    const float height = ball.positions[v].z;
    upper.positions[v].z += height > 0.05f ? 1.0f : 0.0f;
    lower.positions[v].z -= height < -0.05f ? 1.0f : 0.0f;
  }
  Scene scene = testing::scene_of({testing::framed(testing::draw_of(upper)), testing::framed(testing::draw_of(lower))});
  scene.meshes = {{"ball", {0, 1}, {}}};
  scene.nodes.resize(1);
  scene.nodes[0].mesh = 0;
  const Scene after = packed(scene);
  const auto& draws = packed_of(after).draws;
  ASSERT_EQ(draws.size(), 2u);
  EXPECT_TRUE(same_positions(draws[0].layout, draws[1].layout));
  std::size_t met = 0;
  for (std::size_t v = 0; v < ball.positions.size(); ++v) {
    if (upper.positions[v] != lower.positions[v]) continue;
    ++met;
    const foredraw_packed_vertex a = testing::unpacked_vertex(draws[0], v), b = testing::unpacked_vertex(draws[1], v);
    EXPECT_EQ(std::memcmp(a.position, b.position, sizeof a.position), 0);
  }
  EXPECT_GE(met, 40u);
}

/// At seams of the helmet and of a character: equal positions and normals come out equal, whatever else differs.
TEST(VertexPackScene, DuplicatesAtSeamsComeOutEqual) {
  for (const char* file : {"static/flight_helmet_notex.glb", "animated/mannequiny.glb"}) {
    Diagnostics diagnostics;
    const auto scene = read_gltf(testing::project_file(std::string("benchmarks/corpus/") + file), diagnostics);
    ASSERT_TRUE(scene);
    const Scene after = packed(*scene, "(poses=bind)");
    std::size_t duplicates = 0;
    for (const PackedVertices::OfDraw& draw : packed_of(after).draws) {
      const VertexStreams& vertices = *scene->draws[draw.draw].full().vertices;
      const auto positions = decode_vec3(*vertices.find("POSITION")), normals = decode_vec3(*vertices.find("NORMAL"));
      std::map<std::array<float, 6>, std::size_t> first;
      for (std::size_t v = 0; v < vertices.count; ++v) {
        const glm::vec3 &p = positions[v], &n = normals[v];
        const auto [known, is_new] = first.try_emplace({p.x, p.y, p.z, n.x, n.y, n.z}, v);
        if (is_new) continue;
        ++duplicates;
        const auto a = testing::unpacked_vertex(draw, v), b = testing::unpacked_vertex(draw, known->second);
        EXPECT_EQ(std::memcmp(a.position, b.position, sizeof a.position), 0);
        EXPECT_EQ(std::memcmp(a.normal, b.normal, sizeof a.normal), 0);
      }
    }
    EXPECT_GT(duplicates, 500u) << file;
  }
}

/// The tube bends out of its own box; no pose between the keys leaves the posed one.
TEST(VertexPackScene, ThePosedBoxHoldsWhatAnimationsMakeOfIt) {
  const Scene scene = packed(testing::BendingTube().scene(3));
  const PackedVertices::OfDraw& tube = packed_of(scene).draws[0];
  ASSERT_TRUE(tube.posed);
  std::size_t out_of_own = 0;
  for (int i = 0; i <= 100; ++i) {
    const PosedNodes nodes = posed_nodes(scene, {.clip = 0, .time = i / 100.0});
    for (const glm::vec3& position : posed_positions(scene, {0, 0}, nodes)) {
      EXPECT_FALSE(is_outside(*tube.posed, position)) << i;
      out_of_own += is_outside(tube.layout, position) ? 1 : 0;
    }
  }
  EXPECT_GT(out_of_own, 1000u);
  const double diagonal = 3 * std::sqrt(4.0 + 121 + 169);
  EXPECT_LE(packed_bounds(*tube.posed).position, 2.2e-6 * diagonal);
}

TEST(VertexPackScene, ThePosedBoxHoldsAllWeightsOfMorphTargets) {
  Scene scene = framed_scene();
  scene.draws.resize(1);
  scene.draws[0].levels.resize(1);
  scene.meshes.resize(1);
  scene.nodes.clear();
  VertexStreams streams = *scene.draws[0].full().vertices;
  const std::vector<glm::vec3> up(streams.count, glm::vec3(0, 0, 7)), aside(streams.count, glm::vec3(-3, 2, 0));
  streams.morph_targets = {{testing::float_stream("POSITION", up)}, {testing::float_stream("POSITION", aside)}};
  scene.draws[0].full().vertices = std::make_shared<const VertexStreams>(streams);
  const Result result = testing::run("vertex-pack", scene);
  const PackedVertices::OfDraw& ball = packed_of(result.scene).draws[0];
  ASSERT_TRUE(ball.posed);
  for (const glm::vec3& position : decode_vec3(*streams.find("POSITION"))) {
    for (const float a : {0.0f, 0.5f, 1.0f}) {
      for (const float b : {0.0f, 1.0f}) EXPECT_FALSE(is_outside(*ball.posed, position + a * up[0] + b * aside[0]));
    }
  }
  EXPECT_THAT(notes_of(result),
              HasSubstr("stays-plain: not packed, and still read from its own streams: morph targets"));
}

/// Of what a stage may not touch the box counts too: packed one after the other, draws share a lattice.
TEST(VertexPackScene, StagesForSomeDrawsAgreeOnTheLattice) {
  Scene scene = framed_scene();
  scene.meshes = {{"both", {0, 1}, {}}};
  scene.nodes.resize(1);
  scene.nodes[0].mesh = 0;
  Diagnostics diagnostics;
  Registry registry;
  add_built_in_plugins(registry);
  const auto pipeline = parse_file(
      "pipeline = 1\nstages = [{ use = \"vertex-pack\", only = \"plate\" }, "
      "{ use = \"vertex-pack\", only = \"ball\" }]",
      "test", diagnostics);
  ASSERT_TRUE(pipeline) << to_text(diagnostics);
  const auto planned = plan(*pipeline, registry, scene, diagnostics);
  ASSERT_TRUE(planned) << to_text(diagnostics);
  Analyses analyses;
  const Executor executor(2);
  const Scene apart = optimize(*planned, scene, {executor, analyses}).scene;
  EXPECT_EQ(packed_of(apart), packed_of(packed(scene)));
}

struct Odd {
  const char* name;
  std::function<void(Level&)> make;
  const char* why;
};

void put_vec2(Level& level, std::size_t vertex, const glm::vec2& uv) {
  std::vector<glm::vec2> uvs;
  for (const glm::vec3& old : decode_vec3(*level.vertices->find("TEXCOORD_0"))) uvs.emplace_back(old.x, old.y);
  uvs[vertex] = uv;
  testing::put_streams(level, {testing::float_stream("TEXCOORD_0", uvs)});
}

void put_position(Level& level, std::size_t vertex, float x) {
  auto positions = decode_vec3(*level.vertices->find("POSITION"));
  positions[vertex].x = x;
  testing::put_streams(level, {testing::float_stream("POSITION", positions)});
}

/// Says why, and packs the other draw as if this one were not there.
TEST(VertexPackScene, WhatCanNotBeHeldIsNotPacked) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  const Odd odd[] = {
      {"position NaN", [&](Level& level) { put_position(level, 3, nan); }, "it has a position that is not finite"},
      {"position inf", [&](Level& level) { put_position(level, 3, infinite); }, "it has a position that is not finite"},
      {"uv NaN",
       [&](Level& level) {
         put_vec2(level, 3, {nan, 0});
       },
       "it has a texture coordinate that is not finite"},
      {"uv 1e30",
       [&](Level& level) {
         put_vec2(level, 3, {1e30f, 0});
       },
       "its texture coordinates are too large"},
      {"uv tiled",
       [&](Level& level) {
         put_vec2(level, 3, {2000, 0});
       },
       "its texture coordinates are too far apart"}};
  for (const Odd& one : odd) {
    Scene scene = framed_scene();
    one.make(scene.draws[1].full());
    const Result result = testing::run("vertex-pack", scene);
    ASSERT_EQ(packed_of(result.scene).draws.size(), 1u) << one.name;
    EXPECT_EQ(packed_of(result.scene).draws[0], packed_of(packed(framed_scene())).draws[0]) << one.name;
    EXPECT_THAT(notes_of(result), HasSubstr(std::string("not-packed: ") + one.why)) << one.name;
  }
}

TEST(VertexPackScene, TextureCoordinatesOutsideOf0To1AreHeldWhereBitsSuffice) {
  Scene scene = framed_scene();
  put_vec2(scene.draws[1].full(), 3, {-1.25f, 2.5f});
  const Scene after = packed(scene);
  ASSERT_EQ(packed_of(after).draws.size(), 2u);
  const foredraw_packed_vertex vertex = testing::unpacked_vertex(packed_of(after).draws[1], 3);
  EXPECT_NEAR(vertex.uv[0], -1.25f, 3e-5f);
  EXPECT_NEAR(vertex.uv[1], 2.5f, 3e-5f);
}

TEST(VertexPackScene, TextureCoordinatesInOtherUnitsAreHeldAsWell) {
  const Scene plain = framed_scene();
  const Scene whole = testing::in_other_units(plain, {.set = 0, .scale = glm::dvec2(0x1p-12)});
  EXPECT_EQ(packed_uv_widths(plain, 1), 1);
  EXPECT_EQ(packed_uv_widths(whole, 1), 0x1p-12);
  const auto bound = [](const Scene& scene) {
    const Result result = testing::run("vertex-pack", scene);
    EXPECT_EQ(packed_of(result.scene).draws.size(), 2u) << notes_of(result);
    return result.report.draws[1].after.metrics.find("vertex-pack", "uv-bound")->value();
  };
  EXPECT_GT(bound(plain), 0);
  EXPECT_NEAR(bound(whole) / bound(plain), 1, 1e-6);
}

TEST(VertexPackScene, NormalsOfNoLengthArePackedAndTold) {
  Scene scene = framed_scene();
  std::vector<glm::vec3> normals = decode_vec3(*scene.draws[1].full().vertices->find("NORMAL"));
  normals[5] = glm::vec3(0);
  normals[6].y = std::numeric_limits<float>::quiet_NaN();
  testing::put_streams(scene.draws[1].full(), {testing::float_stream("NORMAL", normals)});
  const Result result = testing::run("vertex-pack", scene);
  EXPECT_EQ(packed_of(result.scene).draws.size(), 2u);
  EXPECT_THAT(
      notes_of(result),
      HasSubstr("no-direction: vertices whose normal or tangent has no direction, so that a default is packed: 2\n"));
}

/// Tangents along the normal, of no handedness and of no length come out as directions at a right angle to it.
TEST(VertexPackScene, TangentsThatAreNoneComeOutAsSome) {
  Scene scene = framed_scene();
  const std::vector<glm::vec3> normals = decode_vec3(*scene.draws[1].full().vertices->find("NORMAL"));
  std::vector<glm::vec4> tangents;
  for (std::size_t v = 0; v < normals.size(); ++v)
    tangents.emplace_back(v % 2 == 0 ? normals[v] : glm::vec3(0), v % 3 == 0 ? 0.0f : 1.0f);
  testing::put_streams(scene.draws[1].full(), {testing::float_stream("TANGENT", tangents)});
  const Result result = testing::run("vertex-pack", scene);
  ASSERT_FALSE(result.failed);
  ASSERT_EQ(packed_of(result.scene).draws.size(), 2u);
  const PackedVertices::OfDraw& plate = packed_of(result.scene).draws[1];
  for (std::size_t v = 0; v < normals.size(); ++v) {
    foredraw_packed_vertex vertex;
    foredraw_packed_decode(&plate.layout, &plate.rows[0].view()[4 * v], &vertex);
    const glm::vec3 tangent(vertex.tangent[0], vertex.tangent[1], vertex.tangent[2]);
    EXPECT_NEAR(glm::dot(tangent, tangent), 1, 1e-5);
    EXPECT_NEAR(glm::dot(tangent, normals[v]), 0, 2e-3);
    EXPECT_EQ(std::abs(vertex.tangent[3]), 1);
  }
}

TEST(VertexPackScene, IsTheSameAtAnyNumberOfThreads) {
  const Scene scene = testing::BendingTube().scene();
  const std::vector<Subject> subjects = subjects_of(scene);
  const auto groups = processors::vertex_pack::posed_groups(scene, subjects);
  const Poses poses = make_poses(scene, {.rate = 30});
  const Box<glm::dvec3> one = processors::vertex_pack::posed_boxes(scene, groups, poses, Executor(1)).at(0);
  const Box<glm::dvec3> many = processors::vertex_pack::posed_boxes(scene, groups, poses, Executor(5)).at(0);
  EXPECT_EQ(one.min, many.min);
  EXPECT_EQ(one.max, many.max);
}

TEST(VertexPackScene, ThePapersAnglesAreAMethod) {
  const Scene octahedral = packed(framed_scene()), spherical = packed(framed_scene(), "(method=spherical)");
  const PackedVertices::OfDraw &a = packed_of(octahedral).draws[0], &b = packed_of(spherical).draws[0];
  EXPECT_EQ(a.layout.is_spherical, 0u);
  EXPECT_EQ(b.layout.is_spherical, 1u);
  EXPECT_EQ(broken_promise(*spherical.draws[0].full().vertices, b.layout, b.rows[0].view()), "");
}

}  // namespace
}  // namespace foredraw::vertex_pack_scene_test
