#pragma once
#include <foredraw/frames/frame_scene.h>
#include <foredraw/frames_gpu/private/surface_pipelines.h>
#include <foredraw/gpu/memory.h>
#include <foredraw/gpu/textures.h>

#include <map>
#include <tuple>
#include <vector>

namespace foredraw {

/// Where a level lies on the device, in bytes; what it does not have is wherever there is something.
struct UploadedLevel {
  std::array<VkDeviceSize, inputs> vertices_at{};
  VkDeviceSize indices_at = 0;
  std::uint32_t index_count = 0;
  bool has_normals = false;
};

struct UploadedDraw {
  std::vector<UploadedLevel> levels;
  VkDescriptorSet textures = VK_NULL_HANDLE;
};

/// All levels of all meshes that are shown, and their images, on the device: each image once. Indices are as they are,
/// so that the device's vertex cache finds what it would find in a game; triangles with a position that is not finite
/// are left out.
class UploadedScene {
 public:
  UploadedScene(gpu::Device& device, const FrameScene& scene, VkDescriptorSetLayout texture_layout);

  VkBuffer vertices() const { return vertices_.get(); }
  VkBuffer indices() const { return indices_.get(); }
  const std::vector<UploadedDraw>& draws_of(MeshId mesh) const { return meshes_[mesh]; }

 private:
  VkDescriptorSet uploaded(gpu::Device& device, const FrameSurface& surface);
  gpu::SampledTexture sampled_texture(gpu::Device& device, const MippedImage* image, const Sampling& sampling);

  gpu::TextureSets sets_;
  std::vector<std::vector<UploadedDraw>> meshes_;  // [mesh][draw]
  gpu::DeviceBuffer vertices_, indices_;
  std::map<const MippedImage*, gpu::Texture> textures_;  // null: a white one
  std::map<std::tuple<Wrap, Wrap, bool>, gpu::OwnedSampler> samplers_;
};

}  // namespace foredraw
