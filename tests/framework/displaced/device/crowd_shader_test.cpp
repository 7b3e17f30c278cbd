// Crowds sorted by compute shaders on Mesa's software driver, against the C header.

#include <foredraw/crowds/crowd_shader.h>
#include <foredraw/runtime/crowd_select.h>

#include "displaced_on_device.h"

#include <limits>
#include <numeric>

namespace foredraw::crowd_shader_test {
namespace {

using namespace testing;

constexpr std::uint32_t words_of_draw = 7, untouched = 0xabcdef01;

struct Sorted {
  std::vector<std::uint32_t> instances;
  std::vector<std::uint32_t> draws;
};

/// The three stages, one after the other.
Sorted sorted_on(gpu::Device& device, const foredraw_crowd_table& table, double price,
                 const std::vector<float>& distances, ShaderLanguage language) {
  const auto n = static_cast<std::uint32_t>(distances.size());
  const std::uint32_t groups = crowd_groups(n), levels = table.steps + 1;
  std::array<gpu::VisibleBuffer, 5> buffers;
  const std::vector<std::uint32_t> crowd = crowd_words(table, price, n), none(n, untouched),
                                   draws(words_of_draw * levels, untouched), counts(levels * groups, untouched);
  buffers[0] = filled_buffer(device, std::span<const std::uint32_t>(crowd));
  buffers[1] = filled_buffer(device, std::span<const float>(distances));
  buffers[2] = filled_buffer(device, std::span<const std::uint32_t>(counts));
  buffers[3] = filled_buffer(device, std::span<const std::uint32_t>(none));
  buffers[4] = filled_buffer(device, std::span<const std::uint32_t>(draws));
  const gpu::OwnedSetLayout layout = gpu::storage_layout(device, 5, VK_SHADER_STAGE_COMPUTE_BIT);
  gpu::StorageSets sets(device, layout.get(), 5, 1);
  const VkDescriptorSet set = sets.add();
  std::array<VkBuffer, 5> handles;
  for (std::size_t b = 0; b < handles.size(); ++b) handles[b] = buffers[b].get();
  sets.write(set, handles);
  const gpu::OwnedPipelineLayout pipelines =
      pipeline_layout(device, std::array{layout.get()}, VK_SHADER_STAGE_COMPUTE_BIT, 4);
  for (const CrowdStage stage : {CrowdStage::count, CrowdStage::scan, CrowdStage::place}) {
    const std::string text = crowd_shader_text({.draw_words = words_of_draw}, language, stage);
    const gpu::OwnedShader module = make_shader(device, compiled_shader(text, language, "comp"));
    const ComputePipeline pipeline = compute_pipeline(device, module.get(), pipelines.get());
    device.run([&](VkCommandBuffer commands) {
      vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.get());
      vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipelines.get(), 0, 1, &set, 0, nullptr);
      vkCmdDispatch(commands, stage == CrowdStage::scan ? 1 : groups, 1, 1);
      gpu::let_see(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT,
                   VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT);
    });
  }
  const auto instances = buffers[3].as<std::uint32_t>().first(n);
  const auto arguments = buffers[4].as<std::uint32_t>().first(draws.size());
  return {{instances.begin(), instances.end()}, {arguments.begin(), arguments.end()}};
}

/// As the header says it, one instance after the other.
std::uint32_t steps_of(const foredraw_crowd_table& table, double price, float distance) {
  std::uint32_t taken = 0;
  for (std::uint32_t s = 0; s < table.steps; ++s)
    taken += distance >= 0 && distance < foredraw_crowd_reach(&table, price, s) ? 1 : 0;
  return taken;
}

/// The paper's character: parts of edges that halve the error as they double, the plain one, and simplified ones.
foredraw_crowd_table paper_table() {
  std::vector<foredraw_crowd_level> levels;
  for (std::uint32_t parts = 15; parts > 1; --parts)
    levels.push_back({5196 * 3 * parts * parts / 2, 1 / static_cast<float>(parts)});
  levels.push_back({5196, 1});
  for (std::uint32_t i = 1; i < 6; ++i) levels.push_back({5196u >> i, 1 + 0.7f * static_cast<float>(i)});
  foredraw_crowd_table table;
  EXPECT_EQ(foredraw_crowd_prepare(levels.data(), static_cast<std::uint32_t>(levels.size()), &table), 1);
  return table;
}

std::vector<float> random_distances(std::uint32_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<float> distances(n);
  for (float& distance : distances) distance = between(random, 0.1f, 40);
  const float odd[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1, 0, 1e38f};
  for (std::size_t i = 0; i < std::size(odd) && 7 * i < n; ++i) distances[7 * i] = odd[i];
  return distances;
}

TEST_F(DisplacedOnDevice, CrowdsAreSortedAsTheHeaderChooses) {
  const foredraw_crowd_table table = paper_table();
  ASSERT_GT(table.steps, 10u);
  for (const std::uint32_t n : {1u, 2u, 255u, 256u, 257u, 10'007u}) {
    const std::vector<float> distances = random_distances(n, n);
    std::vector<std::byte> memory(foredraw_crowd_memory(&table));
    std::vector<std::uint8_t> chosen(n);
    const std::uint64_t budget = 20'000'000;
    const auto found = foredraw_crowd_select(&table, distances.data(), n, budget, 0, chosen.data(), memory.data());
    std::vector<std::uint32_t> expected(n);
    std::iota(expected.begin(), expected.end(), 0u);
    const auto steps = [&](std::uint32_t i) { return steps_of(table, found.price, distances[i]); };
    std::ranges::stable_sort(expected, {}, steps);
    for (const ShaderLanguage language : {ShaderLanguage::glsl, ShaderLanguage::hlsl}) {
      SCOPED_TRACE(std::to_string(n) + (language == ShaderLanguage::glsl ? " GLSL" : " HLSL"));
      const Sorted sorted = sorted_on(*device_, table, found.price, distances, language);
      EXPECT_TRUE(sorted.instances == expected);
      std::uint32_t first = 0;
      std::uint64_t triangles = 0;
      for (std::uint32_t s = 0; s <= table.steps; ++s) {
        const auto count = static_cast<std::uint32_t>(std::ranges::count(expected, s, steps));
        const auto draw = std::span(sorted.draws).subspan(words_of_draw * s, words_of_draw);
        EXPECT_EQ(draw[1], count);
        EXPECT_EQ(draw[4], first);
        for (const std::size_t other : {0, 2, 3, 5, 6}) EXPECT_EQ(draw[other], untouched);
        first += count;
        triangles += std::uint64_t{count} * table.triangles[s];
      }
      EXPECT_EQ(first, n);
      EXPECT_LE(triangles, std::max(budget, std::uint64_t{n} * table.triangles[0]));
    }
  }
}

}  // namespace
}  // namespace foredraw::crowd_shader_test
