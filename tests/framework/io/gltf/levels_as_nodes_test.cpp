// Levels that stages made, written as nodes with MSFT_lod.

#include "framework/io/gltf/levelled.h"

#include <gtest/gtest.h>

#include <numbers>

namespace foredraw::levels_as_nodes_test {
namespace {

using namespace testing;

GltfJson as_nodes(Scene scene) {
  Diagnostics diagnostics;
  for (Node& node : scene.nodes) node.is_shown = true;
  const auto files = encode_gltf(scene, "out.glb", diagnostics, {.levels = LevelsAs::lod_nodes});
  return json_of(files->front().bytes);
}

TEST(GltfLevels, GoOutAsNodesWhereAskedFor) {
  const GltfJson json = as_nodes(with_made_levels());
  EXPECT_EQ(json["nodes"][0]["extensions"]["MSFT_lod"]["ids"], GltfJson::parse("[1, 2]"));
  EXPECT_EQ(json["meshes"].size(), 3u);
  EXPECT_EQ(json["meshes"][1]["primitives"][0]["attributes"], json["meshes"][0]["primitives"][0]["attributes"]);
  EXPECT_EQ(json["extensionsUsed"], GltfJson::array({"MSFT_lod"}));
  EXPECT_FALSE(json["meshes"][0]["primitives"][0].contains("extensions"));
}

/// Nodes cannot tell of levels where something hangs on the node, or where primitives have different numbers of them.
TEST(GltfLevels, StayWithThePrimitiveWhereNodesCannotTellOfThem) {
  const auto told = [](const Scene& scene) {
    Diagnostics diagnostics;
    const auto files = encode_gltf(scene, "out.glb", diagnostics, {.levels = LevelsAs::lod_nodes});
    if (!files || diagnostics.all().empty()) return to_text(diagnostics);
    const GltfJson json = json_of(files->front().bytes);
    EXPECT_TRUE(json["meshes"][0]["primitives"][0]["extensions"].contains(levels_name));
    EXPECT_EQ(json.dump().find("MSFT_lod"), std::string::npos);
    return diagnostics.all()[0].code + ": " + diagnostics.all()[0].message;
  };
  const std::string code =
      "levels-stay-with-primitive: its levels do not fit MSFT_lod and are written as FOREDRAW_levels: ";
  const std::vector<Level> levels = with_made_levels().draws[0].levels;
  GltfBuilder parent = ribbon(8);
  parent.json["nodes"].push_back({{"name", "child"}});
  parent.json["nodes"][0]["children"] = {1};
  Scene with_child = read(parent);
  with_child.draws[0].levels = levels;
  EXPECT_EQ(told(with_child), code + "node 0 has children");
  GltfBuilder several = ribbon(8);
  several.json["meshes"][0]["primitives"].push_back(several.json["meshes"][0]["primitives"][0]);
  Scene with_two = read(several);
  with_two.draws[0].levels = levels;
  EXPECT_EQ(told(with_two), code + "its primitives have different numbers of levels");
}

/// Which nodes draw, and where; coarser ones are in no scene.
std::string placed_meshes(const Scene& scene) {
  std::string text;
  for (const Node& node : scene.nodes) {
    if (node.mesh)
      text += std::to_string(*node.mesh) + (node.is_shown ? "" : "'") + '@' +
              std::to_string(node.transform.scale.x).substr(0, 4) + ' ';
  }
  return text;
}

TEST(GltfLevels, AsNodesStandWhereTheNodeIsPlacedAnew) {
  GltfBuilder builder = ribbon(8);
  builder.json["scenes"] = {{{"nodes", {0}}}};
  builder.json["scene"] = 0;
  const std::vector<Level> levels = with_made_levels().draws[0].levels;
  const auto again = [&](const Scene& scene) {
    Diagnostics diagnostics;
    const auto files = encode_gltf(scene, "out.glb", diagnostics, {.levels = LevelsAs::lod_nodes});
    return read(files->front().bytes);
  };
  Scene scene = read(builder);
  scene.draws[0].levels = levels;
  scene.nodes[0].transform.scale = glm::vec3(0.25f);
  EXPECT_EQ(placed_meshes(again(scene)), "0@0.25 1'@0.25 2'@0.25 ");
  EXPECT_EQ(again(scene).draws.size(), 1u);
  EXPECT_EQ(again(scene).draws[0].levels.size(), 3u) << "read as levels";

  // The mesh went to a child: its coarser ones stand in for that child, and the node above holds it alone.
  Scene below = read(builder);
  below.draws[0].levels = levels;
  below.nodes.push_back(below.nodes[0]);
  below.nodes[1].transform.scale = glm::vec3(0.5f);
  below.nodes[0].mesh.reset();
  below.nodes[0].children = {1};
  const Scene after = again(below);
  EXPECT_EQ(placed_meshes(after), "0@0.50 1'@0.50 2'@0.50 ");
  EXPECT_EQ(after.nodes[0].children, (std::vector<NodeId>{1}));
  EXPECT_EQ(after.roots, (std::vector<NodeId>{0}));
  EXPECT_EQ(after.draws[0].levels.size(), 3u);
}

/// Those that came as nodes stay levels as long as all of their nodes are placed alike.
TEST(GltfLevels, ThatCameAsNodesAreLevelsWhereTheseAreAllPlacedAnew) {
  Scene scene = read(with_lods());
  for (Node& node : scene.nodes) node.transform.translation.x = 2;
  const Scene again = read(write(scene));
  ASSERT_EQ(again.draws.size(), 1u);
  EXPECT_EQ(again.draws[0].levels.size(), 3u);
  for (const Node& node : again.nodes) EXPECT_EQ(node.transform.translation.x, 2);
}

/// What stands in a node's extras stays, whatever it is.
TEST(GltfLevels, CoverageTakesNobodysPlace) {
  for (const char* extras : {"3", R"({"MSFT_screencoverage": "mine"})", R"({"name": "rock"})"}) {
    GltfBuilder builder = ribbon(8);
    builder.json["nodes"][0]["extras"] = GltfJson::parse(extras);
    Scene scene = read(builder);
    scene.draws[0].levels = with_made_levels().draws[0].levels;
    const GltfJson after = as_nodes(scene)["nodes"][0]["extras"];
    GltfJson want = builder.json["nodes"][0]["extras"];
    if (want.contains("name")) want["MSFT_screencoverage"] = after["MSFT_screencoverage"];
    EXPECT_EQ(after, want);
  }
}

/// A level is left where the next coarser one is off by a pixel: of a ribbon of 8 by 1 the sphere has a radius of 4.03,
/// and an error of .2 is a pixel where that is 20.2 pixels.
TEST(GltfLevels, AsNodesSayHowMuchOfTheScreenTheyAreFor) {
  Scene scene = with_made_levels();
  const auto pixels = [](double error) { return std::numbers::pi * (65.0 / 4) / (error * error) / (1920.0 * 1080); };
  const GltfJson coverage = as_nodes(scene)["nodes"][0]["extras"]["MSFT_screencoverage"];
  ASSERT_EQ(coverage.size(), 3u);
  EXPECT_NEAR(coverage[0], pixels(0.2), 1e-6 * pixels(0.2));
  EXPECT_NEAR(coverage[1], pixels(0.4), 1e-6 * pixels(0.4));
  EXPECT_EQ(coverage[2], 0);

  scene.draws[0].levels[1].error = 1e-6f;  // no screen is so large
  scene.draws[0].levels[2].error = 1e-7f;  // less than the finer one's
  EXPECT_EQ(as_nodes(scene)["nodes"][0]["extras"]["MSFT_screencoverage"], GltfJson::parse("[1.0, 1.0, 0.0]"));
  scene.draws[0].levels[2].error = 0;
  EXPECT_FALSE(as_nodes(scene)["nodes"][0].contains("extras")) << "an error that is not known";
}

}  // namespace
}  // namespace foredraw::levels_as_nodes_test
