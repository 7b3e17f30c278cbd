#include <foredraw/page/display.h>

#include "support/meshes.h"

#include <foredraw/io/scene_file.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/scene/levels.h>
#include <foredraw/scene/order_table.h>
#include <foredraw/scene/reorder.h>
#include <foredraw/technique/built_in_plugins.h>
#include <foredraw/viewing/pose_set.h>
#include <foredraw/viewing/posed_positions.h>
#include <foredraw/wires/wires.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <set>

namespace foredraw::display_test {
namespace {

using Json = nlohmann::json;

std::vector<std::byte> decoded(const std::string& base64) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::byte> bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : base64) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(letters.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<std::byte>(bits >> count & 255));
  }
  return bytes;
}

/// What a page would show of a model after a pipeline.
struct Shown {
  Shown(const std::string& model, const std::string& text) {
    Diagnostics diagnostics;
    const std::string path = testing::project_file("benchmarks/corpus/" + model).string();
    input = read_scene(path, diagnostics)->scene;
    Registry registry;
    add_built_in_plugins(registry);
    Analyses analyses;
    const Executor executor(1);
    auto planned = plan(*parse_file(text, "p.toml", diagnostics), registry, input, diagnostics);
    planned->measures.clear();
    output = optimize(*planned, input, {executor, analyses}).scene;
    const std::optional<Scene> branches[] = {output, std::nullopt};
    const Display made = display(input, branches, 3);
    scene = Json::parse(made.scene);
    bytes = decoded(made.buffer);
    has_wires = made.has_wires;
  }

  template <class T>
  std::vector<T> numbers(const Json& offset, std::size_t count) const {
    std::vector<T> values(count);
    EXPECT_LE(offset.get<std::size_t>() + count * sizeof(T), bytes.size());
    std::memcpy(values.data(), bytes.data() + offset.get<std::size_t>(), count * sizeof(T));
    return values;
  }

  Scene input, output;
  Json scene;
  std::vector<std::byte> bytes;
  bool has_wires = false;
};

TEST(Display, HoldsTheInputsTrianglesAndHowAPipelineSortsThem) {
  const Shown shown("static/spot.glb", R"(pipeline = 1
stages = ["weld", "lookahead", "linear-clusters", "dot-rule", "vertex-fetch"])");
  EXPECT_EQ(shown.scene["file"], 3);
  EXPECT_EQ(shown.scene["buffer"], "buffer-3");
  ASSERT_EQ(shown.scene["subjects"].size(), 1u);
  const Json& subject = shown.scene["subjects"][0];
  ASSERT_EQ(subject["geometries"].size(), 1u);
  const Json& geometry = subject["geometries"][0];
  const Json& part = geometry["parts"][0];
  const std::size_t triangles = part["triangles"];
  const auto given = shown.input.draws[0].levels[0].orders[0].indices.view();
  ASSERT_EQ(triangles, given.size() / 3);
  const auto indices = shown.numbers<std::uint32_t>(part["indices"], 3 * triangles);
  const auto places = shown.numbers<float>(part["positions"][0], 3 * part["vertices"].get<std::size_t>());
  const auto positions = decode_vec3(*shown.input.draws[0].full().vertices->find("POSITION"));
  EXPECT_LT(part["vertices"], positions.size());  // those along seams are one here
  for (std::size_t i = 0; i < given.size(); ++i) {
    const float* at = &places[3 * std::size_t{indices[i]}];
    ASSERT_EQ(glm::vec3(at[0], at[1], at[2]), positions[given[i]]) << i;
  }

  ASSERT_EQ(subject["states"].size(), 3u);
  EXPECT_EQ(subject["states"][2], nullptr);
  EXPECT_EQ(subject["absent"], Json::parse(R"({"2": "could not be planned for this file"})"));
  EXPECT_EQ(subject["states"][1]["geometry"], 0);
  const Json& order = subject["states"][1]["orders"][0][0];
  const auto sorted = shown.numbers<std::uint32_t>(order["triangles"], triangles);
  EXPECT_TRUE(is_permutation(sorted, triangles));
  const IndexStream& stream = shown.output.draws[0].levels[0].orders[0];
  EXPECT_EQ(sorted,
            std::vector<std::uint32_t>(stream.triangle_origin.view().begin(), stream.triangle_origin.view().end()));
  const std::size_t clusters = order["cluster-count"];
  EXPECT_EQ(shown.numbers<std::uint32_t>(order["clusters"], clusters + 1), stream.clusters->offsets);

  EXPECT_EQ(subject["poses"].size(), 1u);
  EXPECT_EQ(subject["poses"][0]["clip"], nullptr);
  EXPECT_NEAR(geometry["radius"], 1.0, 0.5);
}

TEST(Display, HoldsTheFirstPipelinesOfMany) {
  const Scene scene = testing::scene_of(testing::grid(2, 2));
  const std::vector<std::optional<Scene>> branches(30, scene);
  const Json subject = Json::parse(display(scene, branches, 0).scene)["subjects"][0];
  EXPECT_EQ(subject["states"].size(), 31u);
  EXPECT_NE(subject["states"][24], nullptr);
  EXPECT_EQ(subject["states"][25], nullptr);
  EXPECT_EQ(subject["absent"]["25"], "only the first 24 pipelines are");
  EXPECT_EQ(subject["geometries"].size(), 1u);
}

TEST(Display, HoldsTheSequencesOfTheTable) {
  const Shown shown("animated/robot_expressive.glb", R"(pipeline = 1
stages = ["draw-sequence", { use = "occlusion-order", k = 3, quality = "fast" }]
views.size = 64
poses.poses = "4")");
  const Json& states = shown.scene["subjects"][0]["states"];
  const Subject walked = subjects_of(shown.output)[0];
  ASSERT_EQ(order_tables(shown.output).size(), 1u);
  const OrderTable& table = order_tables(shown.output)[0];
  ASSERT_FALSE(table.parts.empty());
  EXPECT_TRUE(states[0]["sequences"].is_null());
  ASSERT_EQ(states[1]["sequences"].size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t rank = 0; rank < walked.parts.size(); ++rank) {
      const std::size_t part = states[1]["sequences"][k][rank];
      EXPECT_EQ(walked.parts[part], table.parts[table.sequence(k)[rank]]) << k << ' ' << rank;
    }
  }
}

TEST(Display, HoldsEveryOrderOfACharacterItsTableAndItsPoses) {
  const Shown shown("animated/fox.glb", R"(pipeline = 1
stages = [{ use = "lookahead", quality = "fast" }, { use = "occlusion-order", k = 3 }]
poses.poses = "6")");
  const Json& subject = shown.scene["subjects"][0];
  EXPECT_GT(subject["poses"].size(), 10u);
  EXPECT_LE(subject["poses"].size(), 64u);
  const Json& state = subject["states"][1];
  ASSERT_EQ(state["orders"].size(), 3u);
  const Json& part = subject["geometries"][0]["parts"][0];
  const std::size_t triangles = part["triangles"];
  const auto indices = shown.numbers<std::uint32_t>(part["indices"], 3 * triangles);
  const auto first = shown.output.draws[0].levels[0].orders;
  ASSERT_EQ(first.size(), 3u);
  const auto places = shown.numbers<float>(part["positions"][0], 3 * part["vertices"].get<std::size_t>());
  const Pose pose{0, subject["poses"][0]["time"]};
  const auto posed =
      posed_positions(shown.output, {0, subjects_of(shown.output)[0].parts[0].node}, posed_nodes(shown.output, pose));
  for (std::size_t k = 0; k < 3; ++k) {
    const auto sorted = shown.numbers<std::uint32_t>(state["orders"][k][0]["triangles"], triangles);
    ASSERT_TRUE(is_permutation(sorted, triangles));
    const auto stored = first[k].indices.view();
    for (std::size_t i = 0; i < stored.size(); ++i) {
      const float* at = &places[3 * std::size_t{indices[3 * std::size_t{sorted[i / 3]} + i % 3]}];
      ASSERT_EQ(glm::vec3(at[0], at[1], at[2]), posed[stored[i]]) << k;
    }
  }
  const Json& table = state["table"];
  std::size_t keyframes = 0;
  for (const Json& clip : table["clips"]) keyframes += clip["times"].size();
  EXPECT_EQ(table["order"].size(),
            keyframes * table["theta-steps"].get<std::size_t>() * table["phi-steps"].get<std::size_t>());
  EXPECT_EQ(subject["states"][0]["table"], nullptr);
  // Poses differ, and each is whole.
  const Json& positions = part["positions"];
  EXPECT_NE(positions[0], positions[1]);
}

AnimationId clip_named(const Scene& scene, const std::string& name) {
  const std::vector<std::string> names = clip_names(scene);
  return static_cast<AnimationId>(std::ranges::find(names, name) - names.begin());
}

using Corner = std::array<float, 3>;
using Corners = std::array<Corner, 3>;

/// Those that are no lines, each begun at its least corner. `vertex`: [index] which of the positions.
std::multiset<Corners> proper_triangles(std::span<const std::uint32_t> indices, std::span<const float> positions,
                                        const auto& vertex) {
  std::multiset<Corners> all;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    Corners corners;
    for (std::size_t c = 0; c < 3; ++c) {
      std::copy_n(positions.begin() + static_cast<std::ptrdiff_t>(3 * std::size_t{vertex(indices[i + c])}), 3,
                  corners[c].begin());
    }
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
    all.insert(corners);
  }
  return all;
}

TEST(Display, HoldsCoarserLevelsPosedAndWhatVerticesBecomeThere) {
  const Shown shown("animated/fox.glb", R"(pipeline = 1
stages = ["weld", "quadric-collapse", { use = "levels", keep-sequences = true }, "geomorphs", "vertex-fetch"])");
  const Json& subject = shown.scene["subjects"][0];
  EXPECT_FALSE(subject["states"][0].contains("levels"));
  std::vector<Json> levels{subject["states"][1]};
  EXPECT_FALSE(levels[0].contains("error"));
  for (const Json& coarser : levels[0]["levels"]) levels.push_back(coarser);
  ASSERT_EQ(levels.size(), 4u);
  const std::size_t last = subject["poses"].size() - 1;
  const Pose pose{clip_named(shown.output, subject["poses"][last]["clip"]), subject["poses"][last]["time"]};
  const auto part_of = [&](std::size_t l) {
    return subject["geometries"][levels[l]["geometry"].get<std::size_t>()]["parts"][0];
  };
  const auto positions_of = [&](const Json& part) {
    return shown.numbers<float>(part["positions"][last], 3 * part["vertices"].get<std::size_t>());
  };
  const auto indices_of = [&](const Json& part) {
    return shown.numbers<std::uint32_t>(part["indices"], 3 * part["triangles"].get<std::size_t>());
  };
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const Level& level = shown.output.draws[0].levels[l];
    const Json part = part_of(l);
    EXPECT_EQ(part["triangles"], level.stream().triangle_count());
    const Scene alone = at_level(shown.output, l);
    const std::vector<glm::vec3> posed =
        posed_positions(alone, {0, subjects_of(alone)[0].parts[0].node}, posed_nodes(alone, pose));
    const std::vector<float> positions = positions_of(part);
    const auto as_they_are = [](std::uint32_t v) { return v; };
    const auto drawn = proper_triangles(indices_of(part), positions, as_they_are);
    EXPECT_EQ(drawn, proper_triangles(level.stream().indices.view(), {&posed[0].x, 3 * posed.size()}, as_they_are));
    if (l == 0) continue;
    EXPECT_NEAR(levels[l]["error"].get<double>(), level.error, 0.001 * level.error);
    const Json finer = part_of(l - 1);
    const auto ancestors =
        shown.numbers<std::uint32_t>(levels[l - 1]["ancestors"][0], finer["vertices"].get<std::size_t>());
    EXPECT_EQ(proper_triangles(indices_of(finer), positions, [&](std::uint32_t v) { return ancestors[v]; }), drawn);
  }
  EXPECT_FALSE(levels[3].contains("ancestors"));
}

/// A finer and a coarser sheet, the error of which is known.
TEST(Display, TellsErrorsOfLevelsAsTheyAreShown) {
  Scene scene = testing::scene_of(testing::grid(4, 4));
  const Scene coarse = testing::scene_of(testing::grid(2, 2));
  scene.draws[0].levels.push_back(coarse.draws[0].full());
  scene.draws[0].levels[1].error = 0.25f;
  scene.nodes[0].transform.scale = {2, 2, 2};
  const auto shown = [&](SubjectUnit unit) {
    return Json::parse(display(scene, {}, 0, unit).scene)["subjects"][0]["states"][0];
  };
  EXPECT_EQ(shown(SubjectUnit::mesh)["levels"][0]["error"], 0.25);  // in the mesh's own space
  EXPECT_EQ(shown(SubjectUnit::scene)["levels"][0]["error"], 0.5);
  EXPECT_EQ(shown(SubjectUnit::scene)["ancestors"], Json::parse("[null]"));
  scene.draws[0].levels[1].error = 0;
  EXPECT_FALSE(shown(SubjectUnit::scene)["levels"][0].contains("error"));
}

std::vector<std::string> names_of(const Json& geometry) {
  std::vector<std::string> names;
  for (const Json& part : geometry["parts"]) names.push_back(part["name"]);
  return names;
}

/// Two draws of one mesh, and what became of them.
struct TwoDraws {
  TwoDraws() {
    scene = testing::scene_of({testing::draw_of(testing::grid(2, 2), "a"), testing::draw_of(testing::grid(3, 3), "b")});
    scene.meshes = {{"both", {0, 1}, {}}};
    scene.nodes.pop_back();
    scene.materials = {{.double_sided = true}};
    for (Draw& draw : scene.draws) draw.material = 0;
  }

  Json shown(const Scene& after) const {
    const std::optional<Scene> branches[] = {after};
    return Json::parse(display(scene, branches, 0).scene)["subjects"][0];
  }

  Scene scene;
};

TEST(Display, ShowsTheSidesThatAPipelineMade) {
  const TwoDraws two;
  Scene after = two.scene;
  after.materials.push_back({.double_sided = false});
  after.draws[1].material = 1;
  const Json subject = two.shown(after);
  ASSERT_EQ(subject["geometries"].size(), 2u);
  EXPECT_EQ(subject["states"][1]["geometry"], 1);
  const Json& before = subject["geometries"][0]["parts"];
  const Json& now = subject["geometries"][1]["parts"];
  EXPECT_EQ(before[1]["double-sided"], true);
  EXPECT_EQ(now[0], before[0]);
  EXPECT_EQ(now[1]["double-sided"], false);
  EXPECT_EQ(now[1]["positions"], before[1]["positions"]);  // held once
}

TEST(Display, ShowsTheSequenceOfDrawsThatAPipelineMade) {
  const TwoDraws two;
  Scene after = two.scene;
  after.meshes[0].draws = {1, 0};
  const Json subject = two.shown(after);
  ASSERT_EQ(subject["geometries"].size(), 2u);
  EXPECT_EQ(names_of(subject["geometries"][0]), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(names_of(subject["geometries"][1]), (std::vector<std::string>{"b", "a"}));
}

TEST(Display, ShowsTrianglesThatAPipelineAdded) {
  const TwoDraws two;
  Scene after = two.scene;
  after.draws[0] = testing::draw_of(testing::joined(testing::grid(2, 2), testing::grid(1, 1)), "a");
  const Json subject = two.shown(after);
  EXPECT_EQ(subject["geometries"][0]["parts"][0]["triangles"], 8);
  EXPECT_EQ(subject["geometries"][1]["parts"][0]["triangles"], 10);
}

/// Of what draws them, and in the mesh's space; beside them the matrix to where they are shown.
TEST(Display, HoldsWiresOfThePipelineThatFoundThem) {
  const Shown shown("static/dutch_ship_medium_notex.glb", "pipeline = 1\nstages = [\"wire-radius\"]");
  EXPECT_TRUE(shown.has_wires);
  EXPECT_FALSE(Shown("static/spot.glb", "pipeline = 1\nstages = [\"wire-radius\"]").has_wires);
  const auto* wires = shown.output.products.find<Wires>();
  ASSERT_NE(wires, nullptr);
  std::size_t parts = 0;
  for (const Json& subject : shown.scene["subjects"]) {
    EXPECT_FALSE(subject["states"][0].contains("wires")) << "the input has none";
    const Json& state = subject["states"][1];
    if (!state.contains("wires")) continue;
    const Json& geometry = subject["geometries"][state["geometry"].get<std::size_t>()];
    for (std::size_t p = 0; p < state["wires"].size(); ++p) {
      const Json &of = state["wires"][p], &part = geometry["parts"][p];
      if (of.is_null()) continue;
      ++parts;
      const auto product =
          std::ranges::find(wires->draws, of["first"].get<std::uint32_t>(), &DrawWires::first_triangle);
      ASSERT_NE(product, wires->draws.end());
      const std::size_t first = product->first_triangle, triangles = part["triangles"], rows = of["row-count"];
      const auto corners = shown.numbers<std::uint32_t>(of["corners"], 3 * (triangles - first));
      const auto values = shown.numbers<float>(of["rows"], 11 * rows);
      const auto order = shown.numbers<std::uint32_t>(state["orders"][0][p]["triangles"], triangles);
      const auto indices = shown.numbers<std::uint32_t>(part["indices"], 3 * triangles);
      const auto positions = shown.numbers<float>(part["positions"][0], 3 * part["vertices"].get<std::size_t>());
      const auto matrix = of["from-mesh"][0].get<std::vector<float>>();
      for (std::size_t i = 0; i < corners.size(); ++i) {
        ASSERT_LT(corners[i], rows);
        const float* row = &values[11 * corners[i]];
        EXPECT_NE(row[6], 0) << "half a width";
        const std::size_t vertex = indices[3 * order[first + i / 3] + i % 3];
        for (std::size_t c = 0; c < 3; ++c) {
          const float at = matrix[c] * row[0] + matrix[4 + c] * row[1] + matrix[8 + c] * row[2] + matrix[12 + c];
          ASSERT_NEAR(at, positions[3 * vertex + c], 1e-3);
        }
      }
    }
  }
  EXPECT_EQ(parts, wires->draws.size());
}

TEST(Display, SaysWhyAStateIsNotShown) {
  const TwoDraws two;
  Scene split = two.scene;
  split.meshes = {{"one", {0}, {}}, {"two", {1}, {}}};
  EXPECT_EQ(two.shown(split)["absent"]["1"], "it has 2 subjects, the input has 1 subject");
  Scene blended = two.scene;
  blended.materials[0].alpha_mode = AlphaMode::blend;
  EXPECT_EQ(two.shown(blended)["absent"]["1"], "it draws no triangles of this subject");
}

TEST(Display, SaysWhatIsLeftOut) {
  TwoDraws two;
  two.scene.materials.push_back({.alpha_mode = AlphaMode::blend});
  two.scene.draws[0].material = 1;
  two.scene.materials[0].alpha_mode = AlphaMode::mask;
  EXPECT_EQ(two.shown(two.scene)["geometries"][0]["note"],
            "1 blended draw left out, as in the figures. The holes of 1 masked draw are not shown; figures leave them "
            "out, so ratios here differ");
}

TEST(Display, OfALargeSubjectHoldsNoMoreThanItSays) {
  std::vector<Draw> draws;
  for (std::uint32_t i = 0; i < 30; ++i) draws.push_back(testing::draw_of(testing::grid(70, 50 + i)));
  Scene scene = testing::scene_of(std::move(draws));
  Mesh whole;
  for (DrawId draw = 0; draw < scene.draws.size(); ++draw) whole.draws.push_back(draw);
  scene.meshes = {whole};
  scene.nodes.resize(1);
  const Json subject = Json::parse(display(scene, {}, 0).scene)["subjects"][0];
  std::size_t triangles = 0;
  for (const Json& part : subject["geometries"][0]["parts"]) triangles += part["triangles"].get<std::size_t>();
  EXPECT_LE(triangles, 200'000u);
  EXPECT_GT(triangles, 50'000u);
  EXPECT_NE(subject["geometries"][0]["note"].get<std::string>().find("of 270,900 triangles are shown"),
            std::string::npos);
}

}  // namespace
}  // namespace foredraw::display_test
