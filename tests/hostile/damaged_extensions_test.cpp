// Our own extensions, damaged member by member: what is wrong costs the extension and never the file, and is told.
#include "whole_way.h"

#include "support/collapses.h"
#include "support/compressed_gltf.h"
#include "support/displaced.h"
#include "support/products.h"
#include "support/program.h"
#include "support/staged.h"
#include "support/uv_charts.h"

#include <map>
#include <regex>
#include <set>
#include <span>

namespace foredraw {
namespace {

using testing::GltfBuilder;
using testing::GltfJson;

Scene torus() { return testing::scene_of(testing::closed_torus(16, 8)); }

Scene displaced() {
  return testing::displaced_grid(4, 4, testing::height_image(16, 16, [](auto x, auto y) {
                                   return static_cast<std::uint16_t>(4099 * (x * x + 3 * y));
                                 }));
}

/// Cut into six.
Scene charts() {
  const testing::Charts cut = testing::cube_sphere(2, testing::turned_places());
  const testing::Map map = testing::noise_map(64, 64, 3);
  return testing::displaced_scene(
      {cut.positions, cut.indices}, cut.uvs,
      testing::height_image(64, 64, [&](auto x, auto y) { return map.texels[64 * y + x]; }));
}

/// So many triangles that heights pay.
Scene waves() {
  testing::TestMesh mesh = testing::sphere(64, 32);
  for (glm::vec3& p : mesh.positions) p *= 1 + 0.05f * p.x * p.y * (p.z + 0.5f);
  return testing::scene_of(mesh);
}

struct Product {
  const char* extension;
  const char* stages;
  const char* harmless = "";  ///< damages after which it still says something; a regular expression
  Scene (*scene)() = torus;
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
    {"FOREDRAW_tessellation_levels", "tessellation-levels", R"(primitive/scales/1/(rms|largest) is 4294967296)",
     displaced},
    {"FOREDRAW_baked_heights", "weld, quadric-collapse, displacement-bake(rms=0.0005)",
     R"(primitive/(factor|offset) is (-1|4294967296))", waves},
    {"FOREDRAW_packed_vertices", "vertex-pack"},
    {"FOREDRAW_seam_heights", "displacement-seams(table=true)",
     "primitive/(heights (has all bits set|is noise)|sides is a row short)", charts},
};

/// Whose streams are no vertices or triangles that could be drawn.
std::vector<Product> with_streams_of_their_own() {
  std::vector<Product> own;
  for (const Product& product : products) {
    for (const char* name : {"FOREDRAW_tessellation_levels", "FOREDRAW_baked_heights", "FOREDRAW_packed_vertices",
                             "FOREDRAW_seam_heights"}) {
      if (product.extension == std::string_view(name)) own.push_back(product);
    }
  }
  return own;
}

GltfBuilder file_of(const Product& product) {
  const Result result = testing::run(product.stages, product.scene());
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

/// [member of the primitive's extension, or member of a member] the accessor that it names.
std::map<std::string, std::size_t> accessors_of(const GltfBuilder& builder, const Product& product) {
  const GltfJson& primitive = builder.json["meshes"][0]["primitives"][0];
  std::set<std::size_t> others{primitive["indices"]};
  for (const auto& [semantic, number] : primitive["attributes"].items()) others.insert(number.get<std::size_t>());
  std::map<std::string, std::size_t> own;
  const auto add = [&](const std::string& name, const GltfJson& value) {
    const bool is_accessor = value.is_number_unsigned() && value < builder.json["accessors"].size();
    if (is_accessor && !others.contains(value)) own[name] = value;
  };
  for (const auto& [name, value] : primitive["extensions"][product.extension].items()) {
    add("primitive/" + name, value);
    if (!value.is_structured()) continue;
    for (const auto& [inner, number] : value.items()) add("primitive/" + name + '/' + inner, number);
  }
  return own;
}

/// Streams that are a row short, one too long, of another kind, or hold bits that are all set or all different.
std::vector<Damaged> damaged_streams(const Product& product) {
  const GltfBuilder whole = file_of(product);
  std::vector<Damaged> all;
  const auto put = [&](const auto& accessor, const char* what, const auto& change) {
    GltfBuilder harmed = whole;
    change(harmed, harmed.json["accessors"][accessor.second]);
    all.push_back({accessor.first + ' ' + what, harmed.glb()});
  };
  const auto fill = [](GltfBuilder& file, const GltfJson& accessor, const auto& byte) {
    const GltfJson& view = file.json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const std::string type = accessor["type"];
    const std::size_t components = type == "SCALAR" ? 1 : static_cast<std::size_t>(type[3] - '0');
    const int component = accessor["componentType"];
    const std::size_t width = component < 5122 ? 1 : component < 5124 ? 2 : 4;
    const std::size_t from = view.value("byteOffset", std::size_t{0}) + accessor.value("byteOffset", std::size_t{0});
    const std::size_t size = accessor["count"].get<std::size_t>() * components * width;
    for (std::size_t i = 0; i < size; ++i) file.buffer[from + i] = static_cast<std::byte>(byte(i));
  };
  for (const auto& accessor : accessors_of(whole, product)) {
    put(accessor, "is a row short", [](GltfBuilder&, GltfJson& of) { of["count"] = of["count"].get<int>() - 1; });
    put(accessor, "is a row too long", [](GltfBuilder&, GltfJson& of) { of["count"] = of["count"].get<int>() + 1; });
    put(accessor, "is of another kind", [](GltfBuilder&, GltfJson& of) { of["componentType"] = 5122; });
    put(accessor, "has all bits set",
        [&](GltfBuilder& file, GltfJson& of) { fill(file, of, [](std::size_t) { return 255; }); });
    put(accessor, "is noise",
        [&](GltfBuilder& file, GltfJson& of) { fill(file, of, [](std::size_t i) { return i * 167 + 13; }); });
  }
  return all;
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

class DamagedStreams : public DamagedExtension {};

TEST_P(DamagedStreams, CostTheExtensionAloneAndAreTold) {
  const std::vector<Damaged> all = damaged_streams(GetParam());
  EXPECT_GE(all.size(), 5u);
  for (const Damaged& one : all) {
    SCOPED_TRACE(one.what);
    EXPECT_TRUE(testing::go_the_whole_way(one.glb).empty());
    Diagnostics diagnostics;
    ASSERT_TRUE(read_gltf(one.glb, "file", {}, diagnostics, {.products = testing::built_in_products()}));
    const bool is_told = std::ranges::any_of(
        diagnostics.all(), [](const Diagnostic& d) { return d.code.ends_with("-left-out") && !d.hint.empty(); });
    EXPECT_NE(is_told, is_harmless(GetParam(), one)) << to_text(diagnostics);
  }
}

INSTANTIATE_TEST_SUITE_P(Ours, DamagedExtension, ::testing::ValuesIn(products),
                         [](const auto& info) { return std::string(info.param.extension); });
INSTANTIATE_TEST_SUITE_P(Ours, DamagedStreams, ::testing::ValuesIn(with_streams_of_their_own()),
                         [](const auto& info) { return std::string(info.param.extension); });

}  // namespace
}  // namespace foredraw
