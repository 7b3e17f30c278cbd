// Merged draws as engines get them: what lies where, the buffers, and shaders that a compiler takes.
#include <foredraw/io/side_files.h>

#include "support/merged_scenes.h"
#include "support/meshes.h"
#include "support/test_folder.h"

#include <foredraw/io/mesh/mesh_files.h>
#include <foredraw/io/scene_file.h>
#include <plugins/processors/merge_instances/merged_draws_product.h>
#include <plugins/processors/merge_instances/merged_shader.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

namespace foredraw::merge_instances_files_test {
namespace {

using namespace testing;

/// Two sets that share their vertices; in the second one instances have their own materials.
Scene two_sets() {
  const Scene base = read(yard());
  std::vector<MergedPlace> even, odd;
  for (const MergedPlace& place : all_places(base)) (place.node % 2 == 0 ? even : odd).push_back(place);
  MergedInstances a = merged_by_hand(base, even, {.frequencies = {6, 3, 9}});
  MergedInstances b = merged_by_hand(base, odd, {.frequencies = {12}, .groups = 1, .materials = true});
  b.vertices = a.vertices;
  return with_merged(base, {a, b});
}

std::vector<OutputFile> files_of(const Scene& scene, const std::string& target) {
  Diagnostics diagnostics;
  auto files = encode_side_file(scene, *merged_draws_product(), target, diagnostics);
  if (!files) throw std::runtime_error(to_text(diagnostics));
  EXPECT_TRUE(diagnostics.all().empty());
  return *files;
}

std::string text_of(const OutputFile& file) {
  return {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()};
}

template <class T>
void expect_holds(const GltfJson& part, const Shared<T>& values, const Bytes& buffer) {
  const auto bytes = std::as_bytes(values.view());
  const auto offset = part["offset"].get<std::size_t>();
  EXPECT_EQ(offset % 256, 0u);
  EXPECT_EQ(part["count"], values.size());
  ASSERT_LE(offset + bytes.size(), buffer.size());
  EXPECT_TRUE(std::ranges::equal(std::span(buffer).subspan(offset, bytes.size()), bytes));
}

TEST(MergedFiles, TheDescriptionSaysWhereEverythingLies) {
  const Scene scene = two_sets();
  const auto files = files_of(scene, "folder/out.json");
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].path, "folder/out.json");
  EXPECT_EQ(files[1].path, "folder/out.json.bin");
  const GltfJson json = GltfJson::parse(text_of(files[0]));
  const Bytes& buffer = files[1].bytes;
  EXPECT_EQ(json["foredraw"], "merge-instances");
  EXPECT_EQ(json["version"], 1);
  EXPECT_EQ(json["buffer"], "out.json.bin");
  ASSERT_EQ(json["sets"].size(), 2u);
  std::set<std::size_t> begins;
  for (std::size_t s = 0; s < 2; ++s) {
    const GltfJson& set = json["sets"][s];
    const MergedInstances& merged = merged_sets(scene)[s];
    expect_holds(set["indices"], merged.indices, buffer);
    expect_holds(set["slots"], merged.slots, buffer);
    expect_holds(set["transforms"], merged.transforms, buffer);
    expect_holds(set["places"], merged.places, buffer);
    EXPECT_EQ(set.contains("materials"), s == 1);
    if (s == 1) expect_holds(set["materials"], merged.materials, buffer);
    EXPECT_EQ(set["material"], *merged.material);
    EXPECT_EQ(set["materialName"], scene.materials[*merged.material].name);
    for (const char* key : {"indices", "slots", "transforms", "places"})
      begins.insert(set[key]["offset"].get<std::size_t>());

    const GltfJson& vertices = set["vertices"];
    EXPECT_EQ(vertices["offset"].get<std::size_t>() % 256, 0u);
    EXPECT_EQ(vertices["count"], merged.vertices->count);
    ASSERT_EQ(vertices["attributes"].size(), merged.vertices->base.size());
    for (std::size_t a = 0; a < merged.vertices->base.size(); ++a) {
      const VertexStream& stream = merged.vertices->base[a];
      const GltfJson& attribute = vertices["attributes"][a];
      EXPECT_EQ(attribute["semantic"], stream.semantic);
      EXPECT_EQ(attribute["stride"], stream.format.bytes);
      EXPECT_EQ(attribute["components"], stream.format.components);
      EXPECT_EQ(attribute["normalized"], stream.format.normalized);
      const std::size_t at = vertices["offset"].get<std::size_t>() + attribute["offset"].get<std::size_t>();
      EXPECT_TRUE(std::ranges::equal(std::span(buffer).subspan(at, stream.bytes.size()), stream.bytes.view()));
    }
    std::size_t draws = 0;
    ASSERT_EQ(set["groups"].size(), merged.groups.size());
    for (std::size_t g = 0; g < merged.groups.size(); ++g) {
      const GltfJson& group = set["groups"][g];
      EXPECT_EQ(group["min"][1].get<float>(), merged.groups[g].least.y);
      EXPECT_EQ(group["max"][0].get<float>(), merged.groups[g].most.x);
      EXPECT_EQ(group["firstInstance"], merged.groups[g].first_instance);
      EXPECT_EQ(group["instanceCount"], merged.groups[g].instance_count);
      for (const GltfJson& draw : group["draws"]) {
        const MergedDraw& wanted = merged.draws[draws++];
        EXPECT_EQ(wanted.group, g);
        EXPECT_EQ(draw["frequency"], wanted.frequency);
        EXPECT_EQ(draw["firstSlot"], wanted.first_slot);
        EXPECT_EQ(draw["slotCount"], wanted.slot_count);
        EXPECT_EQ(draw["vertexCount"], wanted.frequency * wanted.slot_count);
      }
    }
    EXPECT_EQ(draws, merged.draws.size());
  }
  EXPECT_EQ(begins.size(), 8u);
  EXPECT_EQ(json["sets"][0]["vertices"], json["sets"][1]["vertices"]) << "they are there once";
}

TEST(MergedFiles, AttributesThatEndOddlyLeaveTheNextAtAMultipleOfFour) {
  Scene scene = two_sets();
  VertexStreams odd = *merged_of(scene)[0].vertices;
  odd.base = {odd.base[0], odd.base[0]};  // bytes in threes: 54 of them
  ASSERT_EQ(odd.base[0].semantic, "NORMAL");
  odd.base[1].semantic = "_AGAIN";
  MergedInstances set = merged_of(scene)[0];
  set.vertices = std::make_shared<const VertexStreams>(odd);
  scene.products.set(MergedDraws{{set}});
  const auto files = files_of(scene, "out.json");
  const GltfJson vertices = GltfJson::parse(text_of(files[0]))["sets"][0]["vertices"];
  EXPECT_EQ(vertices["attributes"][1]["offset"], 56);
  EXPECT_EQ(vertices["bytes"], 112);
  EXPECT_EQ(vertices["attributes"][1]["shader"], "merged_again");
}

TEST(MergedFiles, NamesNeedNotBeUtf8) {
  Scene scene = two_sets();
  scene.materials[0].name = "\xff\xfe";
  EXPECT_TRUE(GltfJson::accept(text_of(files_of(scene, "out.json")[0])));
}

TEST(MergedFiles, WhereNothingIsMergedAnErrorTellsWhatToDo) {
  for (const char* name : {"out.json", "out.glsl", "out.hlsl"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(encode_side_file(read(yard()), *merged_draws_product(), name, diagnostics));
    ASSERT_EQ(diagnostics.all().size(), 1u);
    EXPECT_EQ(diagnostics.all()[0].code, "nothing-made");
    EXPECT_EQ(diagnostics.all()[0].where.file, name);
  }
}

TEST(MergedFiles, MeshFilesCanNotHoldThemAndSaySo) {
  const std::string text = "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  Diagnostics diagnostics;
  const auto scene = read_mesh_file(std::as_bytes(std::span(text)), MeshKind::obj, "in.obj", {}, diagnostics);
  ASSERT_TRUE(scene);
  const Scene merged = with_merged(*scene, {merged_by_hand(*scene, all_places(*scene))});
  ASSERT_TRUE(encode_scene(merged, "out.obj", diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].code, "product-left-out");
}

TEST(MergedFiles, TheirPlacesAreKnownBefore) {
  const auto row = merged_draws_product();
  const auto paths = paths_of_side_file(*row, "a/out.json");
  EXPECT_NE(std::ranges::find(paths, std::filesystem::path("a/out.json.bin")), paths.end());
  EXPECT_TRUE(side_file_kind(*row, "a.JSON"));
  EXPECT_TRUE(side_file_kind(*row, "a.glsl"));
  EXPECT_FALSE(side_file_kind(*row, "a.glb"));
}

/// Whether the compiler takes a vertex shader. Its output tells why not.
bool compiles(const std::string& text, const std::string& arguments) {
  const testing::TestFolder own;
  const std::filesystem::path& folder = own.path();
  const std::filesystem::path source = folder / "merged_files_test.vert";
  std::ofstream(source) << text;
  const std::string command = "glslangValidator " + arguments + " -o \"" + (folder / "merged_files_test.spv").string() +
                              "\" \"" + source.string() + "\"";
  return std::system(command.c_str()) == 0;
}

TEST(MergedFiles, ShadersOfEverySetAndFrequencyCompile) {
  if (std::system("glslangValidator --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "there is no glslangValidator";
  const Scene scene = two_sets();
  for (const bool glsl : {true, false}) {
    const auto files = files_of(scene, glsl ? "out.glsl" : "out.hlsl");
    ASSERT_EQ(files.size(), 1u);
    const std::string text = text_of(files[0]);
    EXPECT_NE(text.find("set 0: 3, 6, 9\n"), std::string::npos);
    EXPECT_NE(text.find("set 1: 12\n"), std::string::npos);
    for (std::uint32_t set = 0; set < 2; ++set) {
      std::set<std::string> defined{"", "#define MERGED_FREQUENCY 600u\n"};
      for (const MergedDraw& draw : merged_sets(scene)[set].draws) {
        defined.insert("#define MERGED_FREQUENCY " + std::to_string(draw.frequency) + "\n");
      }
      for (const std::string& frequency : defined) {
        const std::string definitions = "#define MERGED_SET " + std::to_string(set) + "\n" + frequency;
        const std::string body =
            "  float sum = merged_handedness(at.instance) + merged_normal(at.vertex).x + "
            "merged_texcoord_0(at.vertex).y + "
            "merged_six(at.vertex).z" +
            std::string(set == 1 ? " + float(merged_material(at.instance))" : "") + ";\n";
        const std::string shader =
            glsl ? "#version 450\nlayout(push_constant) uniform Draw { uint first_slot; };\n" + definitions + text +
                       "void main() {\n  MergedVertex at = merged_vertex(uint(gl_VertexIndex), first_slot);\n" + body +
                       "  gl_Position = vec4(merged_to_world(at.instance, merged_position(at.vertex)), sum);\n}\n"
                 : definitions + text +
                       "cbuffer Draw : register(b0) { uint first_slot; };\n"
                       "float4 main(uint number : SV_VertexID) : SV_Position {\n"
                       "  MergedVertex at = merged_vertex(number, first_slot);\n" +
                       body + "  return float4(merged_to_world(at.instance, merged_position(at.vertex)), sum);\n}\n";
        EXPECT_TRUE(compiles(shader, glsl ? "-V" : "-D -V -S vert -e main")) << shader;
      }
    }
  }
}

TEST(MergedFiles, InspectTellsOfThem) {
  Scene scene =
      testing::scene_of({testing::draw_of(testing::grid(2, 1), "tree"), testing::draw_of(testing::grid(1, 1), "rock")});
  MergedInstances merged;
  merged.meshes = {{0, 0}, {1, 6}};
  merged.places = Shared<MergedPlace>({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  merged.groups.resize(2);
  merged.draws = {{0, 12, 0, 2}, {1, 12, 2, 1}, {1, 6, 3, 4}};
  scene.products.set(MergedDraws{{merged}});
  const ProductText told = merged_draws_product()->told(scene);
  ASSERT_EQ(told.lines.size(), 1u);
  EXPECT_EQ(told.lines[0],
            "no material: 3 instances of 2 draws in 2 groups, drawn by 3 draw calls; 4 slots of 6 index entries, "
            "3 slots of 12 index entries");
  EXPECT_EQ(told.value.list()->front().member("instances")->whole(), 3u);
}

}  // namespace
}  // namespace foredraw::merge_instances_files_test
