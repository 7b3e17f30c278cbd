#include <foredraw/crowds/crowd_shader.h>

#include <foredraw/displaced/shader_words.h>

#include <bit>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace foredraw {

namespace {

namespace crowd_parts {

// In words that GLSL and HLSL share; what stands between @ is filled in.

constexpr std::string_view steps = R"(
// How many steps an instance has taken; reaches fall from step to step.
uint crowd_steps(uint instance) {
  float away = @as_float@(crowd_distances[instance]);
  uint taken = 0u;
  while (away >= 0.0 && taken < crowd[1] && away < @as_float@(crowd[2u + taken])) ++taken;
  return taken;
}
)";

constexpr std::string_view count = R"(
@shared@ uint crowd_counted[128];

@main@
  for (uint s = lane; s <= crowd[1]; s += 256u) crowd_counted[s] = 0u;
  @barrier@
  uint instance = 256u * number + lane;
  if (instance < crowd[0]) @add@(crowd_counted[crowd_steps(instance)], 1u);
  @barrier@
  for (uint t = lane; t <= crowd[1]; t += 256u) crowd_counts[t * ((crowd[0] + 255u) / 256u) + number] = crowd_counted[t];
}
)";

constexpr std::string_view scan = R"(
@shared@ uint crowd_sums[256];

@main@
  uint groups = (crowd[0] + 255u) / 256u, all = (crowd[1] + 1u) * groups, each = (all + 255u) / 256u;
  uint from = min(each * lane, all), end = min(from + each, all), sum = 0u;
  for (uint c = from; c < end; ++c) sum += crowd_counts[c];
  crowd_sums[lane] = sum;
  @barrier@
  uint before = 0u;
  for (uint l = 0u; l < lane; ++l) before += crowd_sums[l];
  for (uint d = from; d < end; ++d) {
    uint own = crowd_counts[d];
    crowd_counts[d] = before;
    before += own;
  }
  @barrier_of_buffers@
  for (uint s = lane; s <= crowd[1]; s += 256u) {
    uint first = groups > 0u ? crowd_counts[s * groups] : 0u;
    uint next = s < crowd[1] && groups > 0u ? crowd_counts[(s + 1u) * groups] : crowd[0];
    crowd_draws[@draw_words@u * s + 1u] = next - first;
    crowd_draws[@draw_words@u * s + 4u] = first;
  }
}
)";

constexpr std::string_view place = R"(
@shared@ uint crowd_taken[256];

@main@
  uint instance = 256u * number + lane;
  bool is_there = instance < crowd[0];
  uint own = 0u;
  if (is_there) own = crowd_steps(instance);
  crowd_taken[lane] = own;
  @barrier@
  if (!is_there) return;
  uint before = 0u;
  for (uint l = 0u; l < lane; ++l) before += crowd_taken[l] == own ? 1u : 0u;
  crowd_instances[crowd_counts[own * ((crowd[0] + 255u) / 256u) + number] + before] = instance;
}
)";

}  // namespace crowd_parts

std::string crowd_buffers(const CrowdShader& shader, ShaderLanguage language) {
  std::string text;
  std::uint32_t binding = shader.first_binding;
  for (const char* name : {"crowd", "crowd_distances", "crowd_counts", "crowd_instances", "crowd_draws"}) {
    const std::string at = std::to_string(binding++), set = std::to_string(shader.set);
    text += language == ShaderLanguage::glsl
                ? "layout(std430, set = " + set + ", binding = " + at + ") coherent buffer buffer_of_" + name +
                      " { uint " + name + "[]; };\n"
                : std::string("RWStructuredBuffer<uint> ") + name + " : register(u" + at + ", space" + set + ");\n";
  }
  return text;
}

}  // namespace

std::string crowd_shader_text(const CrowdShader& shader, ShaderLanguage language, CrowdStage stage) {
  if (shader.draw_words < 5) throw std::invalid_argument("an indirect draw has 5 words or more");
  const bool glsl = language == ShaderLanguage::glsl;
  const std::pair<std::string_view, std::string> words[] = {
      {"as_float", glsl ? "uintBitsToFloat" : "asfloat"},
      {"shared", glsl ? "shared" : "groupshared"},
      {"add", glsl ? "atomicAdd" : "InterlockedAdd"},
      {"barrier", glsl ? "barrier();" : "GroupMemoryBarrierWithGroupSync();"},
      {"barrier_of_buffers", glsl ? "memoryBarrierBuffer(); barrier();" : "AllMemoryBarrierWithGroupSync();"},
      {"draw_words", std::to_string(shader.draw_words)},
      {"main", glsl ? "layout(local_size_x = 256) in;\nvoid main() {\n"
                      "  uint lane = gl_LocalInvocationIndex, number = gl_WorkGroupID.x;"
                    : "[numthreads(256, 1, 1)]\n"
                      "void main(uint lane : SV_GroupIndex, uint3 group : SV_GroupID) {\n  uint number = group.x;"}};
  std::string text = crowd_buffers(shader, language);
  if (stage != CrowdStage::scan) text += displaced_shader_parts::filled(crowd_parts::steps, words);
  const std::string_view own = stage == CrowdStage::count  ? crowd_parts::count
                               : stage == CrowdStage::scan ? crowd_parts::scan
                                                           : crowd_parts::place;
  return text + displaced_shader_parts::filled(own, words);
}

std::vector<std::uint32_t> crowd_words(const foredraw_crowd_table& table, double price, std::uint32_t instances) {
  std::vector<std::uint32_t> words{instances, table.steps};
  for (std::uint32_t s = 0; s < table.steps; ++s)
    words.push_back(std::bit_cast<std::uint32_t>(foredraw_crowd_reach(&table, price, s)));
  return words;
}

}  // namespace foredraw
