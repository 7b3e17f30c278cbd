#pragma once
// Compute shaders that sort the instances of a crowd by their levels, and leave the arguments of indirect draws: an
// engine then draws each class without asking what was chosen.

#include <foredraw/base/shader_language.h>
#include <foredraw/runtime/crowd_table.h>

#include <cstdint>
#include <string>
#include <vector>

namespace foredraw {

struct CrowdShader {
  std::uint32_t set = 0;            ///< Vulkan's descriptor set of the buffers, or HLSL's register space
  std::uint32_t first_binding = 0;  ///< of five: crowd, distances, counts, instances, draws; in HLSL registers u
  std::uint32_t draw_words = 5;     ///< from one indirect draw to the next, 5 and up: whose words 1 and 4 are written
};

/// In this sequence, with a barrier of compute shaders' writes between two.
enum class CrowdStage : std::uint8_t {
  count,  ///< crowd_groups() groups: how many instances of each 256 are at each level
  scan,   ///< one group: where they begin
  place,  ///< crowd_groups() groups: puts each instance's number where it belongs
};

/// Instances to a group.
inline constexpr std::uint32_t crowd_group = 256;
constexpr std::uint32_t crowd_groups(std::uint32_t instances) { return (instances + crowd_group - 1) / crowd_group; }

/// The text of a stage: GLSL for Vulkan without a version line (450 is needed), or HLSL of shader model 5.1. Entry
/// points are called `main`. Buffers are of 32-bit words:
///
///   crowd      crowd_words(), anew for each frame
///   distances  [instance] floats
///   counts     (steps + 1) * crowd_groups() words, for the stages themselves
///   instances  [place] numbers of instances: those at the level with the fewest triangles, at the next one, ...; each
///              level's rise
///   draws      [steps taken] VkDrawIndexedIndirectCommand, or D3D12_DRAW_INDEXED_ARGUMENTS: number of instances, and
///              the first one's place. What mesh to draw stands in the other words, which the shaders leave alone.
///
/// An instance has taken as many steps as there are with distance < reach, as foredraw_crowd_reach() has them for the
/// price that foredraw_crowd_select() found. So the budget holds for the distances that the price was found for.
/// Distances that are negative or no finite number take no step. The level of those with s steps is table.hull[s];
/// levels of one class (tessellated, plain, simplified) lie side by side, so that a class is one range of places.
///
/// Counts are summed up by prefix, and a place does not hang on which group or lane came first: the same words on every
/// device. Throws std::invalid_argument where draw_words is below 5.
std::string crowd_shader_text(const CrowdShader& shader, ShaderLanguage language, CrowdStage stage);

/// Number of instances and of steps, and how far each step reaches, as bits of floats.
std::vector<std::uint32_t> crowd_words(const foredraw_crowd_table& table, double price, std::uint32_t instances);

}  // namespace foredraw
