// Sequences of collapses, geomorphs and streams that are wrong in a file: they cost themselves alone.

#include "framework/io/gltf/edits.h"
#include "support/collapses.h"
#include "support/compressed_gltf.h"
#include "support/staged.h"

#include <foredraw/scene/levels.h>

#include <gtest/gtest.h>

#include <functional>

namespace foredraw::collapse_files_test {
namespace {

using namespace testing;

/// A torus as the stages leave it, in a file.
GltfBuilder file_of(const std::string& stages) {
  const Result result = run(stages, scene_of(closed_torus(16, 8)));
  if (result.failed) throw std::runtime_error(to_text(result.report));
  GltfBuilder builder = builder_of(write(result.scene));
  builder.json.erase("buffers");
  return builder;
}

/// Whether the file is read without the extension, and the code of the one warning that says so.
std::string warning_of(const GltfBuilder& builder, const std::string& extension) {
  Diagnostics diagnostics;
  const auto scene = read_gltf(builder.glb(), "test", {}, diagnostics, {.products = built_in_products()});
  if (!scene) return "refused: " + to_text(diagnostics);
  EXPECT_EQ(written(*scene).dump().find(extension), std::string::npos);
  if (diagnostics.all().size() != 1) return to_text(diagnostics);
  EXPECT_FALSE(diagnostics.all()[0].hint.empty());
  return diagnostics.all()[0].code;
}

struct Product {
  std::string stages, extension, code;
  std::function<GltfJson&(GltfJson& file)> members;
};

const std::vector<Product>& products() {
  static const std::vector<Product> all{
      {"weld, quadric-collapse", "FOREDRAW_progressive_mesh", "collapse-sequences-left-out",
       [](GltfJson& file) -> GltfJson& { return file["extensions"]["FOREDRAW_progressive_mesh"]["meshes"][0]; }},
      {"weld, quadric-collapse, levels(keep-sequences=true), geomorphs", "FOREDRAW_geomorph", "geomorphs-left-out",
       [](GltfJson& file) -> GltfJson& {
         return file["meshes"][0]["primitives"][0]["extensions"]["FOREDRAW_geomorph"];
       }},
      {"weld, quadric-collapse(placement=endpoint), progressive-stream", "FOREDRAW_progressive_stream",
       "progressive-streams-left-out",
       [](GltfJson& file) -> GltfJson& { return file["extensions"]["FOREDRAW_progressive_stream"]["meshes"][0]; }},
  };
  return all;
}

TEST(CollapseFiles, AreReadAsTheyWereWritten) {
  for (const Product& product : products()) {
    GltfBuilder builder = file_of(product.stages);
    EXPECT_FALSE(product.members(builder.json).empty()) << product.extension;
    EXPECT_EQ(warning_of(builder, "no extension of this name"), "") << product.extension;
  }
}

/// Each member is missing, of another kind, negative, or names an accessor of something else or none.
TEST(CollapseFiles, WithAWrongMemberAreLeftOut) {
  for (const Product& product : products()) {
    const GltfBuilder whole = file_of(product.stages);
    GltfJson first = whole.json;
    for (const auto& [key, value] : product.members(first).items()) {
      if (key == "places") continue;  // may be missing
      for (const GltfJson& wrong : {GltfJson(), GltfJson("text"), GltfJson(-1), GltfJson(1e9), GltfJson::array({-1}),
                                    GltfJson::object(), GltfJson::array({99, 99})}) {
        GltfBuilder builder = whole;
        GltfJson& members = product.members(builder.json);
        if (wrong.is_null() && key == "solved") continue;  // then they are blended
        if (wrong.is_null()) {
          members.erase(key);
        } else {
          members[key] = wrong;
        }
        EXPECT_EQ(warning_of(builder, product.extension), product.code)
            << product.extension << ' ' << key << ' ' << wrong.dump();
      }
    }
  }
}

/// Numbers beyond what they count, in each of the accessors of a sequence.
TEST(CollapseFiles, WithWrongNumbersAreLeftOut) {
  const Product& product = products()[0];
  const GltfBuilder whole = file_of(product.stages);
  GltfJson first = whole.json;
  for (const auto& [key, value] : product.members(first).items()) {
    if (!value.is_number()) continue;
    GltfBuilder builder = whole;
    GltfJson& accessor = builder.json["accessors"][value.get<std::size_t>()];
    const GltfJson& view = builder.json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const auto at = view.value("byteOffset", std::size_t{0}) + accessor.value("byteOffset", std::size_t{0});
    for (std::size_t i = 0; i < 16; ++i) builder.buffer[at + i] = std::byte{0xff};
    EXPECT_EQ(warning_of(builder, product.extension), product.code) << key;
  }
}

}  // namespace
}  // namespace foredraw::collapse_files_test
