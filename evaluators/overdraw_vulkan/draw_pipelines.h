#pragma once
// How fragments are tested and shaded.

#include "uploaded_parts.h"
#include "vulkan_device.h"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <map>
#include <tuple>

namespace foredraw {

/// Which fragment shader: shaders/owner.frag, counted.frag or heavy.frag; of parts with holes masked.frag, which does not
/// count.
enum class Shading { owner, counted, heavy };

/// What passes: the nearer fragments, or those equally near too.
enum class Passing { nearer, nearer_or_equal };

/// What the shaders are told for each draw.
struct DrawConstants {
  glm::mat4 clip_from_position;
  std::uint32_t owner;    ///< what is written: the part's number
  std::uint32_t counter;  ///< of `counted`: which one
  // Of parts with holes, as UploadedParts::Holes.
  std::uint32_t first_texel, width, height, wrap_u, wrap_v, is_nearest;
  float cutoff;
};

/// Written where no part was.
inline constexpr std::uint32_t nobody = ~std::uint32_t{0};

/// A render pass that clears an owner (R32_UINT) and a depth attachment, and every pipeline for it, made when it is
/// first asked for. Viewport and scissor are set by whoever draws, so the pipelines serve every size of picture.
class DrawPipelines {
 public:
  explicit DrawPipelines(const VulkanDevice& device);

  VkRenderPass render_pass() const { return render_pass_.get(); }
  VkPipelineLayout layout() const { return layout_.get(); }
  VkPipeline get(Shading shading, Passing passing, Culled culled, bool has_holes);
  /// The set that holds the counters of `counted`.
  VkDescriptorSet counters_at(VkBuffer counters);
  /// The set that holds the texels of masks, and puts them there: not while commands that use it wait.
  VkDescriptorSet texels() const { return texels_; }
  void put_texels(VkBuffer texels) { write(texels_, texels); }

 private:
  OwnedPipeline make(Shading shading, Passing passing, Culled culled, bool has_holes) const;
  VkDescriptorSet allocated() const;
  void write(VkDescriptorSet set, VkBuffer buffer) const;

  const VulkanDevice& device_;
  OwnedRenderPass render_pass_;
  OwnedSetLayout set_layout_;
  OwnedDescriptorPool set_pool_;
  VkDescriptorSet counters_ = VK_NULL_HANDLE;
  VkDescriptorSet texels_ = VK_NULL_HANDLE;
  OwnedPipelineLayout layout_;
  OwnedShader vertex_shader_;
  OwnedShader masked_vertex_shader_, masked_fragment_shader_;
  std::map<Shading, OwnedShader> fragment_shaders_;
  std::map<std::tuple<Shading, Passing, Culled, bool>, OwnedPipeline> pipelines_;
};

}  // namespace foredraw
