// What becomes of whole files: they are read, changed, written and read again, and look as before.

#include "sides_files.h"

#include "support/same_look.h"

#include <gtest/gtest.h>

#include <atomic>

namespace foredraw::sides_files_test {
namespace {

using testing::box_corners, testing::box_file, testing::box_primitive, testing::decoded;
using testing::GltfBuilder, testing::GltfJson;

std::vector<std::uint16_t> open_box() {
  std::vector<std::uint16_t> corners = box_corners();
  corners.resize(30);
  return corners;
}

std::vector<std::uint16_t> reversed(std::vector<std::uint16_t> corners) {
  for (std::size_t i = 0; i < corners.size(); i += 3) std::swap(corners[i + 1], corners[i + 2]);
  return corners;
}

/// The file as it is written; it looks as before.
Scene changed(const GltfBuilder& builder) {
  const Scene before = decoded(builder.glb());
  const Result result = testing::with_fewer_sides(before);
  EXPECT_FALSE(result.failed);
  const Scene after = decoded(testing::encoded(result.scene));
  const testing::Looks looks = testing::compared(before, after, {.pictures = 40, .size = 128}, Executor(2));
  EXPECT_GT(looks.shown, 20'000u);
  EXPECT_EQ(looks.lost + looks.moved + looks.coloured, 0u);
  return after;
}

std::size_t triangles(const Scene& scene, DrawId id = 0) { return scene.draws[id].full().stream().triangle_count(); }
bool is_double_sided(const Scene& scene, DrawId id = 0) { return scene.material_of(scene.draws[id])->double_sided; }

TEST(SidesFiles, AnOpenBoxShowsItsWallsTwice) {
  const Scene after = changed(box_file(open_box()));
  EXPECT_FALSE(is_double_sided(after));
  EXPECT_EQ(triangles(after), 20u);
}

TEST(SidesFiles, WhatIsInsideOutIsTurned) {
  const Scene after = changed(box_file(reversed(box_corners())));
  EXPECT_FALSE(is_double_sided(after));
  EXPECT_EQ(triangles(after), 12u);
}

/// The second node shows the mesh inside out, as its transform mirrors it: fronts are fronts all the same.
TEST(SidesFiles, AMirroredNodeShowsTheSameSides) {
  for (const bool is_open : {false, true}) {
    GltfBuilder builder = box_file(is_open ? open_box() : box_corners());
    const std::size_t second = builder.add("nodes", {{"mesh", 0}, {"scale", {-1, 1, 1}}, {"translation", {5, 0, 0}}});
    if (builder.json.contains("scenes")) builder.json["scenes"][0]["nodes"].push_back(second);
    EXPECT_EQ(triangles(changed(builder)), is_open ? 20u : 12u);
  }
}

/// Copies have targets too, in which normals are turned as well.
TEST(SidesFiles, MorphTargetsMoveCopiesAlong) {
  GltfBuilder builder;
  builder.add("materials", {{"doubleSided", true}});
  GltfJson primitive = box_primitive(builder, open_box());
  std::vector<float> moves(24, 0), turns(24, 0);
  for (std::size_t v = 4; v < 8; ++v) {
    moves[3 * v + 2] = 1.5f;
    turns[3 * v] = 0.25f;
  }
  const std::size_t move = builder.add_values(moves, "VEC3");
  builder.json["accessors"][move]["min"] = {0, 0, 0};
  builder.json["accessors"][move]["max"] = {0, 0, 1.5};
  primitive["targets"] = {{{"POSITION", move}, {"NORMAL", builder.add_values(turns, "VEC3")}}};
  builder.add_mesh(std::move(primitive));
  builder.json["meshes"][0]["weights"] = {0.5};
  const Scene after = changed(builder);
  EXPECT_EQ(triangles(after), 20u);
  const VertexStreams& vertices = *after.draws[0].full().vertices;
  ASSERT_EQ(vertices.count, 16u);
  ASSERT_EQ(vertices.morph_targets.size(), 1u);
  for (const VertexStream& stream : vertices.morph_targets[0]) {
    const std::vector<glm::vec3> values = decode_vec3(stream);
    std::size_t turned = 0;
    for (std::size_t copy = 8; copy < values.size(); ++copy) turned += values[copy].x == -0.25f;
    EXPECT_EQ(values.size(), 16u);
    EXPECT_EQ(turned, stream.semantic == "NORMAL" ? 4u : 0u);
  }
}

TEST(SidesFiles, InstancesOfANodeStay) {
  GltfBuilder builder = box_file(open_box());
  builder.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  const GltfJson places = {{"TRANSLATION", builder.add_values(std::vector<float>{0, 0, 0, 4, 0, 0, 0, 0, 5}, "VEC3")}};
  builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = places;
  const Scene after = changed(builder);
  EXPECT_EQ(triangles(after), 20u);
  EXPECT_EQ(testing::json_of(testing::encoded(after))["nodes"][0]["extensions"].size(), 1u);
}

TEST(SidesFiles, VariantsStayWithTheirPrimitives) {
  GltfBuilder builder = box_file(open_box());
  builder.add("materials", {{"name", "worn"}, {"doubleSided", true}});
  builder.json["extensionsUsed"] = {"KHR_materials_variants"};
  builder.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "worn"}}};
  const GltfJson mappings = {{{"material", 1}, {"variants", {0}}}};
  builder.json["meshes"][0]["primitives"][0]["extensions"]["KHR_materials_variants"]["mappings"] = mappings;
  const Scene after = changed(builder);
  const GltfJson written = testing::json_of(testing::encoded(after));
  EXPECT_EQ(written["meshes"][0]["primitives"][0]["extensions"]["KHR_materials_variants"]["mappings"], mappings);
}

TEST(SidesFiles, WallsWithoutAreaAndFacesTwiceDoNoHarm) {
  std::vector<std::uint16_t> flat = box_corners();
  flat.insert(flat.end(), {0, 0, 1, 2, 2, 2, 0, 1, 0});
  EXPECT_EQ(triangles(changed(box_file(flat))), 15u);
  std::vector<std::uint16_t> twice = box_corners();
  twice.insert(twice.end(), {0, 2, 1, 1, 2, 3});
  EXPECT_EQ(triangles(changed(box_file(twice))), 14u);
  GltfBuilder lined = box_file(open_box());  // an exporter's own copies, with normals of their own
  const GltfJson lining = box_primitive(lined, reversed(open_box()), -1);
  lined.json["meshes"][0]["primitives"].push_back(lining);
  changed(lined);
}

TEST(SidesFiles, ACancelledRunStopsSoonAndChangesNothing) {
  const Scene before = decoded(box_file(open_box()).glb());
  int loops = 0, most = 1'000'000;
  std::atomic<bool> cancel = false;
  const Executor counting(1, [&](std::size_t count, const std::function<void(std::size_t)>& task) {
    if (++loops == most) cancel = true;
    for (std::size_t i = 0; i < count; ++i) task(i);
  });
  testing::with_fewer_sides(before, counting, &cancel);
  const int all = loops;
  for (const int when : {all / 4, all / 2}) {
    loops = 0;
    most = when;
    cancel = false;
    const Scene after = testing::with_fewer_sides(before, counting, &cancel).scene;
    EXPECT_TRUE(cancel);
    EXPECT_LT(loops, all - 1);
    EXPECT_EQ(testing::encoded(after), testing::encoded(before));
  }
}

}  // namespace
}  // namespace foredraw::sides_files_test
