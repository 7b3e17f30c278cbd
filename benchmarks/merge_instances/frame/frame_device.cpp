#include "frame_device.h"

#include "frame_shaders.h"
#include "shader_compiler.h"

#include <foredraw/gpu/graphics_pipeline.h>
#include <foredraw/gpu/storage_sets.h>

#include <array>

namespace foredraw::bench {

namespace {

gpu::OwnedShader shader_of(const gpu::Device& device, const std::string& text, const char* stage) {
  return gpu::make_shader(device, compiled_shader(text, stage));
}

}  // namespace

FrameDevice::FrameDevice(int size, const gpu::DeviceChoice& choice)
    : device_(choice),
      render_pass_(gpu::make_render_pass(device_)),
      pictures_(device_, render_pass_.get(), size),
      set_layout_(gpu::storage_layout(device_, binding::count, VK_SHADER_STAGE_VERTEX_BIT)),
      layout_(gpu::pipeline_layout(device_, std::array{set_layout_.get()}, VK_SHADER_STAGE_VERTEX_BIT,
                                   sizeof(FrameConstants))),
      fragment_shader_(shader_of(device_, fragment_shader_text(), "frag")) {}

VkShaderModule FrameDevice::vertex_shader(const std::string& text) {
  gpu::OwnedShader& shader = vertex_shaders_[text];
  if (shader.get() == VK_NULL_HANDLE) shader = shader_of(device_, text, "vert");
  return shader.get();
}

}  // namespace foredraw::bench
