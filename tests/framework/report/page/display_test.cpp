#include <foredraw/report/page/display.h>

#include "support/meshes.h"

#include <foredraw/io/scene_file.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/scene/reorder.h>
#include <foredraw/technique/built_in_plugins.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstring>

namespace foredraw {
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
};

TEST(Display, HoldsTheInputsTrianglesAndHowAPipelineSortsThem) {
  const Shown shown("static/spot.glb", R"(pipeline = 1
stages = ["weld", "lookahead", "linear-clusters", "dot-rule", "vertex-fetch"])");
  EXPECT_EQ(shown.scene["file"], 3);
  EXPECT_EQ(shown.scene["buffer"], "buffer-3");
  ASSERT_EQ(shown.scene["subjects"].size(), 1u);
  const Json& subject = shown.scene["subjects"][0];
  const Json& part = subject["parts"][0];
  const std::size_t triangles = part["triangles"];
  const auto given = shown.input.draws[0].levels[0].orders[0].indices.view();
  ASSERT_EQ(triangles, given.size() / 3);
  EXPECT_EQ(shown.numbers<std::uint32_t>(part["indices"], 3 * triangles),
            std::vector<std::uint32_t>(given.begin(), given.end()));

  ASSERT_EQ(subject["states"].size(), 3u);
  EXPECT_EQ(subject["states"][2], nullptr);
  EXPECT_EQ(subject["absent"], Json::parse(R"({"2": "could not be planned for this file"})"));
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
  EXPECT_NEAR(subject["radius"], 1.0, 0.5);
}

TEST(Display, HoldsTheFirstPipelinesOfMany) {
  const Scene scene = testing::scene_of(testing::grid(2, 2));
  const std::vector<std::optional<Scene>> branches(30, scene);
  const Json subject = Json::parse(display(scene, branches, 0).scene)["subjects"][0];
  EXPECT_EQ(subject["states"].size(), 31u);
  EXPECT_NE(subject["states"][24], nullptr);
  EXPECT_EQ(subject["states"][25], nullptr);
  EXPECT_EQ(subject["absent"]["25"], "only the first 24 are shown");
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
  const std::size_t triangles = subject["parts"][0]["triangles"];
  const auto first = shown.output.draws[0].levels[0].orders;
  ASSERT_EQ(first.size(), 3u);
  const auto corners = shown.input.draws[0].levels[0].orders[0].indices.view();
  for (std::size_t k = 0; k < 3; ++k) {
    const auto sorted = shown.numbers<std::uint32_t>(state["orders"][k][0]["triangles"], triangles);
    ASSERT_TRUE(is_permutation(sorted, triangles));
    std::vector<std::uint32_t> drawn;
    for (const std::uint32_t t : sorted)
      drawn.insert(drawn.end(), {corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]});
    const auto stored = first[k].indices.view();
    EXPECT_EQ(drawn, std::vector<std::uint32_t>(stored.begin(), stored.end())) << k;
  }
  const Json& table = state["table"];
  std::size_t keyframes = 0;
  for (const Json& clip : table["clips"]) keyframes += clip["times"].size();
  EXPECT_EQ(table["order"].size(),
            keyframes * table["theta-steps"].get<std::size_t>() * table["phi-steps"].get<std::size_t>());
  EXPECT_EQ(subject["states"][0]["table"], nullptr);
  // Poses differ, and each is whole.
  const Json& positions = subject["parts"][0]["positions"];
  EXPECT_NE(positions[0], positions[1]);
}

}  // namespace
}  // namespace foredraw
