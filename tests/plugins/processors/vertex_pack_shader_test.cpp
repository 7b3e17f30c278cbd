// The generated shaders: a compiler takes them, and a device gets the bits of the C header from them.
#include "plugins/processors/vertex_pack/packed_shader.h"

#include "support/compiled_shader.h"
#include "support/packed_vertices.h"
#include "support/program.h"
#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>

#ifdef FOREDRAW_HAS_GPU
#include "support/compute_pipeline.h"
#include "support/on_device.h"

#include <foredraw/gpu/graphics_pipeline.h>
#include <foredraw/gpu/memory.h>
#include <foredraw/gpu/storage_sets.h>
#endif

namespace foredraw::vertex_pack_shader_test {
namespace {

using processors::vertex_pack::packed_shader_head;
using processors::vertex_pack::packed_shader_text;

/// Whether the compiler takes it; `name`.spv is what it makes. Its output tells why not.
bool compiles(const std::filesystem::path& folder, const std::string& name, const std::string& text,
              const std::string& arguments) {
  testing::put(folder / (name + ".comp"), text);
  const std::string command = "glslangValidator " + arguments + " -o \"" + (folder / (name + ".spv")).string() +
                              "\" \"" + (folder / (name + ".comp")).string() + "\"";
  return std::system(command.c_str()) == 0;
}

std::string glsl_of(const PackedLayout& layout) {
  return "#version 450\nlayout(local_size_x = 64) in;\n"
         "layout(std430, set = 0, binding = 0) readonly buffer Rows { uvec4 rows[]; };\n"
         "layout(std430, set = 0, binding = 1) buffer Decoded { float decoded[]; };\n"
         "layout(std430, set = 0, binding = 2) readonly buffer Plain { float plain[]; };\n"
         "layout(std430, set = 0, binding = 3) buffer Encoded { uint encoded[]; };\n" +
         packed_shader_head(ShaderLanguage::glsl) + packed_shader_text(layout, ShaderLanguage::glsl) +
         R"(
void main() {
  uint i = gl_GlobalInvocationID.x;
  PackedVertex v = packed_decode(rows[i]);
  float all[12] = float[12](v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y, v.normal.z, v.tangent.x,
                            v.tangent.y, v.tangent.z, v.tangent.w, v.uv.x, v.uv.y);
  for (uint c = 0u; c < 12u; ++c) decoded[12u * i + c] = all[c];
  uint at = 12u * i;
  PackedVertex p;
  p.position = vec3(plain[at], plain[at + 1u], plain[at + 2u]);
  p.normal = vec3(plain[at + 3u], plain[at + 4u], plain[at + 5u]);
  p.tangent = vec4(plain[at + 6u], plain[at + 7u], plain[at + 8u], plain[at + 9u]);
  p.uv = vec2(plain[at + 10u], plain[at + 11u]);
  uvec4 row;
  uint told = packed_encode(p, row);
  for (uint c = 0u; c < 4u; ++c) encoded[5u * i + c] = row[c];
  encoded[5u * i + 4u] = told;
}
)";
}

std::string hlsl_of(const PackedLayout& layout) {
  return packed_shader_head(ShaderLanguage::hlsl) + packed_shader_text(layout, ShaderLanguage::hlsl) + R"(
[[vk::binding(0)]] StructuredBuffer<uint4> rows : register(t0);
[[vk::binding(1)]] RWStructuredBuffer<float> decoded : register(u1);
[[vk::binding(2)]] StructuredBuffer<float> plain : register(t2);
[[vk::binding(3)]] RWStructuredBuffer<uint> encoded : register(u3);
[numthreads(64, 1, 1)] void main(uint3 id : SV_DispatchThreadID) {
  uint i = id.x;
  PackedVertex v = packed_decode(rows[i]);
  uint at = 12u * i;
  decoded[at] = v.position.x, decoded[at + 1u] = v.position.y, decoded[at + 2u] = v.position.z;
  decoded[at + 3u] = v.normal.x, decoded[at + 4u] = v.normal.y, decoded[at + 5u] = v.normal.z;
  decoded[at + 6u] = v.tangent.x, decoded[at + 7u] = v.tangent.y, decoded[at + 8u] = v.tangent.z;
  decoded[at + 9u] = v.tangent.w, decoded[at + 10u] = v.uv.x, decoded[at + 11u] = v.uv.y;
  PackedVertex p;
  p.position = float3(plain[at], plain[at + 1u], plain[at + 2u]);
  p.normal = float3(plain[at + 3u], plain[at + 4u], plain[at + 5u]);
  p.tangent = float4(plain[at + 6u], plain[at + 7u], plain[at + 8u], plain[at + 9u]);
  p.uv = float2(plain[at + 10u], plain[at + 11u]);
  uint4 row;
  uint told = packed_encode(p, row);
  encoded[5u * i] = row.x, encoded[5u * i + 1u] = row.y, encoded[5u * i + 2u] = row.z;
  encoded[5u * i + 3u] = row.w, encoded[5u * i + 4u] = told;
}
)";
}

constexpr const char* glsl_arguments = "-V";
constexpr const char* hlsl_arguments = "-D -V -S comp -e main --target-env vulkan1.0";

/// What a device would make of the layout's functions, were it C: twelve floats a vertex, and five words.
struct Wanted {
  std::vector<std::uint32_t> rows, encoded;
  std::vector<float> plain, decoded;

  Wanted(const PackedLayout& layout, std::size_t count) {
    Random random(11);
    const testing::FloatVertices vertices = testing::FloatVertices::random(count, 12);
    for (std::size_t v = 0; v < count; ++v) {
      std::uint32_t row[4];
      foredraw_packed_vertex vertex = vertices.vertex(v);
      if (v % 50 == 7) vertex.position[v % 3] = v % 100 < 50 ? 1.5f : -0.5f;
      if (v % 50 == 8) vertex.normal[0] = vertex.normal[1] = vertex.normal[2] = 0;
      if (v % 50 == 9) std::memcpy(vertex.tangent, vertex.normal, 12);
      if (v % 50 == 10) vertex.uv[v / 50 % 2] = 7;
      append(plain, vertex);
      const std::uint32_t told = foredraw_packed_encode(&layout, &vertex, row);
      encoded.insert(encoded.end(), row, row + 4);
      encoded.push_back(told);
      for (std::uint32_t& word : row) word = static_cast<std::uint32_t>(random.next());
      rows.insert(rows.end(), row, row + 4);
      foredraw_packed_decode(&layout, row, &vertex);
      append(decoded, vertex);
    }
  }

 private:
  static void append(std::vector<float>& to, const foredraw_packed_vertex& vertex) {
    float values[12];
    std::memcpy(values, vertex.position, 12);
    std::memcpy(values + 3, vertex.normal, 12);
    std::memcpy(values + 6, vertex.tangent, 16);
    std::memcpy(values + 10, vertex.uv, 8);
    to.insert(to.end(), values, values + 12);
  }
};

std::vector<PackedLayout> layouts() {
  std::vector<PackedLayout> all{testing::unit_layout(), testing::unit_layout(true)};
  processors::vertex_pack::Demand demand = testing::unit_demand();
  demand.box.add({-300, 20, 1});
  demand.tangents = false;
  all.push_back(processors::vertex_pack::best_layout(demand).value());
  processors::vertex_pack::set_uv_lattice(all.back(), {-2, 0.25}, {3, 0.5});
  demand.normals = demand.uvs = false;
  all.push_back(processors::vertex_pack::best_layout(demand).value());
  return all;
}

class PackedShader : public testing::InFolder {};

TEST_F(PackedShader, IsTakenByACompilerInBothLanguages) {
  if (!testing::has_shader_compiler()) GTEST_SKIP() << "there is no glslangValidator";
  for (const PackedLayout& layout : layouts()) {
    EXPECT_TRUE(compiles(folder_, "glsl", glsl_of(layout), glsl_arguments)) << glsl_of(layout);
    EXPECT_TRUE(compiles(folder_, "hlsl", hlsl_of(layout), hlsl_arguments)) << hlsl_of(layout);
  }
}

#ifdef FOREDRAW_HAS_GPU

/// Runs a compute shader over the vertices, 64 at once, and answers with what it wrote.
void run_on(gpu::Device& device, const std::string& code, const Wanted& wanted, std::vector<float>& decoded,
            std::vector<std::uint32_t>& encoded) {
  std::vector<std::uint32_t> words(code.size() / 4);
  std::memcpy(words.data(), code.data(), 4 * words.size());
  const gpu::OwnedShader shader = gpu::make_shader(device, words);
  const gpu::OwnedSetLayout set_layout = gpu::storage_layout(device, 4, VK_SHADER_STAGE_COMPUTE_BIT);
  const VkDescriptorSetLayout layouts[] = {set_layout.get()};
  const gpu::OwnedPipelineLayout layout = gpu::pipeline_layout(device, layouts, VK_SHADER_STAGE_COMPUTE_BIT, 4);
  const testing::ComputePipeline pipeline = testing::compute_pipeline(device, shader.get(), layout.get());
  const VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  const gpu::DeviceBuffer rows(device, std::as_bytes(std::span(wanted.rows)), storage);
  const gpu::DeviceBuffer plain(device, std::as_bytes(std::span(wanted.plain)), storage);
  const gpu::VisibleBuffer to_decoded(device, 4 * wanted.decoded.size(), storage);
  const gpu::VisibleBuffer to_encoded(device, 4 * wanted.encoded.size(), storage);
  gpu::StorageSets sets(device, set_layout.get(), 4, 1);
  const VkDescriptorSet set = sets.add();
  const VkBuffer buffers[] = {rows.get(), to_decoded.get(), plain.get(), to_encoded.get()};
  sets.write(set, buffers);
  device.run([&](VkCommandBuffer commands) {
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.get());
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout.get(), 0, 1, &set, 0, nullptr);
    vkCmdDispatch(commands, static_cast<std::uint32_t>(wanted.rows.size() / 4 / 64), 1, 1);
    gpu::let_see(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT, VK_PIPELINE_STAGE_HOST_BIT,
                 VK_ACCESS_HOST_READ_BIT);
  });
  decoded.assign(to_decoded.as<float>().begin(), to_decoded.as<float>().end());
  encoded.assign(to_encoded.as<std::uint32_t>().begin(), to_encoded.as<std::uint32_t>().end());
}

using PackedOnDevice = testing::OnDevice;

/// Random rows and vertices, decoded and encoded by both languages.
void expect_bits_of_header(gpu::Device& device, const PackedLayout& layout, std::size_t vertices) {
  const testing::TestFolder own;
  const std::filesystem::path& folder = own.path();
  const Wanted wanted(layout, vertices);
  ASSERT_TRUE(compiles(folder, "glsl", glsl_of(layout), glsl_arguments));
  ASSERT_TRUE(compiles(folder, "hlsl", hlsl_of(layout), hlsl_arguments));
  for (const char* language : {"glsl.spv", "hlsl.spv"}) {
    std::vector<float> decoded;
    std::vector<std::uint32_t> encoded;
    run_on(device, testing::content(folder / language), wanted, decoded, encoded);
    ASSERT_EQ(decoded.size(), wanted.decoded.size());
    EXPECT_EQ(std::memcmp(decoded.data(), wanted.decoded.data(), 4 * decoded.size()), 0) << language;
    EXPECT_TRUE(encoded == wanted.encoded) << language;
  }
}

TEST_F(PackedOnDevice, DecodesAndEncodesToTheBitsOfTheHeader) {
  if (!testing::has_shader_compiler()) GTEST_SKIP() << "there is no glslangValidator";
  gpu::Device device(choice());
  for (const PackedLayout& layout : layouts()) expect_bits_of_header(device, layout, 1 << 12);
}

TEST_F(PackedOnDevice, DecodesAndEncodesAMillionVerticesToTheBitsOfTheHeaderLong) {
  if (!testing::has_shader_compiler()) GTEST_SKIP() << "there is no glslangValidator";
  gpu::Device device(choice());
  const std::vector<PackedLayout> all = layouts();
  for (std::size_t l = 0; l < 2; ++l) {  // which have all fields
    SCOPED_TRACE(l);
    expect_bits_of_header(device, all[l], 1 << 20);
  }
}

#endif

}  // namespace
}  // namespace foredraw::vertex_pack_shader_test
