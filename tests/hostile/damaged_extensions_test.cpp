// Our own extensions, damaged member by member: what is wrong costs the extension and never the file, and is told.
#include "whole_way.h"

#include "support/collapses.h"
#include "support/compressed_gltf.h"
#include "support/meshes.h"
#include "support/products.h"
#include "support/program.h"
#include "support/staged.h"

#include <regex>
#include <span>

namespace foredraw {
namespace {

using testing::GltfBuilder;
using testing::GltfJson;

struct Product {
  const char* extension;
  const char* stages;
  const char* harmless = "";  ///< damages after which it still says something; a regular expression
};

void PrintTo(const Product& product, std::ostream* out) { *out << product.extension; }

const std::vector<Product> products = {
    {"FOREDRAW_levels", "weld, quadric-collapse, levels",
     R"(primitive/levels/\d( is missing|/indices is missing|/error is (missing|4294967296)))"},
    {"FOREDRAW_progressive_mesh", "weld, quadric-collapse", "file/meshes/0/places is missing"},
    {"FOREDRAW_geomorph", "weld, quadric-collapse, levels(keep-sequences=true), geomorphs"},
    {"FOREDRAW_progressive_stream", "weld, quadric-collapse(placement=endpoint), progressive-stream"},
    {"FOREDRAW_lod_table", "weld, quadric-collapse, levels, lod-table"},
    {"FOREDRAW_crowd_levels", "weld, quadric-collapse, levels, crowd-levels",
     R"(primitive/(area|levels/\d/largest) is 4294967296)"},
};

GltfBuilder file_of(const Product& product) {
  const Result result = testing::run(product.stages, testing::scene_of(testing::closed_torus(16, 8)));
  if (result.failed) throw std::runtime_error(to_text(result.report));
  Diagnostics diagnostics;
  const auto files = encode_gltf(result.scene, "out.glb", diagnostics, {.products = testing::built_in_products()});
  GltfBuilder builder = testing::builder_of(files.value().front().bytes);
  builder.json.erase("buffers");
  return builder;
}

struct Damaged {
  std::string what;  ///< "primitive/radius is -1"
  std::vector<std::byte> glb;
};

/// Each part below `value`, which is a part of `whole`, in turn missing or something else.
void damage(GltfJson& value, const std::string& place, const GltfBuilder& whole, std::vector<Damaged>& all) {
  if (!value.is_structured()) return;
  const GltfJson kept = value;
  for (const auto& [key, part] : kept.items()) {
    const std::string member = place + '/' + key;
    GltfJson& here = kept.is_array() ? value[std::stoul(key)] : value[key];
    damage(here, member, whole, all);
    for (const GltfJson& wrong : {GltfJson("text"), GltfJson(-1), GltfJson(1e300), GltfJson(std::int64_t{1} << 32),
                                  GltfJson(), GltfJson::array(), GltfJson::object(), GltfJson::array({-1, "text"})}) {
      if (wrong == part || (wrong.is_string() && part.is_string())) continue;  // a name is a name
      here = wrong;
      all.push_back({member + " is " + wrong.dump(), whole.glb()});
    }
    if (kept.is_array()) {
      value.erase(std::stoul(key));
    } else {
      value.erase(key);
    }
    all.push_back({member + " is missing", whole.glb()});
    value = kept;
  }
}

/// Wherever the file has the extension.
std::vector<Damaged> damaged(const Product& product) {
  GltfBuilder builder = file_of(product);
  std::vector<Damaged> all;
  const auto damage_in = [&](GltfJson& owner, const std::string& place) {
    if (!owner.contains("extensions") || !owner["extensions"].contains(product.extension)) return;
    damage(owner["extensions"][product.extension], place, builder, all);
  };
  damage_in(builder.json, "file");
  damage_in(builder.json["meshes"][0]["primitives"][0], "primitive");
  return all;
}

bool is_harmless(const Product& product, const Damaged& damaged) {
  return std::regex_match(damaged.what, std::regex(product.harmless));
}

class DamagedExtension : public testing::InFolder, public ::testing::WithParamInterface<Product> {};

TEST_P(DamagedExtension, CostsItselfAloneAndIsTold) {
  const std::vector<Damaged> all = damaged(GetParam());
  EXPECT_GT(all.size(), 8u);
  for (const Damaged& one : all) {
    SCOPED_TRACE(one.what);
    EXPECT_TRUE(testing::go_the_whole_way(one.glb).empty());
    Diagnostics diagnostics;
    const auto scene = read_gltf(one.glb, "file", {}, diagnostics, {.products = testing::built_in_products()});
    ASSERT_TRUE(scene);
    const bool is_told = std::ranges::any_of(
        diagnostics.all(), [](const Diagnostic& d) { return d.code.ends_with("-left-out") && !d.hint.empty(); });
    EXPECT_NE(is_told, is_harmless(GetParam(), one)) << to_text(diagnostics);
  }
}

#ifdef FOREDRAW_PROGRAM
TEST_P(DamagedExtension, GoesThroughTheProgram) {
  constexpr std::size_t most_files = 60;
  const std::vector<Damaged> all = damaged(GetParam());
  const std::size_t step = (all.size() + most_files - 1) / most_files;
  std::filesystem::create_directory(folder_ / "in");
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < all.size(); i += step) {
    numbers.push_back(i);
    testing::put(folder_ / "in" / (std::to_string(i) + ".glb"),
                 {reinterpret_cast<const char*>(all[i].glb.data()), all[i].glb.size()});
  }
  const auto expect_told = [&](const std::string& command, std::span<const std::size_t> of) {
    const testing::Ended ended = testing::run_program(folder_, command);
    EXPECT_EQ(ended.code, 0) << command << '\n' << ended.err.substr(0, 2000);
    for (const std::size_t i : of) {
      const bool is_told = ended.err.find("in/" + std::to_string(i) + ".glb: warning: ") != std::string::npos;
      EXPECT_NE(is_told, is_harmless(GetParam(), all[i])) << command << ": " << all[i].what;
    }
  };
  expect_told("measure in --with vertex-cache", numbers);
  expect_told("optimize in -o out -p 'weld, tipsify, vertex-fetch' --threads 2", numbers);
  EXPECT_EQ(static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_ / "out"), {})),
            numbers.size());
  for (std::size_t i = 0; i < numbers.size(); i += 10) {
    expect_told("inspect in/" + std::to_string(numbers[i]) + ".glb", std::span(numbers).subspan(i, 1));
  }
}
#endif

INSTANTIATE_TEST_SUITE_P(Ours, DamagedExtension, ::testing::ValuesIn(products),
                         [](const auto& info) { return std::string(info.param.extension); });

}  // namespace
}  // namespace foredraw
