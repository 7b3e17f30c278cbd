#pragma once
// What the ways to draw tessellated characters fetch, pose and write, counted by a model.
//
// N. Tatarchuk, J. Barczak, B. Purnomo: Real-Time Tessellation on GPU, SIGGRAPH 2008 course notes: multi-pass
// animation, and its vertex compression.

#include <foredraw/crowds/crowd_levels.h>
#include <foredraw/scene/scene.h>

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace foredraw {

/// Who fetches the posed vertices of a triangle that is divided.
enum class CrowdFetching {
  by_patch,   ///< as Vulkan and Direct3D 11: each stored vertex once a pass; corners stay on the chip
  by_vertex,  ///< as the paper's device: each vertex that is made fetches three
};

enum class CrowdPipeline {
  plain,        ///< everybody at the plain level, posed in each pass
  single_pass,  ///< levels as chosen, posed in each pass
  multi_pass,   ///< levels as chosen; vertices are posed once and written, in full floats
  packed,       ///< the same in 16 bytes a vertex
};
inline constexpr CrowdPipeline all_crowd_pipelines[] = {CrowdPipeline::plain, CrowdPipeline::single_pass,
                                                        CrowdPipeline::multi_pass, CrowdPipeline::packed};
constexpr std::string_view to_text(CrowdPipeline of) {
  constexpr std::string_view texts[] = {"plain", "single-pass", "multi-pass", "packed"};
  return texts[static_cast<int>(of)];
}

/// Of an instance, or of many, in a frame.
struct PipelineCost {
  std::uint64_t triangles = 0;  ///< drawn, in all passes
  std::uint64_t posed = 0;      ///< vertices
  std::uint64_t written = 0;    ///< bytes
  std::uint64_t fetched = 0;    ///< bytes

  void add(const PipelineCost& other, std::uint64_t times);
};

/// Bytes of a posed vertex: position and normal of 3 floats, tangent of 4, texture coordinates of 2; and packed.
inline constexpr std::uint64_t posed_bytes = 48, packed_bytes = 16;

/// [pipeline][level] of one instance of the crowd. `passes` draw it: the picture, and maps of shadows. Stored vertices
/// have as many bytes as all their attributes in the scene. Indices and heights are left out: they are alike for all.
std::array<std::vector<PipelineCost>, 4> pipeline_costs(const Scene& scene, const CrowdLevels& levels,
                                                        const Crowd& crowd, CrowdFetching fetching, int passes);

}  // namespace foredraw
