// FOREDRAW_tessellation_levels in files: as it is, and wrong, when it costs itself alone.

#include "plugins/processors/tessellation_levels/tessellation_levels_product.h"
#include "support/gltf_builder.h"
#include "support/noisy.h"
#include "support/program.h"
#include "support/staged.h"

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/side_files.h>
#include <foredraw/report/inspection.h>

#include <fmt/format.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <functional>

namespace foredraw::tessellation_levels_files_test {
namespace {

using testing::GltfJson;
using ::testing::HasSubstr;

constexpr const char* extension = "FOREDRAW_tessellation_levels";

Scene levelled() {
  return testing::run("tessellation-levels(triangles=900)",
                      testing::displaced_grid(8, 8, testing::noise_image(64, 3), 0.5f))
      .scene;
}

std::vector<std::byte> written(const Scene& scene) {
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, "out.glb", diagnostics, {.products = {tessellation_levels_product()}});
  if (!files || diagnostics.has_errors()) throw std::runtime_error(to_text(diagnostics));
  return files->front().bytes;
}

TEST(TessellationLevelsFiles, ComeBack) {
  const Scene scene = levelled();
  Diagnostics diagnostics;
  const auto again = read_gltf(written(scene), "again", {}, diagnostics, {.products = {tessellation_levels_product()}});
  ASSERT_TRUE(again) << to_text(diagnostics);
  EXPECT_TRUE(diagnostics.empty()) << to_text(diagnostics);
  EXPECT_EQ(*again->products.find<StoredTessellations>(), *scene.products.find<StoredTessellations>());
  EXPECT_EQ(written(*again), written(scene));
}

TEST(TessellationLevelsFiles, AreInspected) {
  const Scene scene = levelled();
  Analyses analyses;
  const ProductRows rows{tessellation_levels_product()};
  const DrawTessellation& of = *tessellation_of(scene, 0);
  const std::string text = inspection_text(scene, rows, analyses, Executor(1));
  EXPECT_THAT(text, HasSubstr("mesh: " + std::to_string(of.scales[0].triangles) + " triangles from 128, error rms "));
  EXPECT_THAT(text, HasSubstr(fmt::format(" (undivided {:.4g}), largest ", of.scales.back().rms)));
  const auto json = nlohmann::json::parse(inspection_json(scene, rows, {}, analyses, Executor(1)));
  EXPECT_EQ(json["products"]["tessellation-levels"][0]["scales"].size(), of.scales.size());
}

class TessellationLevelsSideFile : public testing::InFolder {};

TEST_F(TessellationLevelsSideFile, HoldsTheRowsBesideIt) {
  const Scene scene = levelled();
  Diagnostics diagnostics;
  const auto files = encode_side_file(scene, *tessellation_levels_product(), folder_ / "levels.json", diagnostics);
  ASSERT_TRUE(files) << to_text(diagnostics);
  ASSERT_EQ(files->size(), 2u);
  const auto json = nlohmann::json::parse((*files)[0].bytes);
  const std::vector<std::byte>& rows = (*files)[1].bytes;
  EXPECT_EQ(json["buffer"], "levels.json.bin");
  const auto& draw = json["draws"][0];
  const DrawTessellation& of = *tessellation_of(scene, 0);
  ASSERT_EQ(draw["triangles"], 128);
  EXPECT_EQ(std::memcmp(rows.data() + draw["levels"].get<std::size_t>(), of.levels.view().data(), 4 * 128), 0);
  const DisplacementRange* ranges = of.ranges.view().data();
  EXPECT_EQ(std::memcmp(rows.data() + draw["displacements"].get<std::size_t>(), ranges, 8 * of.ranges.size()), 0);
  EXPECT_EQ(rows.size(), 4 * 128 + 8 * of.ranges.size());
  EXPECT_EQ(draw["scales"][0]["triangles"], of.scales[0].triangles);
}

struct Wrong {
  const char* name;
  std::function<void(GltfJson& file, GltfJson& value, std::vector<std::byte>& bin)> make;
  const char* why;  ///< a part of the warning
};

void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }

class WrongTessellationLevels : public ::testing::TestWithParam<Wrong> {};

/// Where in the buffer the accessor begins that a member names.
std::size_t begin_of(const GltfJson& file, const GltfJson& accessor) {
  const GltfJson& of = file["accessors"][accessor.get<std::size_t>()];
  return file["bufferViews"][of["bufferView"].get<std::size_t>()].value("byteOffset", std::size_t{0}) +
         of.value("byteOffset", std::size_t{0});
}

/// The file is read without them, a warning says so and why, and they are not written again.
TEST_P(WrongTessellationLevels, AreLeftOutWithAWarning) {
  const std::vector<std::byte> glb = written(levelled());
  std::uint32_t json_length = 0;
  std::memcpy(&json_length, glb.data() + 12, 4);
  GltfJson json = testing::json_of(glb);
  std::vector<std::byte> bin(glb.begin() + 20 + json_length + 8, glb.end());
  GetParam().make(json, json["meshes"][0]["primitives"][0]["extensions"][extension], bin);
  Diagnostics diagnostics;
  const auto scene = read_gltf(testing::glb_of(json.dump(), bin), "test", {}, diagnostics,
                               {.products = {tessellation_levels_product()}});
  ASSERT_TRUE(scene) << to_text(diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1u) << to_text(diagnostics);
  EXPECT_EQ(diagnostics.all()[0].code, "tessellation-levels-left-out");
  EXPECT_THAT(diagnostics.all()[0].message, HasSubstr(GetParam().why));
  EXPECT_FALSE(scene->products.has(StoredTessellations::product));
  EXPECT_EQ(testing::json_of(written(*scene)).dump().find(extension), std::string::npos);
}

using Bytes = std::vector<std::byte>;

INSTANTIATE_TEST_SUITE_P(
    TessellationLevels, WrongTessellationLevels,
    ::testing::Values(
        Wrong{"text", [](GltfJson&, GltfJson& value, Bytes&) { value = "levels"; }, "has no accessor 'levels'"},
        Wrong{"no_levels", [](GltfJson&, GltfJson& value, Bytes&) { value.erase("levels"); }, "no accessor 'levels'"},
        Wrong{"far_accessor", [](GltfJson&, GltfJson& value, Bytes&) { value["levels"] = 4'000'000'000u; }, "'levels'"},
        Wrong{"negative", [](GltfJson&, GltfJson& value, Bytes&) { value["levels"] = -1; }, "'levels'"},
        Wrong{"other_accessor", [](GltfJson&, GltfJson& value, Bytes&) { value["levels"] = value["ranges"]["begins"]; },
              "'levels'"},
        Wrong{"short",
              [](GltfJson& file, GltfJson& value, Bytes&) {
                file["accessors"][value["levels"].get<std::size_t>()]["count"] = 127;
              },
              "are of 127 triangles, not 128"},
        Wrong{"level_7",
              [](GltfJson& file, GltfJson& value, Bytes& bin) { bin[begin_of(file, value["levels"])] = std::byte{7}; },
              "a level of 2^7, but 64 is the highest there is"},
        Wrong{"level_255",
              [](GltfJson& file, GltfJson& value, Bytes& bin) {
                bin[begin_of(file, value["levels"]) + 3] = std::byte{255};
              },
              "a level of 2^255"},
        Wrong{"crack",
              [](GltfJson& file, GltfJson& value, Bytes& bin) {  // edges 0 and 1 of a triangle change places
                const std::size_t begin = begin_of(file, value["levels"]);
                for (std::size_t t = 0; t < 128; ++t) {
                  if (bin[begin + 4 * t] == bin[begin + 4 * t + 1]) continue;
                  std::swap(bin[begin + 4 * t], bin[begin + 4 * t + 1]);
                  return;
                }
              },
              "do not agree on an edge of triangle"},
        Wrong{"no_scales", [](GltfJson&, GltfJson& value, Bytes&) { value["scales"] = GltfJson::array(); }, "1 to 7"},
        Wrong{"many_scales",
              [](GltfJson&, GltfJson& value, Bytes&) {
                const GltfJson one = value["scales"][0];
                for (int i = 0; i < 100'000; ++i) value["scales"].push_back(one);
              },
              "1 to 7"},
        Wrong{"scale_missing", [](GltfJson&, GltfJson& value, Bytes&) { value["scales"].erase(1); }, "scales, but"},
        Wrong{"triangles", [](GltfJson&, GltfJson& value, Bytes&) { value["scales"][0]["triangles"] = 4'294'967'295u; },
              "triangles at scale 0, not 4294967295"},
        Wrong{"rms_falls", [](GltfJson&, GltfJson& value, Bytes&) { value["scales"][1]["rms"] = 0; }, "do not rise"},
        Wrong{"rms_negative", [](GltfJson&, GltfJson& value, Bytes&) { value["scales"][0]["rms"] = -1; }, "not rise"},
        Wrong{"rms_huge", [](GltfJson&, GltfJson& value, Bytes&) { value["scales"].back()["rms"] = 1e300; }, "'rms'"},
        Wrong{"rms_text", [](GltfJson&, GltfJson& value, Bytes&) { value["scales"][0]["rms"] = "small"; }, "'rms'"},
        Wrong{"no_ranges", [](GltfJson&, GltfJson& value, Bytes&) { value.erase("ranges"); }, "has no 'ranges'"},
        Wrong{"begins_fall",
              [](GltfJson& file, GltfJson& value,
                 Bytes& bin) { bin[begin_of(file, value["ranges"]["begins"])] = std::byte{1}; },
              "displacement range for each triangle"},
        Wrong{"range_nan",
              [](GltfJson& file, GltfJson& value,
                 Bytes& bin) { std::memset(bin.data() + begin_of(file, value["ranges"]["displacements"]), 255, 4); },
              "invalid displacement range"},
        Wrong{"not_displaced",
              [](GltfJson& file, GltfJson&,
                 Bytes&) { file["materials"][0]["extensions"].erase("KHR_materials_displacement"); },
              "nothing displaces"}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace foredraw::tessellation_levels_files_test
