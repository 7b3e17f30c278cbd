// Packed vertices in files: what comes back, what is refused, and what engines get beside the scene.
#include "support/compiled_shader.h"
#include "support/packed_scenes.h"
#include "support/program.h"

#include <foredraw/io/side_files.h>
#include <foredraw/report/inspection.h>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace foredraw::vertex_pack_files_test {
namespace {

using testing::GltfJson;
using ::testing::HasSubstr;
using testing::packed_of;

constexpr const char* extension = "FOREDRAW_packed_vertices";

std::optional<Scene> read_again(std::vector<std::byte> file, Diagnostics& diagnostics) {
  return read_gltf(std::move(file), "again", {}, diagnostics, {.products = {packed_vertices_product()}});
}

Scene packed_tube() { return testing::packed(testing::BendingTube().scene()); }

TEST(PackedFiles, ComeBack) {
  for (const Scene& scene : {testing::packed(testing::framed_scene()), packed_tube(),
                             testing::packed(testing::framed_scene(), "(method=spherical)")}) {
    Diagnostics diagnostics;
    const auto again = read_again(testing::written_packed(scene), diagnostics);
    ASSERT_TRUE(again);
    EXPECT_TRUE(diagnostics.empty()) << to_text(diagnostics);
    EXPECT_EQ(packed_of(*again), packed_of(scene));
    EXPECT_EQ(testing::written_packed(*again), testing::written_packed(scene));
  }
}

TEST(PackedFiles, AreInspected) {
  const Scene scene = testing::packed(testing::framed_scene());
  Analyses analyses;
  const std::string text = inspection_text(scene, {packed_vertices_product()}, analyses, Executor(1));
  EXPECT_THAT(text, HasSubstr("packed vertices (16 bytes each, beside the plain streams):\n"));
  EXPECT_THAT(text, HasSubstr("  ball: vertices "));
  EXPECT_THAT(text, HasSubstr("normal 2 x 1"));
}

struct Wrong {
  const char* name;
  std::function<void(GltfJson& json, GltfJson& ball)> make;
  const char* why;  ///< a part of the warning
};

void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }

class WrongPackedVertices : public ::testing::TestWithParam<Wrong> {};

/// The file is read without them, a warning says why, and they are not written again.
TEST_P(WrongPackedVertices, AreLeftOutWithAWarning) {
  const std::vector<std::byte> glb = testing::written_packed(testing::packed(testing::framed_scene()));
  std::uint32_t json_length = 0;
  std::memcpy(&json_length, glb.data() + 12, 4);
  GltfJson json = testing::json_of(glb);
  GetParam().make(json, json["meshes"][0]["primitives"][0]["extensions"][extension]);
  const std::vector<std::byte> bin(glb.begin() + 20 + json_length + 8, glb.end());
  Diagnostics diagnostics;
  const auto scene = read_again(testing::glb_of(json.dump(), bin), diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1u) << to_text(diagnostics);
  EXPECT_EQ(diagnostics.all()[0].code, "packed-vertices-left-out");
  EXPECT_THAT(diagnostics.all()[0].message, HasSubstr(GetParam().why));
  EXPECT_FALSE(scene->products.has(PackedVertices::product));
  EXPECT_EQ(testing::json_of(testing::written_packed(*scene)).dump().find(extension), std::string::npos);
}

GltfJson& field(GltfJson& ball, const std::string& name) {
  for (GltfJson& word : ball["layout"]["words"]) {
    for (GltfJson& one : word) {
      if (one["field"] == name) return one;
    }
  }
  throw std::runtime_error("no field " + name);
}

void resize(GltfJson& ball, const std::string& name, int by) {
  field(ball, name)["bits"] = field(ball, name)["bits"].get<int>() + by;
}

INSTANTIATE_TEST_SUITE_P(
    Packed, WrongPackedVertices,
    ::testing::Values(
        Wrong{"text", [](GltfJson&, GltfJson& ball) { ball = "rows"; }, "has no 'layout'"},
        Wrong{"no_rows", [](GltfJson&, GltfJson& ball) { ball.erase("rows"); }, "has no 'rows'"},
        Wrong{"bits_127", [](GltfJson&, GltfJson& ball) { resize(ball, "x", -1); }, "a word of 31 bits, not 32"},
        Wrong{"bits_129", [](GltfJson&, GltfJson& ball) { resize(ball, "x", 1); }, "a word of more than 32 bits"},
        Wrong{"bits_0", [](GltfJson&, GltfJson& ball) { field(ball, "u")["bits"] = 0; }, "without a name and bits"},
        Wrong{"bits_negative", [](GltfJson&, GltfJson& ball) { field(ball, "u")["bits"] = -3; }, "name and bits"},
        Wrong{"bits_2_to_32", [](GltfJson&, GltfJson& ball) { field(ball, "u")["bits"] = 4294967296; }, "name and bits"},
        Wrong{"bits_text", [](GltfJson&, GltfJson& ball) { field(ball, "u")["bits"] = "12"; }, "name and bits"},
        Wrong{"no_z", [](GltfJson&, GltfJson& ball) { field(ball, "z")["field"] = "spare"; }, "out of range"},
        Wrong{"field_twice", [](GltfJson&, GltfJson& ball) { field(ball, "z")["field"] = "y"; }, "the field 'y' twice"},
        Wrong{"field_unknown", [](GltfJson&, GltfJson& ball) { field(ball, "z")["field"] = "w"; }, "whose name is not known"},
        Wrong{"no_sign", [](GltfJson&, GltfJson& ball) { field(ball, "sign")["field"] = "spare"; }, "out of range"},
        Wrong{"three_words", [](GltfJson&, GltfJson& ball) { ball["layout"]["words"].erase(3); }, "not an array of 4"},
        Wrong{"word_no_array", [](GltfJson&, GltfJson& ball) { ball["layout"]["words"][1] = 32; }, "0 bits, not 32"},
        Wrong{"many_fields",
              [](GltfJson&, GltfJson& ball) {
                for (int i = 0; i < 100'000; ++i) {
                  ball["layout"]["words"][1].push_back({{"field", "spare"}, {"bits", 1}});
                }
              },
              "a word of more than 32 bits"},
        Wrong{"method", [](GltfJson&, GltfJson& ball) { ball["layout"]["method"] = "cubic"; }, "'method'"},
        Wrong{"other_method", [](GltfJson&, GltfJson& ball) { ball["layout"]["method"] = "spherical"; }, "a normal"},
        Wrong{"origin_huge", [](GltfJson&, GltfJson& ball) { ball["layout"]["origin"][1] = 1e300; }, "'origin'"},
        Wrong{"origin_part", [](GltfJson&, GltfJson& ball) { ball["layout"]["origin"][1] = 0.5; }, "'origin'"},
        Wrong{"origin_beyond", [](GltfJson&, GltfJson& ball) { ball["layout"]["origin"][1] = 16777216; }, "out of range"},
        Wrong{"origin_other",
              [](GltfJson&, GltfJson& ball) {
                ball["layout"]["origin"][0] = ball["layout"]["origin"][0].get<int>() + 1;
              },
              "a position that is farther off"},
        Wrong{"step_huge", [](GltfJson&, GltfJson& ball) { ball["layout"]["step"] = 101; }, "'step'"},
        Wrong{"step_other",
              [](GltfJson&, GltfJson& ball) { ball["layout"]["step"] = ball["layout"]["step"].get<int>() - 1; },
              "a position that is farther off"},
        Wrong{"uv_step_0", [](GltfJson&, GltfJson& ball) { ball["layout"]["uvStep"][0] = 0; }, "'uvStep'"},
        Wrong{"uv_step_tiny", [](GltfJson&, GltfJson& ball) { ball["layout"]["uvStep"][0] = 1e-300; }, "out of range"},
        Wrong{"uv_step_missing", [](GltfJson&, GltfJson& ball) { ball["layout"].erase("uvStep"); }, "has no 'uvStep'"},
        Wrong{"posed_empty", [](GltfJson&, GltfJson& ball) { ball["posed"] = GltfJson::object(); }, "has no 'method'"},
        Wrong{"levels_missing", [](GltfJson&, GltfJson& ball) { ball["rows"].erase(2); }, "not an array of 3"},
        Wrong{"rows_of_another_level", [](GltfJson&, GltfJson& ball) { ball["rows"][0] = ball["rows"][1]; },
              "four words for each vertex"},
        Wrong{"rows_not_there", [](GltfJson&, GltfJson& ball) { ball["rows"][0] = 100'000; }, "rows that are missing"},
        Wrong{"rows_are_positions",
              [](GltfJson& json, GltfJson& ball) {
                ball["rows"][0] = json["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
              },
              "not four unsigned ints"},
        Wrong{"rows_fewer",
              [](GltfJson& json, GltfJson& ball) {
                GltfJson& count = json["accessors"][ball["rows"][0].get<std::size_t>()]["count"];
                count = count.get<int>() - 1;
              },
              "four words for each vertex"}),
    [](const auto& info) { return std::string(info.param.name); });

std::string text_of(const Scene& scene, const std::string& path) {
  Diagnostics diagnostics;
  const auto files = encode_side_file(scene, *packed_vertices_product(), path, diagnostics);
  if (!files) throw std::runtime_error(to_text(diagnostics));
  return {reinterpret_cast<const char*>(files->front().bytes.data()), files->front().bytes.size()};
}

class PackedSideFiles : public testing::InFolder {};

/// Compiled as C99 and as C++, it gives the layouts that the scene has.
TEST_F(PackedSideFiles, TheHeaderIsCAndHoldsTheLayouts) {
  Scene scene = packed_tube();
  scene.draws[0].name = "a \"tube\"?\?/ \n*/ \xc3\xa9";
  scene.name = "x*/ y?\?/.glb";
  testing::put(folder_ / "tubes.h", text_of(scene, folder_ / "2 tubes.h"));
  testing::put(folder_ / "use.c", R"(#include "tubes.h"
#include "tubes.h"
#include <stdio.h>
static void print(const foredraw_packed_layout* layout) {
  const unsigned char* bytes = (const unsigned char*)layout;
  size_t i;
  for (i = 0; i < sizeof *layout; ++i) printf("%02x", bytes[i]);
  printf(" %d\n", foredraw_packed_is_layout(layout));
}
int main(void) {
  unsigned d;
  for (d = 0; d < T2_TUBES_PACKED_DRAW_COUNT; ++d) {
    print(t2_tubes_packed_draws[d].stored);
    print(t2_tubes_packed_draws[d].posed);
  }
  return 0;
}
)");
  std::string wanted;
  const PackedVertices::OfDraw& tube = packed_of(scene).draws[0];
  for (const PackedLayout& layout : {tube.layout, *tube.posed}) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(&layout);
    for (std::size_t i = 0; i < sizeof layout; ++i) wanted += fmt::format("{:02x}", bytes[i]);
    wanted += " 1\n";
  }
  for (const char* compiler : {"cc -std=c99 -pedantic", "c++ -x c++ -std=c++20"}) {
    const std::string command =
        fmt::format("cd '{0}' && {1} -Wall -Wextra -Werror -I '{2}/framework' use.c -o use && ./use > out.txt",
                    folder_.string(), compiler, FOREDRAW_SOURCE_DIR);
    ASSERT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(testing::content(folder_ / "out.txt"), wanted);
  }
}

TEST_F(PackedSideFiles, ShadersOfEveryLayoutCompile) {
  if (!testing::has_shader_compiler()) GTEST_SKIP() << "there is no glslangValidator";
  const Scene scene = packed_tube();
  for (const bool glsl : {true, false}) {
    const std::string text = text_of(scene, glsl ? "out.glsl" : "out.hlsl");
    EXPECT_THAT(text, HasSubstr("//     mesh: 0, 1\n"));
    for (const char* layout : {"", "#define PACKED_LAYOUT 0\n", "#define PACKED_LAYOUT 1\n"}) {
      const std::string main =
          glsl ? "layout(location = 0) in uvec4 row;\nlayout(location = 0) out flat uvec4 again;\nvoid main() {\n"
                 "  PackedVertex v = packed_decode(row);\n  gl_Position = vec4(v.position, float(packed_encode(v, "
                 "again)));\n}\n"
               : "float4 main(uint4 row : ROW, out uint4 again : AGAIN) : SV_Position {\n"
                 "  PackedVertex v = packed_decode(row);\n  uint told = packed_encode(v, again);\n"
                 "  return float4(v.position, float(told));\n}\n";
      testing::put(folder_ / "use.vert", std::string(glsl ? "#version 450\n" : "") + layout + text + main);
      const std::string command = fmt::format("cd '{}' && glslangValidator {} -o use.spv use.vert", folder_.string(),
                                              glsl ? "-V" : "-D -V -S vert -e main");
      EXPECT_EQ(std::system(command.c_str()), 0) << glsl << layout;
    }
  }
}

TEST(PackedFiles, WhereNothingIsPackedAnErrorTellsWhatToDo) {
  Diagnostics diagnostics;
  EXPECT_FALSE(encode_side_file(testing::framed_scene(), *packed_vertices_product(), "out.h", diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].code, "nothing-made");
}

}  // namespace
}  // namespace foredraw::vertex_pack_files_test
