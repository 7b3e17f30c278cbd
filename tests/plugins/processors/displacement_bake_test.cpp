#include "plugins/processors/displacement_bake/displacement_bake.h"

#include "plugins/processors/displacement_bake/height_levels.h"
#include "support/displaced.h"
#include "support/products.h"
#include "support/staged.h"

#include <foredraw/analysis/surface_distance.h>
#include <foredraw/io/gltf/gltf.h>
#include <foredraw/viewing/subject_geometry.h>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace foredraw::displacement_bake_test {
namespace {

/// A sphere of about 16,000 triangles with waves.
testing::TestMesh waves() {
  testing::TestMesh mesh = testing::sphere(128, 64);
  for (glm::vec3& p : mesh.positions) {
    p *= 1 + 0.01f * std::sin(16 * p.x) * std::sin(16 * p.y) * std::sin(16 * p.z);
    p = glm::round(p * 65536.0f) / 65536.0f;
  }
  return mesh;
}

const Scene& baked_waves() {
  static const Result result =
      testing::run("quadric-collapse(until=0.002), displacement-bake(rms=0.0002, bits=12)", testing::scene_of(waves()));
  EXPECT_TRUE(heights_of(result.scene, 0)) << "it pays here";
  return result.scene;
}

SubjectGeometry shown(const Scene& scene) {
  Analyses analyses;
  return subject_geometry(scene, subjects_of(scene)[0], Faces::material, posed_nodes(scene), analyses);
}

Surface surface_of(const RasterPart& part) { return {part.positions, part.indices}; }

TEST(DisplacementBake, LeavesFewTrianglesWhoseHeightsShowTheSurface) {
  const testing::TestMesh before = waves();
  const Scene& scene = baked_waves();
  const Level& cage = scene.draws[0].full();
  EXPECT_LT(cage.stream().triangle_count(), before.indices.size() / 3 / 8);
  const SubjectGeometry seen = shown(scene);
  const Executor executor(2);
  const auto distance = surface_distance({before.positions, before.indices}, surface_of(seen.parts[0]),
                                         {.samples = 50'000, .seed = 99}, executor);
  const double diagonal = 2.01 * std::sqrt(3.0);
  EXPECT_LT(distance->rms, 1.1 * 0.0002 * diagonal);
  EXPECT_LT(distance->largest, 40 * 0.0002 * diagonal);
  const std::vector<glm::vec3> flat = decode_vec3(*cage.vertices->find("POSITION"));
  const auto of_cage = surface_distance({before.positions, before.indices}, {flat, cage.stream().indices.view()},
                                        {.samples = 50'000, .seed = 99}, executor);
  EXPECT_GT(of_cage->rms, 1.5 * distance->rms) << "the heights do it";
}

TEST(DisplacementBake, HasNoCracks) {
  const SubjectGeometry seen = shown(baked_waves());
  const RasterPart& part = seen.parts[0];
  using Place = std::array<float, 3>;
  const auto place = [&](std::uint32_t v) {
    const glm::vec3& p = part.positions[v];
    return Place{p.x, p.y, p.z};
  };
  std::map<std::pair<Place, Place>, int> edges;
  for (std::size_t t = 0; t < part.indices.size(); t += 3) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Place a = place(part.indices[t + c]), b = place(part.indices[t + (c + 1) % 3]);
      if (a < b) ++edges[{a, b}];
      if (b < a) --edges[{b, a}];
    }
  }
  EXPECT_EQ(std::ranges::count_if(edges, [](const auto& edge) { return edge.second != 0; }), 0);
}

TEST(DisplacementBake, IsSkippedWhereSimplificationAloneIsCheaper) {
  // A box of many flat triangles: a few of them are all of it.
  testing::TestMesh mesh = testing::grid(40, 40);
  const Result result = testing::run("quadric-collapse, displacement-bake", testing::scene_of(mesh));
  EXPECT_EQ(heights_of(result.scene, 0), nullptr);
  EXPECT_EQ(result.scene.draws[0].full().stream().triangle_count(), 3200u);
}

TEST(DisplacementBake, FollowsOrdersAndNewNumbersOfVertices) {
  const Scene& before = baked_waves();
  const Result result = testing::run("lookahead, vertex-fetch", before);
  ASSERT_TRUE(heights_of(result.scene, 0));
  EXPECT_FALSE(result.scene.draws[0].full().stream().indices == before.draws[0].full().stream().indices);
  const auto sorted = [](const Scene& scene) {
    std::vector<std::array<float, 3>> places;
    const SubjectGeometry seen = shown(scene);
    for (const glm::vec3& p : seen.positions[0]) places.push_back({p.x, p.y, p.z});
    std::ranges::sort(places);
    return places;
  };
  EXPECT_EQ(sorted(result.scene), sorted(before));
}

TEST(DisplacementBake, IsLeftOutWhereTheTrianglesBecomeOthers) {
  const Scene& scene = baked_waves();
  const Result result = testing::run("tessellate", scene);
  EXPECT_EQ(heights_of(result.scene, 0), nullptr);
  EXPECT_EQ(result.scene.draws[0].full().stream().triangle_count(), shown(scene).parts[0].indices.size() / 3);
  EXPECT_FALSE(result.scene.draws[0].traits.has(traits::displaced));
}

Scene written_and_read(const Scene& scene, Diagnostics& diagnostics) {
  const auto files = encode_gltf(scene, "out.glb", diagnostics, {.products = testing::built_in_products()});
  EXPECT_TRUE(files) << to_text(diagnostics);
  auto again = read_gltf(files->front().bytes, "out.glb", {}, diagnostics, {.products = testing::built_in_products()});
  EXPECT_TRUE(again) << to_text(diagnostics);
  return std::move(*again);
}

TEST(DisplacementBake, ComesBackFromAFile) {
  const Scene& scene = baked_waves();
  Diagnostics diagnostics;
  const Scene again = written_and_read(scene, diagnostics);
  ASSERT_TRUE(heights_of(again, 0));
  EXPECT_EQ(*heights_of(again, 0), *heights_of(scene, 0));
  EXPECT_TRUE(again.draws[0].traits.has(traits::displaced));
  EXPECT_EQ(shown(again).positions, shown(scene).positions);
}

TEST(DisplacementBake, DamagedHeightsAreLeftOut) {
  const Scene& scene = baked_waves();
  const DrawHeights good = *heights_of(scene, 0);
  const auto with = [&](auto change) {
    DrawHeights bad = good;
    change(bad);
    Scene wrong = scene;
    wrong.products.set(BakedHeights{{bad}});
    for (const auto& row : testing::built_in_products()) {
      if (row->card().name == BakedHeights::product) return row->difference(wrong);
    }
    return std::string();
  };
  EXPECT_EQ(with([](DrawHeights&) {}), "");
  EXPECT_NE(with([](DrawHeights& h) { h.bits = 17; }), "");
  EXPECT_NE(with([](DrawHeights& h) { h.bits = 0; }), "");
  EXPECT_NE(with([](DrawHeights& h) { h.bits = 4; }), "") << "heights need more";
  EXPECT_NE(with([](DrawHeights& h) { h.draw = 7; }), "");
  EXPECT_NE(with([](DrawHeights& h) { h.levels = Shared<std::uint8_t>({1, 2}); }), "");
  EXPECT_NE(
      with([](DrawHeights& h) { h.levels = Shared<std::uint8_t>(std::vector<std::uint8_t>(h.levels.size(), 6)); }), "");
  EXPECT_NE(
      with([](DrawHeights& h) { h.levels = Shared<std::uint8_t>(std::vector<std::uint8_t>(h.levels.size(), 9)); }), "");
  EXPECT_NE(with([](DrawHeights& h) { h.heights = Shared<std::uint16_t>({1}); }), "");
}

TEST(DisplacementBake, IsTheSameAtAnyNumberOfThreads) {
  const testing::TestMesh mesh = waves();
  std::optional<BakedHeights> first;
  for (const std::size_t threads : {1, 5}) {
    Registry registry;
    add_built_in_plugins(registry);
    Diagnostics diagnostics;
    const Scene scene = testing::scene_of(mesh);
    const auto plan =
        foredraw::plan(*parse_line("quadric-collapse, displacement-bake(cage=0.1, rms=0.0002)", diagnostics), registry,
                       scene, diagnostics);
    const Executor executor(threads);
    Analyses analyses;
    const Result result = optimize(*plan, scene, {executor, analyses});
    const BakedHeights* heights = result.scene.products.find<BakedHeights>();
    ASSERT_TRUE(heights);
    if (!first) first = *heights;
    EXPECT_EQ(*heights, *first) << threads;
  }
}

/// Surfaces that are none, or that look the other way, give heights that are numbers, or none.
TEST(DisplacementBake, BearsSoupsAndSurfacesTurnedInsideOut) {
  testing::TestMesh flipped = testing::sphere(32, 16);
  for (std::size_t i = 0; i < flipped.indices.size(); i += 3) std::swap(flipped.indices[i], flipped.indices[i + 1]);
  testing::TestMesh point = testing::sphere(16, 8);
  for (glm::vec3& p : point.positions) p = glm::vec3(1, 2, 3);
  for (const testing::TestMesh& mesh : {testing::soup(2000, 5), flipped, point, testing::TestMesh{}}) {
    const Result result =
        testing::run("quadric-collapse, displacement-bake(rms=0.01, cage=0.1)", testing::scene_of(mesh));
    EXPECT_FALSE(result.failed) << to_text(result.report);
    if (heights_of(result.scene, 0) == nullptr) {
      EXPECT_EQ(result.scene.draws[0].full().stream().triangle_count(), mesh.indices.size() / 3);
      continue;
    }
    for (const glm::vec3& p : shown(result.scene).positions[0])
      EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  }
}

/// Of a sheet in folds that nearly touch, rays meet the next fold: heights are those of the near side, or none.
TEST(DisplacementBake, OfACageWithFoldsStaysNear) {
  testing::TestMesh sheet = testing::grid(96, 48);
  for (glm::vec3& p : sheet.positions) {
    const float along = std::abs(std::fmod(p.x, 16.0f) - 8);
    p = {0.02f * p.x, 0.05f * p.y, 0.25f * along + 0.01f * std::sin(0.7f * p.y)};
  }
  const Result result =
      testing::run("quadric-collapse, displacement-bake(rms=0.002, cage=0.2)", testing::scene_of(sheet));
  EXPECT_FALSE(result.failed) << to_text(result.report);
  const SubjectGeometry geometry = shown(result.scene);
  const RasterPart& part = geometry.parts[0];
  ASSERT_GT(part.indices.size(), 0u);
  for (const glm::vec3& p : part.positions) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  const ClosestPoints original({sheet.positions, sheet.indices});
  for (const glm::vec3& p : part.positions) EXPECT_LT(original.distance(glm::dvec3(p)), 0.1) << "folds are 0.32 apart";
}

/// Of the surface turned inside out no ray hits a face that looks the same way: heights are those of nearest points.
TEST(DisplacementBake, OfASurfaceThatLooksTheOtherWayIsAsNear) {
  const testing::TestMesh outside = testing::sphere(64, 32), cage = testing::sphere(16, 8);
  testing::TestMesh inside = outside;
  for (std::size_t i = 0; i < inside.indices.size(); i += 3) std::swap(inside.indices[i], inside.indices[i + 1]);
  std::vector<double> rms;
  for (const testing::TestMesh& mesh : {outside, inside}) {
    const Surface surface{mesh.positions, mesh.indices};
    const processors::displacement_bake::Target target(surface);
    const BakedCage baked = bake_heights({cage.positions, cage.indices, cage.positions}, target, surface,
                                         {.rms = 0.001, .finest = 8, .samples = 5000}, Executor(2));
    rms.push_back(baked.rms);
  }
  EXPECT_LT(rms[0], 0.002);
  EXPECT_LT(rms[1], 2 * rms[0]);
}

TEST(CastHeights, MeetTheNearerSideThatLooksTheSameWay) {
  // Two plates that look up, at 0.3 above and 0.2 below, and one nearer that looks down.
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
  for (const auto& [z, up] : {std::pair{0.3f, true}, {-0.2f, true}, {0.1f, false}}) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (const glm::vec2& at : {glm::vec2(-9, -9), glm::vec2(9, -9), glm::vec2(0, 9)}) positions.emplace_back(at, z);
    for (const std::uint32_t corner : {0u, up ? 1u : 2u, up ? 2u : 1u}) indices.push_back(first + corner);
  }
  const processors::displacement_bake::Target target({positions, indices});
  EXPECT_NEAR(target.height_from({0, 0, 0}, {0, 0, 1}), -0.2, 1e-6);
  EXPECT_NEAR(target.height_from({0, 0, 0.2}, {0, 0, 1}), 0.1, 1e-6);
  EXPECT_EQ(target.height_from({0, 0, 0.3f}, {0, 0, 1}), 0) << "right here";
  EXPECT_NEAR(target.height_from({0, 9.005, 0}, {0, 0, 1}), 0.1, 1e-6) << "beside the border: the nearest point";
}

/// A ray through a hole meets another fold far behind it.
TEST(CastHeights, GoToTheNearestPointAndNotThroughHoles) {
  std::vector<glm::vec3> positions;
  for (const float z : {0.0f, -5.0f}) {
    for (const glm::vec2& at : {glm::vec2(0.1f, -9), glm::vec2(9, -9), glm::vec2(0.1f, 9)})
      positions.emplace_back(z == 0 ? at : 2.0f * at - glm::vec2(9, 0), z);
  }
  const std::vector<std::uint32_t> indices = {0, 1, 2, 3, 4, 5};
  const processors::displacement_bake::Target target({positions, indices});
  EXPECT_NEAR(target.height_from({0, 0, 0.2}, {0, 0, 1}), -0.2, 1e-6);
}

TEST(CastHeights, OfNothingAndOfNoPlaceAreZero) {
  EXPECT_EQ(processors::displacement_bake::Target({{}, {}}).height_from({0, 0, 0}, {0, 0, 1}), 0);
  const std::vector<glm::vec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<std::uint32_t> indices = {0, 1, 2};
  const processors::displacement_bake::Target target({positions, indices});
  EXPECT_EQ(target.height_from({INFINITY, 0, 0}, {0, 0, 1}), 0);
  EXPECT_EQ(target.height_from({0, NAN, 0}, {0, 0, 1}), 0);
}

}  // namespace
}  // namespace foredraw::displacement_bake_test
