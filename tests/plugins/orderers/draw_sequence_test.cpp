#include "plugins/orderers/draw_sequence/draw_sequence.h"

#include "framework/io/gltf/edits.h"
#include "support/overdraw.h"
#include "support/painter.h"

#include <foredraw/io/image/images.h>
#include <foredraw/overdraw/cluster_layers.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/technique/built_in_plugins.h>
#include <foredraw/viewing/subject_geometry.h>
#include <foredraw/viewing/view_set.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace foredraw::draw_sequence_test {
namespace {

using namespace testing;
using ::testing::HasSubstr;

/// A file of one mesh. Sphere i is its primitive i, with material i, whose name is also in the primitive's extras.
GltfBuilder spheres(const std::vector<float>& radii) {
  GltfBuilder made;
  std::vector<GltfJson> primitives;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const TestMesh sphere = testing::sphere(16, 8, radii[i]);
    std::vector<float> positions;
    for (const glm::vec3& p : sphere.positions) positions.insert(positions.end(), {p.x, p.y, p.z});
    const std::size_t position = made.add_values(positions, "VEC3");
    made.json["accessors"][position]["min"] = {-radii[i], -radii[i], -radii[i]};
    made.json["accessors"][position]["max"] = {radii[i], radii[i], radii[i]};
    const std::size_t index = made.add_values(sphere.indices, "SCALAR");
    const std::string name = "material " + std::to_string(i);
    made.add("materials", {{"name", name}});
    primitives.push_back(
        {{"attributes", {{"POSITION", position}}}, {"indices", index}, {"material", i}, {"extras", {{"name", name}}}});
  }
  made.add_mesh(primitives[0]);
  for (std::size_t i = 1; i < radii.size(); ++i) made.json["meshes"][0]["primitives"].push_back(primitives[i]);
  made.json["scenes"] = {{{"nodes", {0}}}};
  made.json["scene"] = 0;
  return made;
}

/// The spheres as a character has them: each is a mesh of its own, which a child of a joint shows.
GltfBuilder jointed_spheres(const std::vector<float>& radii) {
  GltfBuilder made = spheres(radii);
  const GltfJson primitives = made.json["meshes"][0]["primitives"];
  made.json["meshes"] = GltfJson::array();
  made.json["nodes"] = {{{"name", "root"}, {"children", GltfJson::array()}}};
  for (std::size_t i = 0; i < radii.size(); ++i) {
    made.json["nodes"][0]["children"].push_back(i + 1);
    made.add_mesh(primitives[i]);
    made.json["nodes"][i + 1]["name"] = "bone " + std::to_string(i);
  }
  made.json["skins"] = {{{"joints", {0}}}};
  return made;
}

Result run(const Scene& scene, int threads = 2, const std::string& views = "") {
  Registry registry;
  add_built_in_plugins(registry);
  Diagnostics diagnostics;
  const auto pipeline = parse_file("pipeline = 1\nstages = [\"draw-sequence\"]\n" + views, "test.toml", diagnostics);
  const auto plan = pipeline ? foredraw::plan(*pipeline, registry, scene, diagnostics) : std::nullopt;
  if (!plan) throw std::runtime_error(to_text(diagnostics));
  const Executor executor(threads);
  Analyses analyses(image_decoder({}));
  return optimize(*plan, scene, {executor, analyses});
}

std::string reason(const Result& result) {
  const auto& skipped = result.report.stages.at(0).skipped;
  return skipped.empty() ? "" : skipped.at(0).reason;
}

std::vector<std::string> extras_of(const GltfJson& json, std::size_t mesh = 0) {
  std::vector<std::string> names;
  for (const GltfJson& primitive : json["meshes"][mesh]["primitives"]) names.push_back(primitive["extras"]["name"]);
  return names;
}

using Names = std::vector<std::string>;
using Draws = std::vector<DrawId>;

TEST(DrawSequencePlugin, DrawsTheOuterShellFirst) {
  const Scene scene = read(spheres({0.5f, 1, 0.75f}));
  const Result result = run(scene);
  EXPECT_EQ(result.scene.meshes[0].draws, (Draws{1, 0, 2}));
  EXPECT_EQ(result.scene.draws[0].name, scene.draws[0].name) << "no draw has another number";
  ASSERT_EQ(result.report.stages.at(0).notes.size(), 1u);
  EXPECT_THAT(result.report.stages[0].notes[0].message, HasSubstr("overdraw between draws falls from 1.25"));
  EXPECT_EQ(reason(run(result.scene)), "no sequence of its draws was found in which less is overdrawn");
}

TEST(DrawSequencePlugin, MaterialsAndExtrasFollowThroughTheFile) {
  const GltfBuilder built = spheres({0.5f, 1, 0.75f});
  const GltfJson before = json_of(built.glb());
  const Bytes after = write(run(read(built)).scene);
  EXPECT_EQ(after.size(), built.glb().size()) << "no byte more";
  GltfJson json = json_of(after);
  EXPECT_EQ(extras_of(json), (Names{"material 1", "material 0", "material 2"}));
  for (const GltfJson& primitive : json["meshes"][0]["primitives"]) {
    EXPECT_EQ(primitive["extras"]["name"], json["materials"][primitive["material"].get<std::size_t>()]["name"]);
  }
  json["meshes"] = before["meshes"];
  EXPECT_EQ(json, before) << "nothing else";
  EXPECT_EQ(write(read(after)), after);
}

TEST(DrawSequencePlugin, NodesComeInAnotherSequenceUnderTheirNumbers) {
  const GltfBuilder built = jointed_spheres({0.5f, 1, 0.75f});
  const GltfJson before = json_of(built.glb());
  const Bytes after = write(run(read(built)).scene);
  EXPECT_EQ(after.size(), built.glb().size());
  GltfJson json = json_of(after);
  EXPECT_EQ(json["nodes"][0]["children"], (GltfJson{2, 1, 3}));
  json["nodes"][0]["children"] = before["nodes"][0]["children"];
  EXPECT_EQ(json, before);
  const Subject subject = subjects_of(read(after))[0];
  EXPECT_EQ(subject.parts, (std::vector<SubjectPart>{{1, 2}, {0, 1}, {2, 3}}));
}

TEST(DrawSequencePlugin, RootsOfASceneThatIsOneThingComeInAnotherSequence) {
  GltfBuilder built = jointed_spheres({0.5f, 1, 0.75f});
  built.json.erase("skins");
  built.json["nodes"][0].erase("children");
  built.json["scenes"] = {{{"nodes", {1, 3, 2}}}};  // 0 is in no scene
  const GltfJson before = json_of(built.glb());
  const std::string whole = "[subjects]\nsubject = \"scene\"\n";
  const Bytes after = write(run(read(built), 2, whole).scene);
  GltfJson json = json_of(after);
  EXPECT_EQ(json["scenes"][0]["nodes"], (GltfJson{2, 1, 3}));
  json["scenes"] = before["scenes"];
  EXPECT_EQ(json, before) << "nothing else";
  EXPECT_EQ(write(read(after)), after);
  built.json["scenes"].push_back({{"nodes", {2}}});
  const Result shared = run(read(built), 2, whole);
  EXPECT_EQ(shared.scene.roots, (std::vector<NodeId>{3, 1, 2})) << "the outermost stays: another scene shows it";
}

TEST(DrawSequencePlugin, NothingPassesWhatIsBlended) {
  GltfBuilder built = spheres({0.4f, 0.6f, 0.8f, 0.9f, 1});
  built.json["materials"][2]["alphaMode"] = "BLEND";
  EXPECT_EQ(run(read(built)).scene.meshes[0].draws, (Draws{1, 0, 2, 4, 3}));
  built.json["materials"][1]["alphaMode"] = "BLEND";
  built.json["materials"][3]["alphaMode"] = "BLEND";
  EXPECT_EQ(reason(run(read(built))), "alpha-blended, so its order may be visible (blended = true reorders it anyway)");
  EXPECT_EQ(run(read(built)).scene.meshes[0].draws, (Draws{0, 1, 2, 3, 4}));
}

TEST(DrawSequencePlugin, MaskedDrawsMoveAsOthersDo) {
  GltfBuilder built = spheres({0.5f, 1});
  built.json["materials"][1]["alphaMode"] = "MASK";  // without a texture it has no holes
  EXPECT_EQ(run(read(built)).scene.meshes[0].draws, (Draws{1, 0}));
}

TEST(DrawSequencePlugin, WhatCanNotMoveIsToldWhy) {
  EXPECT_EQ(reason(run(read(spheres({1})))), "a single draw has no sequence");
  EXPECT_EQ(reason(run(read(spheres({1, 0.5f})))), "no sequence of its draws was found in which less is overdrawn");
  GltfBuilder spoken_of = spheres({0.5f, 1});
  spoken_of.json["extensionsUsed"] = {"EXT_of_primitives"};
  spoken_of.json["extensions"] = {{"EXT_of_primitives", {{"primitive", {0, 1}}}}};
  EXPECT_EQ(reason(run(read(spoken_of))), "none of its draws can change places in the file");
  EXPECT_THAT(reason(run(read(spheres({0.5f, 1})), 2, "[views]\nviews = \"fibonacci\"\ncount = 3")),
              HasSubstr("too few views"));
}

TEST(DrawSequencePlugin, GivesTheSameBytesAtAnyThreadCount) {
  const Scene scene = read(jointed_spheres({0.3f, 0.5f, 1, 0.4f, 0.9f, 0.8f}));
  EXPECT_EQ(write(run(scene, 1).scene), write(run(scene, 3).scene));
}

/// Two quads, of which the second hides the first from some of the looks.
SubjectLayers quads_seen(const std::vector<glm::dvec3>& directions) {
  const TestMesh far = testing::quad(0), near = testing::quad(1);
  const std::vector<RasterPart> parts = {{far.positions, far.indices, false}, {near.positions, near.indices, false}};
  SubjectLayers seen;
  Views views{{}, 32};
  for (const glm::dvec3& direction : directions) {
    views.views.push_back({direction});
    seen.weights.push_back(1);
  }
  const Executor executor(1);
  const auto half = static_cast<std::uint32_t>(far.indices.size() / 3);
  static_cast<Layers&>(seen.layers) =
      cluster_layers(fragment_layers(parts, views, executor).value(), {{0, half, 2 * half}}, executor);
  seen.owners = {{0, 0, 0}, {1, 1, 0}};
  return seen;
}

TEST(JudgedSequence, IsJudgedByLooksThatDecidedNothing) {
  const Executor executor(1);
  const std::vector<PartGroup> groups = {{{0, 1, 2}}};
  std::vector<glm::dvec3> directions(10, {0, 0, 1});
  const JudgedSequence agreed = judged_sequence(quads_seen(directions), 2, groups, {}, executor);
  EXPECT_EQ(agreed.sequence, (std::vector<std::uint32_t>{1, 0}));
  EXPECT_EQ(agreed.before.shaded, 2 * agreed.before.visible);
  EXPECT_EQ(agreed.after.shaded, agreed.after.visible);
  for (std::size_t look = 0; look < directions.size(); ++look) {  // each alone says the contrary
    directions[look] = {0, 0, -1};
    const JudgedSequence one_differs = judged_sequence(quads_seen(directions), 2, groups, {}, executor);
    EXPECT_EQ(one_differs.sequence, agreed.sequence);
    EXPECT_LE(one_differs.after.shaded, one_differs.before.shaded);
    directions[look] = {0, 0, 1};
  }
}

/// The least that any sequence of the parts shades.
std::int64_t least_of_all(const PartLists& lists) {
  std::vector<std::uint32_t> sequence(lists.parts);
  std::iota(sequence.begin(), sequence.end(), 0u);
  std::int64_t least = fragments_shaded(lists, sequence);
  while (std::ranges::next_permutation(sequence).found) least = std::min(least, fragments_shaded(lists, sequence));
  return least;
}

TEST(JudgedSequence, OfEightDrawsIsTheBestOfAll) {
  const Executor executor(2);
  Analyses analyses;
  const Views views = make_views({.views = "fibonacci", .count = 20, .size = 48});
  for (const char* model : {"static/chess_board_notex", "static/flight_helmet_notex", "animated/robot_expressive"}) {
    Diagnostics diagnostics;
    const auto scene =
        read_gltf(testing::project_file("benchmarks/corpus/" + std::string(model) + ".glb"), diagnostics);
    ASSERT_TRUE(scene) << to_text(diagnostics);
    Subject whole;
    for (NodeId node = 0; node < scene->nodes.size(); ++node) {
      if (!scene->nodes[node].mesh) continue;
      for (const DrawId draw : scene->meshes[*scene->nodes[node].mesh].draws) {
        if (whole.parts.size() < 8) whole.parts.push_back({draw, node});
      }
    }
    const SubjectGeometry drawn =
        subject_geometry(*scene, whole, Faces::material, posed_nodes(*scene, Pose{}), analyses);
    Clusters parts{{0}};
    std::vector<std::uint32_t> part_of;
    for (const RasterPart& part : drawn.parts) {
      if (part.indices.empty()) continue;  // blended
      part_of.push_back(static_cast<std::uint32_t>(part_of.size()));
      parts.offsets.push_back(parts.offsets.back() + static_cast<std::uint32_t>(part.indices.size() / 3));
    }
    const ClusterLayers layers = cluster_layers(fragment_layers(drawn.parts, views, executor).value(), parts, executor);
    const auto count = static_cast<std::uint32_t>(part_of.size());
    const PartLists lists = part_lists(layers, part_of, count, std::vector<std::int64_t>(views.views.size(), 1));
    part_of.push_back(count);
    const std::vector<PartGroup> groups = {{part_of}};
    EXPECT_GE(count, 5u);
    EXPECT_EQ(fragments_shaded(lists, draw_sequence(lists, groups, {}, executor)), least_of_all(lists)) << model;
  }
}

}  // namespace
}  // namespace foredraw::draw_sequence_test
