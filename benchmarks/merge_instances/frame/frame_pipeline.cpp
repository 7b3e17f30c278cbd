#include "frame_pipeline.h"

#include "frame_shaders.h"

#include <foredraw/gpu/graphics_pipeline.h>

#include <stdexcept>

namespace foredraw::bench {

namespace {

VkFormat float_format(const VertexStream& stream, std::uint8_t components) {
  if (stream.format.component != Component::float32 || stream.format.components != components) {
    throw std::runtime_error("frames need attributes of 32-bit floats, but " + stream.semantic + " does not have " +
                             std::to_string(components) + " of them; decode it first");
  }
  return components == 3 ? VK_FORMAT_R32G32B32_SFLOAT : VK_FORMAT_R32G32_SFLOAT;
}

/// What a part's shader reads. Buffer i holds stream i; one more, the instances.
std::vector<gpu::VertexInput> vertex_inputs(const FramePart& part) {
  std::vector<gpu::VertexInput> inputs;
  if (part.fetch == VertexFetch::merged) return inputs;
  std::uint32_t buffer = 0;
  for (const VertexStream& stream : part.vertices->base) {
    const auto add = [&](std::uint32_t location, std::uint8_t components) {
      inputs.push_back({location, buffer, stream.format.bytes, float_format(stream, components)});
    };
    if (stream.semantic == "POSITION") add(location::position, 3);
    if (stream.semantic == "NORMAL") add(location::normal, 3);
    if (stream.semantic == "TEXCOORD_0") add(location::texture_place, 2);
    ++buffer;
  }
  if (part.fetch == VertexFetch::in_world) {
    inputs.push_back({location::instance, buffer, sizeof(std::uint32_t), VK_FORMAT_R32_UINT});
  }
  return inputs;
}

}  // namespace

gpu::OwnedPipeline frame_pipeline(FrameDevice& device, const Scene& scene, const FramePart& part,
                                  std::uint32_t frequency, bool is_mirrored) {
  const std::vector<gpu::VertexInput> inputs = vertex_inputs(part);
  gpu::PipelineState state;
  state.layout = device.layout();
  state.render_pass = device.render_pass();
  state.vertex_shader = device.vertex_shader(vertex_shader_text(scene, part, frequency));
  state.fragment_shader = device.fragment_shader();
  state.inputs = inputs;
  if (is_mirrored) state.front_face = VK_FRONT_FACE_CLOCKWISE;
  return graphics_pipeline(device.device(), state);
}

}  // namespace foredraw::bench
