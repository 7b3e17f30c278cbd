#include "draw_pipelines.h"

#include <foredraw/gpu/pictures.h>

#include "shaders/draw_vert.h"
#include "shaders/heavy_frag.h"
#include "shaders/masked_frag.h"
#include "shaders/masked_vert.h"
#include "shaders/owner_frag.h"

#include <glm/vec3.hpp>

#include <array>
#include <span>

namespace foredraw {

using gpu::make_shader;

DrawPipelines::DrawPipelines(const gpu::Device& device)
    : device_(device),
      render_pass_(make_render_pass(device)),
      set_layout_(storage_layout(device, 1, VK_SHADER_STAGE_FRAGMENT_BIT)),
      sets_(device, set_layout_.get(), 1, 1),
      texels_(sets_.add()),
      layout_(pipeline_layout(device, std::array{set_layout_.get()},
                              VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, sizeof(DrawConstants))),
      vertex_shader_(make_shader(device, draw_vert)),
      masked_vertex_shader_(make_shader(device, masked_vert)),
      masked_fragment_shader_(make_shader(device, masked_frag)),
      fragment_shaders_{make_shader(device, owner_frag), make_shader(device, heavy_frag)} {}

VkPipeline DrawPipelines::get(Shading shading, Passing passing, const UploadedParts::Part& part) {
  gpu::OwnedPipeline& pipeline = pipelines_[{shading, passing, part.culled, part.front_face, part.holes.has_value()}];
  if (pipeline.get() == VK_NULL_HANDLE) pipeline = make(shading, passing, part);
  return pipeline.get();
}

gpu::OwnedPipeline DrawPipelines::make(Shading shading, Passing passing, const UploadedParts::Part& part) const {
  const bool has_holes = part.holes.has_value();
  const VkBool32 is_heavy = shading == Shading::heavy ? VK_TRUE : VK_FALSE;
  const VkSpecializationMapEntry entry{0, 0, sizeof(is_heavy)};
  const VkSpecializationInfo special{1, &entry, sizeof(is_heavy), &is_heavy};
  // Positions, and of parts with holes the places in their images.
  constexpr std::array inputs = {gpu::VertexInput{0, 0, sizeof(glm::vec3), VK_FORMAT_R32G32B32_SFLOAT},
                                 gpu::VertexInput{1, 1, sizeof(glm::vec3), VK_FORMAT_R32G32B32_SFLOAT}};
  gpu::PipelineState state;
  state.layout = layout();
  state.render_pass = render_pass();
  state.vertex_shader = has_holes ? masked_vertex_shader_.get() : vertex_shader_.get();
  state.fragment_shader =
      has_holes ? masked_fragment_shader_.get() : fragment_shaders_[static_cast<std::size_t>(shading)].get();
  state.fragment_constants = has_holes ? &special : nullptr;
  state.inputs = std::span(inputs).first(has_holes ? 2 : 1);
  state.culled = part.culled;
  state.front_face = part.front_face;
  if (passing == Passing::nearer_or_equal) state.passing = VK_COMPARE_OP_LESS_OR_EQUAL;
  return graphics_pipeline(device_, state);
}

}  // namespace foredraw
