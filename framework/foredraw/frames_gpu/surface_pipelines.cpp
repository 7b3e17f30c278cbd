#include <foredraw/frames_gpu/private/surface_pipelines.h>

#include "shaders/surface_frag.h"
#include "shaders/surface_vert.h"

#include <array>

namespace foredraw {

namespace {

constexpr VkShaderStageFlags both_stages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;

constexpr std::array attributes = {
    gpu::VertexInput{0, positions_input, sizeof(glm::vec3), VK_FORMAT_R32G32B32_SFLOAT},
    gpu::VertexInput{1, normals_input, sizeof(glm::vec3), VK_FORMAT_R32G32B32_SFLOAT},
    gpu::VertexInput{2, base_places_input, sizeof(glm::vec2), VK_FORMAT_R32G32_SFLOAT},
    gpu::VertexInput{3, normal_map_places_input, sizeof(glm::vec2), VK_FORMAT_R32G32_SFLOAT}};

}  // namespace

SurfacePipelines::SurfacePipelines(const gpu::Device& device, VkRenderPass render_pass)
    : device_(device),
      render_pass_(render_pass),
      frame_layout_(gpu::storage_layout(device, 2, both_stages)),
      texture_layout_(gpu::texture_layout(device, 2)),
      layout_(gpu::pipeline_layout(device, std::array{frame_layout(), texture_layout()}, both_stages,
                                   sizeof(SurfaceConstants))),
      vertex_shader_(gpu::make_shader(device, surface_vert)),
      fragment_shader_(gpu::make_shader(device, surface_frag)) {}

VkPipeline SurfacePipelines::get(const SurfaceKind& kind) {
  gpu::OwnedPipeline& pipeline = pipelines_[kind];
  if (pipeline.get() == VK_NULL_HANDLE) pipeline = make(kind);
  return pipeline.get();
}

gpu::OwnedPipeline SurfacePipelines::make(const SurfaceKind& kind) const {
  // shaders/surface.frag, constant_id
  const std::array<std::uint32_t, 5> constants = {static_cast<std::uint32_t>(kind.rendering), kind.has_base ? 1u : 0u,
                                                  kind.has_normal_map ? 1u : 0u, kind.has_normals ? 1u : 0u,
                                                  kind.alpha_mode == AlphaMode::mask ? 1u : 0u};
  std::array<VkSpecializationMapEntry, constants.size()> entries{};
  for (std::uint32_t i = 0; i < entries.size(); ++i) entries[i] = {i, i * 4, 4};
  const VkSpecializationInfo special{entries.size(), entries.data(), sizeof(constants), constants.data()};
  const bool is_blended = kind.alpha_mode == AlphaMode::blend;
  gpu::PipelineState state;
  state.layout = layout();
  state.render_pass = render_pass_;
  state.vertex_shader = vertex_shader_.get();
  state.fragment_shader = fragment_shader_.get();
  state.fragment_constants = &special;
  state.inputs = attributes;
  state.culled = kind.is_double_sided ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT;
  state.front_face = kind.is_mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE;
  state.passing = VK_COMPARE_OP_GREATER;
  state.writes_depth = !is_blended;
  state.written = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT;
  state.blends = is_blended;
  return gpu::graphics_pipeline(device_, state);
}

}  // namespace foredraw
