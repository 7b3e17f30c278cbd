#include <plugins/processors/merge_instances/merged_shader.h>

#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace foredraw::merge_instances_shader_test {
namespace {

VertexStream stream(std::string semantic, Component component, std::uint8_t components, bool normalized) {
  const auto bytes = static_cast<std::uint16_t>(bytes_of(component) * components);
  return {std::move(semantic),
          {component, components, normalized, bytes},
          Shared<std::byte>(std::vector<std::byte>(std::size_t{bytes} * 5))};
}

VertexStreams all_formats() {
  VertexStreams vertices;
  vertices.count = 5;
  vertices.base = {
      stream("POSITION", Component::float32, 3, false),  stream("NORMAL", Component::int8, 3, true),
      stream("TANGENT", Component::int16, 4, true),      stream("TEXCOORD_0", Component::uint16, 2, true),
      stream("TEXCOORD_1", Component::uint8, 2, true),   stream("COLOR_0", Component::uint8, 4, true),
      stream("_WEIGHT", Component::float32, 1, false),   stream("_ID", Component::uint32, 1, false),
      stream("_STEP", Component::uint16, 1, false),      stream("_LOW", Component::int8, 1, false),
      stream("_FRAME", Component::float32, 9, false),    stream("_WORLD__2--A", Component::int16, 3, false),
      stream("_to_world", Component::float32, 1, false), stream("_TO_WORLD", Component::float32, 1, false)};
  return vertices;
}

/// Whether the compiler takes a shader. Its output tells why not.
bool compiles(const std::string& text, const std::string& arguments, const std::string& name) {
  const testing::TestFolder own;
  const std::filesystem::path& folder = own.path();
  const std::filesystem::path source = folder / (name + ".vert");
  std::ofstream(source) << text;
  const std::string command = "glslangValidator " + arguments + " -o \"" + (folder / (name + ".spv")).string() +
                              "\" \"" + source.string() + "\"";
  return std::system(command.c_str()) == 0;
}

bool has_compiler() { return std::system("glslangValidator --version > /dev/null 2>&1") == 0; }

std::string calls(const MergedVertexLayout& layout) {
  std::string text;
  for (const MergedVertexLayout::Attribute& attribute : layout.attributes) {
    if (attribute.format.components == 1) text += "  sum += merged_" + attribute.name + "(at.vertex);\n";
    if (attribute.format.components > 1 && attribute.format.components <= 4) {
      text += "  sum += merged_" + attribute.name + "(at.vertex).x;\n";
    }
  }
  return text;
}

TEST(MergeShader, GlslCompiles) {
  if (!has_compiler()) GTEST_SKIP() << "there is no glslangValidator";
  const MergedVertexLayout layout = merged_vertex_layout(all_formats());
  const std::string text = "#version 450\nlayout(push_constant) uniform Draw { uint first_slot; };\n" +
                           merged_shader_text(layout, {.frequency = 45, .set = 1, .first_binding = 2}) +
                           "void main() {\n"
                           "  MergedVertex at = merged_vertex(uint(gl_VertexIndex), first_slot);\n"
                           "  float sum = merged_handedness(at.instance);\n" +
                           calls(layout) +
                           "  vec3 normal = merged_normal_to_world(at.instance, merged_normal(at.vertex));\n"
                           "  vec3 tangent = merged_direction_to_world(at.instance, merged_tangent(at.vertex).xyz);\n"
                           "  vec3 world = merged_to_world(at.instance, merged_position(at.vertex));\n"
                           "  gl_Position = vec4(world + normal + tangent, sum);\n}\n";
  EXPECT_TRUE(compiles(text, "-V", "merged_glsl")) << text;
}

TEST(MergeShader, HlslCompiles) {
  if (!has_compiler()) GTEST_SKIP() << "there is no glslangValidator";
  const MergedVertexLayout layout = merged_vertex_layout(all_formats());
  const std::string text = merged_shader_text(layout, {.language = ShaderLanguage::hlsl, .frequency = 45}) +
                           "cbuffer Draw : register(b0) { uint first_slot; };\n"
                           "float4 main(uint number : SV_VertexID) : SV_Position {\n"
                           "  MergedVertex at = merged_vertex(number, first_slot);\n"
                           "  float sum = merged_handedness(at.instance);\n" +
                           calls(layout) +
                           "  float3 normal = merged_normal_to_world(at.instance, merged_normal(at.vertex));\n"
                           "  float3 tangent = merged_direction_to_world(at.instance, merged_tangent(at.vertex).xyz);\n"
                           "  float3 world = merged_to_world(at.instance, merged_position(at.vertex));\n"
                           "  return float4(world + normal + tangent, sum);\n}\n";
  EXPECT_TRUE(compiles(text, "-D -V -S vert -e main", "merged_hlsl")) << text;
}

TEST(MergeShader, HoldsTheDrawsConstants) {
  const std::string text = merged_shader_text(merged_vertex_layout(all_formats()), {.frequency = 45});
  EXPECT_NE(text.find("#define MERGED_FREQUENCY 45u"), std::string::npos);
  EXPECT_NE(text.find("// frame has 9 components"), std::string::npos);
  EXPECT_EQ(text.find("__"), std::string::npos);
}

TEST(MergeShader, StreamsBeginAtMultiplesOfFour) {
  const VertexStreams vertices = all_formats();
  const MergedVertexLayout layout = merged_vertex_layout(vertices);
  std::uint64_t end = 0;
  for (std::size_t i = 0; i < layout.attributes.size(); ++i) {
    EXPECT_EQ(layout.attributes[i].offset % 4, 0u);
    EXPECT_GE(layout.attributes[i].offset, end);
    end = layout.attributes[i].offset + vertices.base[i].bytes.size();
  }
  EXPECT_EQ(merged_vertex_bytes(vertices, layout).size(), layout.bytes);
  EXPECT_EQ(layout.attributes[11].name, "world_2_a");
  EXPECT_EQ(layout.attributes[12].name, "to_world_attribute");
  EXPECT_EQ(layout.attributes[13].name, "to_world_of_2");
}

}  // namespace
}  // namespace foredraw::merge_instances_shader_test
