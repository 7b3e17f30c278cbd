#pragma once
// How fragments are tested and shaded.

#include "uploaded_parts.h"

#include <foredraw/gpu/graphics_pipeline.h>
#include <foredraw/gpu/storage_sets.h>

#include <glm/mat4x4.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <tuple>

namespace foredraw {

/// Which fragment shader: shaders/owner.frag or heavy.frag; of parts with holes masked.frag.
enum class Shading { owner, heavy };

/// What passes: the nearer fragments, or those equally near too.
enum class Passing { nearer, nearer_or_equal };

/// What the shaders are told for each draw.
struct DrawConstants {
  glm::mat4 clip_from_position;
  std::uint32_t owner;  ///< what is written: the part's number
  HoleConstants holes;  ///< of parts that have any
};

/// A render pass for pictures of owners, and every pipeline for it, made when it is first asked for.
class DrawPipelines {
 public:
  explicit DrawPipelines(const gpu::Device& device);

  VkRenderPass render_pass() const { return render_pass_.get(); }
  VkPipelineLayout layout() const { return layout_.get(); }
  VkPipeline get(Shading shading, Passing passing, const UploadedParts::Part& part);
  /// The set that holds the texels of masks, and puts them there: not while commands that use it wait.
  VkDescriptorSet texels() const { return texels_; }
  void put_texels(VkBuffer texels) { sets_.write(texels_, {&texels, 1}); }

 private:
  gpu::OwnedPipeline make(Shading shading, Passing passing, const UploadedParts::Part& part) const;

  const gpu::Device& device_;
  gpu::OwnedRenderPass render_pass_;
  gpu::OwnedSetLayout set_layout_;
  gpu::StorageSets sets_;
  VkDescriptorSet texels_;
  gpu::OwnedPipelineLayout layout_;
  gpu::OwnedShader vertex_shader_;
  gpu::OwnedShader masked_vertex_shader_, masked_fragment_shader_;
  std::array<gpu::OwnedShader, 2> fragment_shaders_;  ///< [Shading]
  std::map<std::tuple<Shading, Passing, VkCullModeFlags, VkFrontFace, bool>, gpu::OwnedPipeline> pipelines_;
};

}  // namespace foredraw
