#pragma once
#include <foredraw/frames/frame_scene.h>
#include <foredraw/frames/rendering.h>
#include <foredraw/gpu/graphics_pipeline.h>
#include <foredraw/gpu/storage_sets.h>
#include <foredraw/gpu/textures.h>

#include <compare>
#include <map>

namespace foredraw {

/// What pipelines of surfaces differ in.
struct SurfaceKind {
  Rendering rendering = Rendering::full;
  AlphaMode alpha_mode = AlphaMode::opaque;
  bool has_base = false, has_normal_map = false;  ///< images
  bool has_normals = false;                       ///< else triangles are flat
  bool is_double_sided = false;
  bool is_mirrored = false;  ///< front faces turn clockwise
  auto operator<=>(const SurfaceKind&) const = default;
};

/// What the shaders are told for each draw.
struct SurfaceConstants {
  glm::vec4 colour;
  float normal_scale;
  float cutoff;
  float near;
};

/// Where the vertex shader finds its attributes: each is a buffer of its own.
enum SurfaceInput : std::uint32_t {
  positions_input,
  normals_input,
  base_places_input,
  normal_map_places_input,
  inputs
};

/// Every pipeline for surfaces, made when it is first asked for. The device has to live longer.
class SurfacePipelines {
 public:
  SurfacePipelines(const gpu::Device& device, VkRenderPass render_pass);

  VkPipelineLayout layout() const { return layout_.get(); }
  VkDescriptorSetLayout frame_layout() const { return frame_layout_.get(); }      ///< set 0: objects, light
  VkDescriptorSetLayout texture_layout() const { return texture_layout_.get(); }  ///< set 1: base, normal map
  VkPipeline get(const SurfaceKind& kind);
  std::size_t made() const { return pipelines_.size(); }

 private:
  gpu::OwnedPipeline make(const SurfaceKind& kind) const;

  const gpu::Device& device_;
  VkRenderPass render_pass_;
  gpu::OwnedSetLayout frame_layout_, texture_layout_;
  gpu::OwnedPipelineLayout layout_;
  gpu::OwnedShader vertex_shader_, fragment_shader_;
  std::map<SurfaceKind, gpu::OwnedPipeline> pipelines_;
};

}  // namespace foredraw
