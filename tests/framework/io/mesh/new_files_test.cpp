// Mesh files made anew of scenes that came from elsewhere.
#include <foredraw/io/mesh/mesh_files.h>

#include <foredraw/analysis/analyses.h>
#include <foredraw/io/scene_file.h>

#include <gtest/gtest.h>

#include "support/mesh_reading.h"
#include "support/meshes.h"
#include "support/other_units.h"

#include <cmath>
#include <cstring>

namespace foredraw::new_files_test {
namespace {

template <class T>
VertexStream stream(std::string semantic, std::uint8_t components, bool normalized, const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return {std::move(semantic),
          {std::is_same_v<T, float> ? Component::float32 : Component::uint8, components, normalized,
           static_cast<std::uint16_t>(components * sizeof(T))},
          Shared<std::byte>({bytes.begin(), bytes.end()})};
}

/// A triangle with all that files can hold, drawn twice: moved, and mirrored.
Scene scene() {
  Draw draw;
  draw.name = "Leaf\nof a tree";
  draw.material = 0;
  draw.levels.emplace_back();
  VertexStreams vertices{.count = 3};
  vertices.base = {stream<float>("POSITION", 3, false, {0, 0, 0, 1, 0, 0, 0, 1, 0.1f}),
                   stream<float>("NORMAL", 3, false, {0, 0, 1, 0, 0, 1, 0, 0, 1}),
                   stream<float>("TEXCOORD_0", 2, false, {0, 0.25f, 1, 0.25f, 0, 1}),
                   stream<std::uint8_t>("COLOR_0", 4, true, {255, 0, 0, 255, 0, 255, 0, 128, 0, 0, 7, 0})};
  draw.full().vertices = std::make_shared<const VertexStreams>(std::move(vertices));
  draw.full().orders.push_back({.indices = Shared<std::uint32_t>({0, 1, 2})});
  Scene scene = testing::scene_of({std::move(draw)});
  scene.materials.push_back({.name = "Green"});
  scene.nodes[0].transform.translation = {10, 0, 0};
  Node mirrored = scene.nodes[0];
  mirrored.transform = {.translation = {0, 0, 5}, .scale = {-2, 1, 1}};
  scene.nodes.push_back(mirrored);
  return scene;
}

std::string text_of(const Scene& scene, MeshKind kind) {
  Diagnostics diagnostics;
  const auto file = encode_new_mesh_file(scene, kind, "out" + std::string(extension_of(kind)), diagnostics);
  EXPECT_TRUE(diagnostics.empty()) << to_text(diagnostics);
  return file ? testing::text_of(*file) : std::string();
}

class NewMeshFile : public ::testing::TestWithParam<MeshKind> {};

TEST_P(NewMeshFile, ReadsAsWhatWasShown) {
  const auto made = testing::read_mesh(GetParam(), text_of(scene(), GetParam()));
  ASSERT_TRUE(made.scene) << made.error();
  std::vector<glm::vec3> corners;
  Analyses analyses;
  for (const Draw& draw : made.scene->draws) {
    const auto positions = positions_of(analyses, *draw.full().vertices);
    for (const std::uint32_t index : draw.full().stream().indices.view()) corners.push_back(positions->values[index]);
  }
  // The mirrored one is wound the other way round, so that it shows the same side.
  EXPECT_EQ(corners,
            (std::vector<glm::vec3>{{10, 0, 0}, {11, 0, 0}, {10, 1, 0.1f}, {0, 0, 5}, {0, 1, 5 + 0.1f}, {-2, 0, 5}}));
}

TEST_P(NewMeshFile, HasTextureCoordinatesInTheUnitsOfTheScenesFile) {
  const ScaledTexcoords change{.set = 0, .offset = {-3, 1}, .scale = glm::dvec2(0x1p-8)};
  EXPECT_EQ(text_of(testing::in_other_units(scene(), change), GetParam()), text_of(scene(), GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Kinds, NewMeshFile,
                         ::testing::Values(MeshKind::obj, MeshKind::ply, MeshKind::off, MeshKind::stl));

TEST(NewMeshFiles, HoldAttributesWhereTheyCan) {
  EXPECT_TRUE(text_of(scene(), MeshKind::obj)
                  .starts_with("o Leaf of a tree\nv 10 0 0\nv 11 0 0\nv 10 1 0.1\nvt 0 0.75\nvt 1 0.75\nvt 0 0\n"
                               "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\nusemtl Green\nf 1/1/1 2/2/2 3/3/3\no Leaf"));
  const auto ply = testing::read_mesh(MeshKind::ply, text_of(scene(), MeshKind::ply));
  const VertexStreams& vertices = *ply.scene->draws[0].full().vertices;
  ASSERT_NE(vertices.find("COLOR_0"), nullptr);
  EXPECT_EQ(decode_component(*vertices.find("COLOR_0"), 1, 3), 128 / 255.0f);
  EXPECT_EQ(decode_component(*vertices.find("TEXCOORD_0"), 0, 1), 0.25f);
  EXPECT_EQ(decode_component(*vertices.find("NORMAL"), 0, 2), 1);
}

TEST(NewMeshFiles, SkinnedMeshesAreAsTheyAreBoundAndInstancesStandOneByOne) {
  Scene skinned = scene();
  skinned.skins.emplace_back();
  skinned.nodes[0].skin = 0;
  EXPECT_TRUE(text_of(skinned, MeshKind::obj).starts_with("o Leaf of a tree\nv 0 0 0\n"));
  Scene many = scene();
  many.nodes.resize(1);
  many.nodes[0].instances = Shared<Transform>({{.translation = {1, 0, 0}}, {.translation = {2, 0, 0}}});
  const std::string text = text_of(many, MeshKind::obj);
  EXPECT_NE(text.find("v 11 0 0\n"), std::string::npos);
  EXPECT_NE(text.find("f 4/4/4 5/5/5 6/6/6\n"), std::string::npos);
}

TEST(NewMeshFiles, AreRefusedWhereNothingIsShown) {
  Scene hidden = scene();
  for (Node& node : hidden.nodes) node.is_shown = false;
  Diagnostics diagnostics;
  EXPECT_FALSE(encode_new_mesh_file(hidden, MeshKind::stl, "out.stl", diagnostics));
  EXPECT_NE(to_text(diagnostics).find("shows no triangles"), std::string::npos);
}

TEST(NewMeshFiles, OtherTrianglesMakeAFileAnew) {
  const std::string text = "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 3 2\n";
  Diagnostics diagnostics;
  Scene scene = *read_mesh_file(std::as_bytes(std::span(text)), MeshKind::off, "in.off", {}, diagnostics);
  scene.draws[0].levels[0].orders[0].indices = Shared<std::uint32_t>({1, 3, 2});
  const auto files = encode_scene(scene, "out.off", diagnostics);
  ASSERT_TRUE(files) << to_text(diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1u) << to_text(diagnostics);
  EXPECT_EQ(diagnostics.all()[0].code, "made-anew");
  const auto again = read_mesh_file(files->front().bytes, MeshKind::off, "out.off", {}, diagnostics);
  ASSERT_TRUE(again) << to_text(diagnostics);
  EXPECT_EQ(again->draws[0].full().stream().triangle_count(), 1u);
}

TEST(NewMeshFiles, AreMadeOfAnyMeshWithAWarningOfWhatIsLeftOut) {
  Scene skinned = scene();
  skinned.skins.emplace_back();
  skinned.animations.emplace_back();
  for (const char* name : {"out.obj", "out.ply", "out.off", "out.stl"}) {
    Diagnostics diagnostics;
    const auto files = encode_scene(skinned, name, diagnostics);
    ASSERT_TRUE(files) << to_text(diagnostics);
    EXPECT_EQ(files->front().bytes, encode_new_mesh_file(skinned, *mesh_kind_of(name), name, diagnostics)->bytes);
    ASSERT_EQ(diagnostics.all()[0].code, "made-anew") << to_text(diagnostics);
    EXPECT_NE(diagnostics.all()[0].message.find("the scene was not read from ."), std::string::npos);
    EXPECT_NE(diagnostics.all()[0].message.find("skins, animations"), std::string::npos)
        << diagnostics.all()[0].message;
  }
}

}  // namespace
}  // namespace foredraw::new_files_test
