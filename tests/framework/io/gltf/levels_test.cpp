// FOREDRAW_levels and MSFT_lod: levels from a file to the scene and back, and what is no level.

#include "framework/io/gltf/levelled.h"
#include "support/compressed_gltf.h"
#include "support/meshes.h"
#include "support/staged.h"

#include <foredraw/scene/levels.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace foredraw::gltf_levels_test {
namespace {

using namespace testing;

std::string note_of(const GltfBuilder& builder) {
  Diagnostics diagnostics;
  const auto scene = read_gltf(builder.glb(), "test", {}, diagnostics);
  if (!scene) return "not read: " + to_text(diagnostics);
  for (const Draw& draw : scene->draws) EXPECT_EQ(draw.levels.size(), 1u);
  EXPECT_EQ(encode_gltf(*scene, "out.glb", diagnostics)->front().bytes, builder.glb()) << "stays as it came";
  for (const Diagnostic& one : diagnostics.all()) {
    if (one.code == "lod-left-as-it-came") return one.message;
  }
  return "no note";
}

TEST(GltfLevels, CoarserNodesAreLevelsOfOneDraw) {
  const GltfBuilder builder = with_lods();
  const Scene scene = read(builder);
  ASSERT_EQ(scene.draws.size(), 1u);
  ASSERT_EQ(scene.draws[0].levels.size(), 3u);
  EXPECT_EQ(scene.draws[0].levels[1].stream().triangle_count(), 8u);
  EXPECT_EQ(scene.draws[0].levels[2].vertices, scene.draws[0].full().vertices);
  EXPECT_EQ(scene.draws[0].levels[2].origin, (DrawOrigin{2, 0}));
  EXPECT_EQ(scene.meshes.size(), 3u);
  EXPECT_EQ(write(scene), builder.glb()) << "what nobody changed comes out as it was";
}

TEST(GltfLevels, CameByMsftLodGoOutSo) {
  const Bytes before = with_lods().glb();
  const Result result = run("tipsify, vertex-fetch", read(before));
  ASSERT_FALSE(result.failed);
  const Bytes after = write(result.scene);
  const GltfJson json = json_of(after);
  EXPECT_EQ(json["nodes"], json_of(before)["nodes"]);
  EXPECT_EQ(json["meshes"].size(), 3u);
  EXPECT_LE(after.size(), before.size());
  for (const GltfJson& mesh : json["meshes"]) {
    EXPECT_EQ(mesh["primitives"][0]["attributes"], json["meshes"][0]["primitives"][0]["attributes"])
        << "one vertex order";
  }
  const Scene again = read(after);
  ASSERT_EQ(again.draws.size(), 1u);
  for (std::size_t level = 0; level < 3; ++level) {
    EXPECT_EQ(again.draws[0].levels[level].stream().indices, result.scene.draws[0].levels[level].stream().indices);
  }
}

TEST(GltfLevels, WhatIsNoLevelStaysAndSaysWhy) {
  const auto why = [](const std::function<void(GltfJson&)>& change) {
    GltfBuilder builder = with_lods();
    change(builder.json);
    return note_of(builder);
  };
  const auto has = [](const std::string& note, const std::string& words) {
    EXPECT_NE(note.find(words), std::string::npos) << note;
  };
  has(why([](GltfJson& j) {
        j["materials"] = {GltfJson::object()};
        j["meshes"][1]["primitives"][0]["material"] = 0;
      }),
      "node 1 has different materials");
  has(why([](GltfJson& j) { j["meshes"][2]["primitives"].push_back(j["meshes"][2]["primitives"][0]); }),
      "node 2 has a different number of primitives");
  has(why([](GltfJson& j) {
        j["materials"] = {{{"extensions", {{"MSFT_lod", {{"ids", {0}}}}}}}};
        for (GltfJson& mesh : j["meshes"]) mesh["primitives"][0]["material"] = 0;
      }),
      "has a material with levels");
  has(why([](GltfJson& j) { j["nodes"][1]["translation"] = {1, 0, 0}; }), "node 1 has a different transform");
  has(why([](GltfJson& j) { j["scenes"][0]["nodes"].push_back(2); }), "node 2 is in the scene");
  has(why([](GltfJson& j) { j.erase("scenes"), j.erase("scene"); }), "node 1 is in the scene");
  has(why([](GltfJson& j) { j["nodes"].push_back({{"children", {1}}}); }), "node 1 is below another node");
  has(why([](GltfJson& j) {
        j["nodes"].push_back(GltfJson::object());
        j["nodes"][0]["children"] = {3};
      }),
      "the node has children");
  has(why([](GltfJson& j) {
        j["nodes"].push_back({{"mesh", 0}});
        j["scenes"][0]["nodes"].push_back(3);
      }),
      "another node draws its mesh without these levels");
  has(why([](GltfJson& j) {
        j["nodes"].push_back({{"mesh", 2}});
        j["scenes"][0]["nodes"].push_back(3);
      }),
      "a coarser mesh is also drawn by itself");
  has(why([](GltfJson& j) { j["nodes"][0]["extensions"]["MSFT_lod"]["ids"] = {1, 1}; }), "names a node twice");
  has(why([](GltfJson& j) { j["nodes"][0]["extensions"]["MSFT_lod"]["ids"] = {1, 0}; }), "names a node twice");
  has(why([](GltfJson& j) { j["nodes"][0]["extensions"]["MSFT_lod"]["ids"] = {1, 9}; }), "does not exist");
  has(why([](GltfJson& j) { j["nodes"][0]["extensions"]["MSFT_lod"] = 3; }), "it names no nodes");
  has(why([](GltfJson& j) { j["nodes"][1]["extensions"]["MSFT_lod"]["ids"] = {2}; }),
      "node 1 has extensions of its own");
}

TEST(GltfLevels, TwoPlacesOfOneMeshWithTheSameLevelsShareThem) {
  GltfBuilder builder = with_lods();
  GltfJson& nodes = builder.json["nodes"];
  for (std::size_t n = 0; n < 3; ++n) {
    GltfJson copy = nodes[n];
    copy["translation"] = {5, 0, 0};
    if (n == 0) copy["extensions"]["MSFT_lod"]["ids"] = {4, 5};
    nodes.push_back(copy);
  }
  builder.json["scenes"][0]["nodes"] = {0, 3};
  const Scene scene = read(builder);
  ASSERT_EQ(scene.draws.size(), 1u);
  EXPECT_EQ(scene.draws[0].levels.size(), 3u);
  EXPECT_TRUE(scene.draws[0].traits.has(traits::instanced));
}

TEST(GltfLevels, AnAnimatedNodeKeepsItsCoarserOnes) {
  GltfBuilder builder = with_lods();
  const std::size_t times = builder.add_values(std::vector<float>{0, 1}, "SCALAR");
  builder.json["accessors"][times]["min"] = {0};
  builder.json["accessors"][times]["max"] = {1};
  const std::size_t places = builder.add_values(std::vector<float>{0, 0, 0, 1, 0, 0}, "VEC3");
  builder.add("animations", {{"samplers", {{{"input", times}, {"output", places}}}},
                             {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}});
  EXPECT_NE(note_of(builder).find("an animation moves the node"), std::string::npos);
}

TEST(GltfLevels, MadeOnesGoOutOnThePrimitiveAndShareItsAccessors) {
  const Scene scene = with_made_levels();
  const Bytes file = write(scene);
  const GltfJson json = json_of(file);
  ASSERT_EQ(json["meshes"][0]["primitives"].size(), 1u) << "a reader without the extension sees full detail";
  const GltfJson& primitive = json["meshes"][0]["primitives"][0];
  const GltfJson& levels = primitive["extensions"][levels_name]["levels"];
  ASSERT_EQ(levels.size(), 2u);
  EXPECT_EQ(levels[0]["attributes"], primitive["attributes"]);
  EXPECT_NE(levels[0]["indices"], primitive["indices"]);
  EXPECT_EQ(levels[0]["error"].dump(), "0.2");
  EXPECT_EQ(json["extensionsUsed"], GltfJson::array({levels_name}));
  EXPECT_FALSE(json.contains("extensionsRequired"));

  const Scene again = read(file);
  ASSERT_EQ(again.draws.size(), 1u);
  EXPECT_EQ(again.draws[0].name, scene.draws[0].name);
  ASSERT_EQ(again.draws[0].levels.size(), 3u);
  for (std::size_t level = 0; level < 3; ++level) {
    EXPECT_EQ(again.draws[0].levels[level].stream().indices, scene.draws[0].levels[level].stream().indices);
    EXPECT_EQ(again.draws[0].levels[level].vertices, again.draws[0].full().vertices);
    EXPECT_EQ(again.draws[0].levels[level].error, scene.draws[0].levels[level].error);
  }
  EXPECT_FALSE(again.draws[0].traits.has(traits::extended)) << "stages know what to do with these";
  EXPECT_EQ(write(again), file) << "what nobody changed comes out as it was";
}

TEST(GltfLevels, StagesMoveThemAndTheyComeBack) {
  const Result result = run("weld, tipsify, vertex-fetch", read(write(with_made_levels())));
  ASSERT_FALSE(result.failed);
  const Scene again = read(write(result.scene));
  ASSERT_EQ(again.draws[0].levels.size(), 3u);
  for (std::size_t level = 0; level < 3; ++level) {
    EXPECT_EQ(again.draws[0].levels[level].stream().indices, result.scene.draws[0].levels[level].stream().indices);
    EXPECT_EQ(again.draws[0].levels[level].vertices->stamp(), result.scene.draws[0].levels[level].vertices->stamp());
  }
}

TEST(GltfLevels, OfVerticesOfTheirOwn) {
  Scene scene = scene_of({draw_of(grid(4, 4), "Cloth")});
  scene.draws[0].levels.push_back(draw_of(grid(2, 2)).full());
  const Scene again = read(write(scene));
  ASSERT_EQ(again.draws[0].levels.size(), 2u);
  EXPECT_EQ(again.draws[0].levels[1].vertices->stamp(), scene.draws[0].levels[1].vertices->stamp());
  EXPECT_EQ(write(again), write(scene));
}

TEST(GltfLevels, AnotherErrorIsAChange) {
  Scene scene = read(write(with_made_levels()));
  scene.draws[0].levels[2].error = 7;
  EXPECT_EQ(read(write(scene)).draws[0].levels[2].error, 7);
}

TEST(GltfLevels, TakenAwayTheyLeaveNothing) {
  Scene scene = read(write(with_made_levels()));
  scene.draws[0].levels.resize(1);
  const GltfJson json = written(scene);
  EXPECT_FALSE(json.contains("extensionsUsed"));
  EXPECT_EQ(json["meshes"], json_of(ribbon(8).glb())["meshes"]);
}

TEST(GltfLevels, DamagedOnesCostNothingElse) {
  const Bytes file = write(with_made_levels());
  const auto warned = [&](const std::function<void(GltfJson&)>& change) {
    GltfBuilder builder = builder_of(file);
    builder.json.erase("buffers");
    change(builder.json["meshes"][0]["primitives"][0]["extensions"][levels_name]);
    Diagnostics diagnostics;
    const auto scene = read_gltf(builder.glb(), "test", {}, diagnostics);
    if (!scene || scene->draws.size() != 1 || scene->draws[0].levels.size() != 1) return false;
    EXPECT_FALSE(written(*scene)["meshes"][0]["primitives"][0].contains("extensions"));
    Diagnostics strict;
    EXPECT_FALSE(read_gltf(builder.glb(), "test", {}, strict, {.strict = true}));
    return std::ranges::any_of(diagnostics.all(), [](const auto& d) { return d.code == "levels-left-out"; });
  };
  EXPECT_TRUE(warned([](GltfJson& e) { e = 3; }));
  EXPECT_TRUE(warned([](GltfJson& e) { e = GltfJson(); }));
  EXPECT_TRUE(warned([](GltfJson& e) { e["levels"] = GltfJson::array(); }));
  EXPECT_TRUE(warned([](GltfJson& e) { e["levels"][0] = 3; }));
  EXPECT_TRUE(warned([](GltfJson& e) { e["levels"][0].erase("attributes"); }));
  EXPECT_TRUE(warned([](GltfJson& e) { e["levels"][0]["attributes"]["POSITION"] = 99; }));
  EXPECT_TRUE(warned([](GltfJson& e) { e["levels"][0]["indices"] = 0; }));
  EXPECT_TRUE(warned([](GltfJson& e) { e["levels"][0]["indices"] = -1; }));
  EXPECT_TRUE(warned([](GltfJson& e) { e["levels"][1]["mode"] = 1; }));
  EXPECT_TRUE(warned([](GltfJson& e) { e["levels"][1]["mode"] = "four"; }));
  EXPECT_TRUE(warned([](GltfJson& e) { e["levels"][1]["error"] = -1; }));
  EXPECT_TRUE(warned([](GltfJson& e) { e["levels"][1]["targets"] = {GltfJson::object()}; }));
  EXPECT_TRUE(warned([](GltfJson& e) { e["levels"] = GltfJson(300, e["levels"][0]); }));
}

/// The file with levels that were changed; what is told of them, and the file that is written then.
std::pair<std::string, GltfJson> with_damaged_levels(
    const std::function<void(GltfBuilder& file, GltfJson& levels)>& change) {
  GltfBuilder builder = builder_of(write(with_made_levels()));
  builder.json.erase("buffers");
  GltfJson levels = builder.json["meshes"][0]["primitives"][0]["extensions"][levels_name]["levels"];
  change(builder, levels);
  builder.json["meshes"][0]["primitives"][0]["extensions"][levels_name]["levels"] = levels;
  Diagnostics diagnostics;
  const auto scene = read_gltf(builder.glb(), "test", {}, diagnostics);
  if (!scene || diagnostics.all().size() != 1) return {to_text(diagnostics), GltfJson()};
  return {diagnostics.all()[0].message, written(*scene)};
}

TEST(GltfLevels, DamagedOnesAreToldByTheirPlaceInTheFileAndLeaveNoData) {
  const auto [told, json] = with_damaged_levels([](auto&, GltfJson& levels) { levels[1]["indices"] = 99; });
  EXPECT_EQ(
      told,
      "is left out, and with it the levels of detail: "
      "meshes[0].primitives[0].extensions.FOREDRAW_levels.levels[1].indices: is 99, but the file has 5 accessors");
  const auto bytes_of = [](const GltfJson& of) { return of["buffers"][0]["byteLength"].get<std::size_t>(); };
  const std::size_t whole = bytes_of(json_of(write(with_made_levels())));
  EXPECT_LT(bytes_of(json), whole);
  EXPECT_FALSE(json.contains("extensionsUsed"));
  const auto [why, other] = with_damaged_levels([](auto&, GltfJson& levels) { levels[1]["mode"] = 1; });
  EXPECT_LT(bytes_of(other), bytes_of(json)) << why;
}

TEST(GltfLevels, DamagedOnesWithPositionsThatAreNotFiniteCostNothingElse) {
  const auto [told, json] = with_damaged_levels([](GltfBuilder& file, GltfJson& levels) {
    levels[0]["attributes"]["POSITION"] = file.add_values(std::vector<float>(54, NAN), "VEC3");
    levels[0]["indices"] = -1;
  });
  EXPECT_TRUE(json.is_object()) << told;
}

/// So much that a file with such primitives would be refused.
TEST(GltfLevels, DamagedOnesThatClaimTooMuchCostNothingElse) {
  const auto [told, json] = with_damaged_levels([](GltfBuilder& file, GltfJson& levels) {
    constexpr std::size_t mega = 1 << 20;
    const std::size_t view = file.add_view(std::vector<std::byte>(mega));
    const GltfJson level = levels[0];
    while (levels.size() < 200) levels.push_back(level);
    for (std::size_t i = 0; i < levels.size(); ++i) {
      levels[i]["indices"] = file.add_accessor(view, 2 * i, 5123, "SCALAR", mega / 2 - 300);
    }
  });
  EXPECT_NE(told.find("because they overlap"), std::string::npos) << told;
  EXPECT_TRUE(json.is_object());
}

TEST(GltfLevels, ALoopOfNodesAndOddCoverageStayAsTheyCame) {
  GltfBuilder loop = with_lods();
  loop.json["nodes"][1]["extensions"]["MSFT_lod"]["ids"] = {0};
  EXPECT_EQ(write(read(loop)), loop.glb());
  for (const std::size_t numbers : {0, 1, 5}) {
    GltfBuilder builder = with_lods();
    builder.json["nodes"][0]["extras"]["MSFT_screencoverage"] = std::vector<double>(numbers, 0.1);
    const Scene scene = read(builder);
    EXPECT_EQ(scene.draws[0].levels.size(), 3u);
    EXPECT_EQ(write(scene), builder.glb());
  }
}

TEST(GltfLevels, OfASkinnedCharacterFollowOneSkin) {
  Scene scene = read(puppet());
  Draw& draw = scene.draws[0];
  for (const std::size_t triangles : {4u, 2u}) {
    Level level = draw.full();
    const auto all = draw.full().stream().indices.view();
    level.stream().indices =
        Shared<std::uint32_t>(std::vector<std::uint32_t>(all.begin(), all.begin() + 3 * triangles));
    draw.levels.push_back(std::move(level));
  }
  const Scene again = read(write(scene));
  ASSERT_EQ(again.draws.size(), 1u);
  ASSERT_EQ(again.draws[0].levels.size(), 3u);
  EXPECT_EQ(again.draws[0].levels[2].vertices, again.draws[0].full().vertices);
  EXPECT_TRUE(again.draws[0].traits.has(traits::skinned));
  const Result result = run("tipsify, linear-clusters, occlusion-order, vertex-fetch", again);
  EXPECT_FALSE(result.failed);
  EXPECT_EQ(read(write(result.scene)).draws[0].levels.size(), 3u);
}

}  // namespace
}  // namespace foredraw::gltf_levels_test
