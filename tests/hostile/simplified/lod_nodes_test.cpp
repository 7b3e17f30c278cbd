// Levels that came as nodes, with MSFT_lod that says the impossible: through the program and each of its presets. What
// is no level stays as it came.
#include "odd_models.h"
#include "plain_messages.h"

#include "support/meshes.h"

#include <functional>
#include <map>

namespace foredraw::lod_nodes_test {
namespace {

using testing::Ended;
using testing::GltfBuilder;
using testing::GltfJson;

GltfJson attributes_of(const GltfBuilder& file) { return file.json["meshes"][0]["primitives"][0]["attributes"]; }

/// A torus, and two coarser ones as its levels: the same vertices, and the first triangles of all.
GltfBuilder with_lods() {
  GltfBuilder file = testing::plain_model(24, 12);
  for (const std::size_t triangles : {288u, 96u}) {
    GltfJson primitive{{"attributes", attributes_of(file)}};
    std::vector<std::uint32_t> indices = testing::torus(24, 12).indices;
    indices.resize(3 * triangles);
    primitive["indices"] = file.add_values(indices, "SCALAR");
    file.add_mesh({});
    file.json["meshes"].back()["primitives"] = GltfJson::array({primitive});
  }
  file.json["scenes"] = GltfJson::array({{{"nodes", {0}}}});
  file.json["scene"] = 0;
  file.json["extensionsUsed"] = {"MSFT_lod"};
  file.json["nodes"][0]["extensions"]["MSFT_lod"]["ids"] = {1, 2};
  file.json["nodes"][0]["extras"]["MSFT_screencoverage"] = {0.5, 0.2, 0.01};
  return file;
}

std::map<std::string, std::function<void(GltfJson&)>> damages() {
  const auto ids = [](GltfJson value) {
    return [value](GltfJson& json) { json["nodes"][0]["extensions"]["MSFT_lod"]["ids"] = value; };
  };
  const auto coverage = [](GltfJson value) {
    return [value](GltfJson& json) { json["nodes"][0]["extras"]["MSFT_screencoverage"] = value; };
  };
  return {{"none", [](GltfJson&) {}},
          {"a loop", [](GltfJson& json) { json["nodes"][1]["extensions"]["MSFT_lod"]["ids"] = {0}; }},
          {"a loop of one", [](GltfJson& json) { json["nodes"][1]["extensions"]["MSFT_lod"]["ids"] = {1}; }},
          {"a nest", [](GltfJson& json) { json["nodes"][1]["extensions"]["MSFT_lod"]["ids"] = {2}; }},
          {"itself", ids({0})},
          {"itself and others", ids({1, 0, 2})},
          {"one twice", ids({1, 1})},
          {"out of range", ids({1, 9})},
          {"far out of range", ids({4294967296})},
          {"negative", ids({-1})},
          {"a fraction", ids({0.5})},
          {"a text", ids("1, 2")},
          {"nothing", ids(nullptr)},
          {"no ids", ids(GltfJson::array())},
          {"no object", [](GltfJson& json) { json["nodes"][0]["extensions"]["MSFT_lod"] = 3; }},
          {"long coverage", coverage({0.5, 0.4, 0.3, 0.2, 0.1})},
          {"short coverage", coverage({0.5})},
          {"no coverage", coverage(GltfJson::array())},
          {"coverage of texts", coverage({"a", "b", "c"})},
          {"coverage that rises", coverage({0, 1e308, -1})},
          {"coverage that is a number", coverage(3)},
          {"extras that are a number", [](GltfJson& json) { json["nodes"][0]["extras"] = 3; }},
          {"extras that are a list",
           [](GltfJson& json) {
             json["nodes"][0]["extras"] = {1, 2};
           }},
          {"in the scene too", [](GltfJson& json) {
             json["scenes"][0]["nodes"] = {0, 1, 2};
           }}};
}

/// How many primitives of the file are drawn, whoever draws them.
std::size_t triangles_of(const GltfJson& json) {
  std::size_t corners = 0;
  for (const GltfJson& mesh : json["meshes"]) {
    for (const GltfJson& primitive : mesh["primitives"]) {
      corners += json["accessors"][primitive["indices"].get<std::size_t>()]["count"].get<std::size_t>();
    }
  }
  return corners / 3;
}

class LodNodes : public testing::InFolder {
 protected:
  LodNodes() {
    std::filesystem::create_directory(folder_ / "in");
    for (const auto& [name, damage] : damages()) {
      GltfBuilder file = with_lods();
      damage(file.json);
      const std::vector<std::byte> bytes = file.glb();
      testing::put(folder_ / "in" / (name + ".glb"), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
  }

  static GltfJson json_in(const std::filesystem::path& path) {
    const std::string bytes = testing::content(path);
    return testing::json_of(std::as_bytes(std::span(bytes)));
  }

  Ended run(const std::string& arguments) {
    const Ended ended = testing::run_program(folder_, arguments);
    testing::expect_plain_messages(ended, arguments);
    EXPECT_EQ(ended.code, 0) << arguments << '\n' << ended.err;
    return ended;
  }
};

TEST_F(LodNodes, ThatSayTheImpossibleGoThroughEachPreset) {
  run("measure in --with vertex-cache");
  for (const char* preset : {"@default", "@simplify", "@levels", "@streaming"}) {
    run(std::string("optimize in -o out -p ") + preset + " --with vertex-cache");
    for (const auto& [name, damage] : damages()) {
      SCOPED_TRACE(preset + (": " + name));
      GltfBuilder file = with_lods();
      damage(file.json);
      const GltfJson made = json_in(folder_ / "out" / (name + ".glb"));
      ASSERT_EQ(made["nodes"].size(), 3u);
      EXPECT_EQ(made["nodes"][0]["extensions"], file.json["nodes"][0]["extensions"]);
      EXPECT_EQ(made["nodes"][0]["extras"], file.json["nodes"][0]["extras"]);
      if (preset != std::string("@simplify")) {
        EXPECT_EQ(triangles_of(made), triangles_of(file.json));
      }
      EXPECT_GT(triangles_of(made), 0u);
    }
    std::filesystem::remove_all(folder_ / "out");
  }
}

}  // namespace
}  // namespace foredraw::lod_nodes_test
