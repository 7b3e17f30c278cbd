// FOREDRAW_second_depth in files: what comes back, what is not believed, and the shaders beside it.
#include "plugins/processors/second_depth/second_depth_product.h"

#include "hidden_shapes.h"
#include "support/gltf_builder.h"
#include "support/meshes.h"
#include "support/staged.h"

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/side_files.h>
#include <foredraw/report/inspection.h>
#include <foredraw/shells/second_depth.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

namespace foredraw::second_depth_files_test {
namespace {

using testing::GltfJson;
using ::testing::HasSubstr;

constexpr const char* extension = "FOREDRAW_second_depth";

/// A sheet and a box in one draw.
Scene made() {
  const testing::TestMesh mesh = testing::joined(testing::grid(2, 2), testing::box(1, {0, 0, 3}));
  return testing::run("second-depth", testing::scene_of(mesh)).scene;
}

std::optional<Scene> read_again(std::vector<std::byte> file, Diagnostics& diagnostics) {
  return read_gltf(std::move(file), "again", {}, diagnostics, {.products = {second_depth_product()}});
}

std::vector<std::byte> written(const Scene& scene) {
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, "out.glb", diagnostics, {.products = {second_depth_product()}});
  if (!files || diagnostics.has_errors()) throw std::runtime_error(to_text(diagnostics));
  return files->front().bytes;
}

/// The file with its JSON changed.
template <class Change>
std::vector<std::byte> changed(const std::vector<std::byte>& glb, Change change) {
  std::uint32_t json_length = 0;
  std::memcpy(&json_length, glb.data() + 12, 4);
  GltfJson json = testing::json_of(glb);
  change(json);
  const std::vector<std::byte> bin(glb.begin() + 20 + json_length + 8, glb.end());
  return testing::glb_of(json.dump(), bin);
}

TEST(SecondDepthFiles, ComeBack) {
  const Scene scene = made();
  const std::vector<std::byte> file = written(scene);
  EXPECT_EQ(testing::json_of(file)["meshes"][0]["primitives"][0]["extensions"][extension]["triangles"], 12);
  Diagnostics diagnostics;
  const auto again = read_again(file, diagnostics);
  ASSERT_TRUE(again);
  EXPECT_TRUE(diagnostics.empty()) << to_text(diagnostics);
  ASSERT_TRUE(again->products.has(SecondDepth::product));
  EXPECT_EQ(*again->products.find<SecondDepth>(), *scene.products.find<SecondDepth>());
  EXPECT_EQ(written(*again), file);
  Analyses analyses;
  EXPECT_THAT(inspection_text(*again, {second_depth_product()}, analyses, Executor(1)),
              HasSubstr("mesh: the first 12 of 20 triangles are closed"));
}

TEST(SecondDepthFiles, ThatAreWrongAreLeftOutWithAWarning) {
  const std::vector<std::byte> file = written(made());
  const auto why = [&](GltfJson triangles, bool is_masked = false) {
    Diagnostics diagnostics;
    const auto scene = read_again(changed(file,
                                          [&](GltfJson& json) {
                                            GltfJson& primitive = json["meshes"][0]["primitives"][0];
                                            primitive["extensions"][extension]["triangles"] = triangles;
                                            if (!is_masked) return;
                                            json["materials"] = {{{"alphaMode", "MASK"}}};
                                            primitive["material"] = 0;
                                          }),
                                  diagnostics);
    EXPECT_TRUE(scene);
    EXPECT_FALSE(scene && scene->products.has(SecondDepth::product));
    EXPECT_EQ(diagnostics.all().size(), 1u) << to_text(diagnostics);
    return to_text(diagnostics);
  };
  for (const GltfJson& number : {GltfJson(0), GltfJson(-1), GltfJson(1.5), GltfJson("12"), GltfJson(5000000000)}) {
    EXPECT_THAT(why(number), HasSubstr("no whole number above 0 in 'triangles'"));
  }
  EXPECT_THAT(why(21), HasSubstr("has 20 triangles, not 21"));
  EXPECT_THAT(why(13), HasSubstr("are not closed shells"));
  EXPECT_THAT(why(11), HasSubstr("are not closed shells"));
  EXPECT_THAT(why(12, true), HasSubstr("is masked"));
}

TEST(SecondDepthFiles, HaveTheShadersBeside) {
  const Scene scene = made();
  for (const char* path : {"out.glsl", "out.hlsl"}) {
    Diagnostics diagnostics;
    const auto files = encode_side_file(scene, *second_depth_product(), path, diagnostics);
    ASSERT_TRUE(files) << to_text(diagnostics);
    const std::string text(reinterpret_cast<const char*>(files->front().bytes.data()), files->front().bytes.size());
    EXPECT_THAT(text, HasSubstr("float second_depth_edge(SecondDepthRule rule"));
  }
}

}  // namespace
}  // namespace foredraw::second_depth_files_test
