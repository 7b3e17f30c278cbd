#pragma once
// A Vulkan device with all that frames have in common.

#include "frame_content.h"

#include <foredraw/gpu/pictures.h>

#include <map>
#include <string>

namespace foredraw::bench {

/// Draws square pictures of `size` pixels, of a hash for each pixel, with a depth buffer and without back faces. Used
/// by one thread at a time.
class FrameDevice {
 public:
  /// Throws std::runtime_error where there is no device that will do, or no shader compiler.
  explicit FrameDevice(int size, const gpu::DeviceChoice& choice = {});

  gpu::Device& device() { return device_; }
  VkRenderPass render_pass() const { return render_pass_.get(); }
  const gpu::Pictures& pictures() const { return pictures_; }
  VkPipelineLayout layout() const { return layout_.get(); }
  VkDescriptorSetLayout set_layout() const { return set_layout_.get(); }
  VkShaderModule fragment_shader() const { return fragment_shader_.get(); }
  /// Compiled once for each text.
  VkShaderModule vertex_shader(const std::string& text);

 private:
  gpu::Device device_;
  gpu::OwnedRenderPass render_pass_;
  gpu::Pictures pictures_;
  gpu::OwnedSetLayout set_layout_;
  gpu::OwnedPipelineLayout layout_;
  gpu::OwnedShader fragment_shader_;
  std::map<std::string, gpu::OwnedShader> vertex_shaders_;
};

}  // namespace foredraw::bench
