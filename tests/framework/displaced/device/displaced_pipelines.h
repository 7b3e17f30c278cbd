#pragma once
// What the shaders of a displaced surface are bound to, and pipelines of them.

#include "displaced_surface.h"

#include <foredraw/gpu/graphics_pipeline.h>
#include <foredraw/gpu/pictures.h>
#include <foredraw/gpu/storage_sets.h>
#include <foredraw/gpu/textures.h>

#include "shaders/counted_frag.h"
#include "support/compiled_shader.h"
#include "support/compute_pipeline.h"

#include <algorithm>
#include <memory>

namespace foredraw::testing {

template <class T>
gpu::VisibleBuffer filled_buffer(const gpu::Device& device, std::span<const T> content,
                                 VkBufferUsageFlags usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT) {
  gpu::VisibleBuffer buffer(device, content.size_bytes(), usage);
  std::ranges::copy(content, buffer.as<T>().begin());
  return buffer;
}

class DisplacedPipelines {
 public:
  static constexpr std::uint32_t size = 192;  ///< pixels along an edge of the picture, as in counted.frag
  static constexpr std::uint32_t samples = 4;

  DisplacedPipelines(gpu::Device& device, DisplacedSurface surface, ShaderLanguage language)
      : device_(device), surface_(std::move(surface)), language_(language) {
    surface_.shader.map.width = surface_.heights.width;
    surface_.shader.map.height = surface_.heights.height;
    surface_.shader.vertices = vertices();
    surface_.shader.texels =
        surface_.format == VK_FORMAT_R16_UINT ? DisplacedShader::Texels::whole : DisplacedShader::Texels::normalized;
    const auto rest = cage_vertices(surface_.positions, surface_.directions, surface_.places);
    std::vector<std::array<float, 4>> levels;
    for (const TessellationLevels& of : surface_.levels)
      levels.push_back({of.outer[0], of.outer[1], of.outer[2], of.inner});
    buffers_[0] = filled_buffer(device_, std::span<const foredraw_cage_vertex>(rest));
    buffers_[1] = filled_buffer(device_, std::span<const foredraw_cage_skin>(surface_.skin));
    buffers_[2] = filled_buffer(device_, std::span<const foredraw_cage_map>(surface_.maps));
    buffers_[3] = gpu::VisibleBuffer(device_, instances() * vertices() * sizeof(foredraw_cage_vertex),
                                     VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    buffers_[4] = filled_buffer(device_, std::span<const std::array<float, 4>>(levels));
    buffers_[5] = filled_buffer(device_, std::span<const std::uint32_t>(surface_.seams));
    buffers_[6] = gpu::VisibleBuffer(device_, std::size_t{2} * size * size * samples * sizeof(std::uint32_t),
                                     VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    indices_ =
        filled_buffer(device_, std::span<const std::uint32_t>(surface_.indices), VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
    std::array<VkBuffer, 7> buffers;
    for (std::size_t b = 0; b < buffers.size(); ++b) buffers[b] = buffers_[b].get();
    sets_.write(set_, buffers);
    const std::vector<std::byte> texels = texel_bytes();
    texture_ = std::make_unique<gpu::Texture>(
        device_, std::array{gpu::TextureLevel{surface_.heights.width, surface_.heights.height, texels}},
        surface_.format);
    texture_sets_.write(texture_set_, std::array{gpu::SampledTexture{texture_->view(), sampler_.get()}});
  }

  std::uint32_t vertices() const { return static_cast<std::uint32_t>(surface_.positions.size()); }
  std::uint32_t instances() const {
    return static_cast<std::uint32_t>(surface_.maps.size() / std::max(surface_.shader.joints, 1u));
  }
  const DisplacedSurface& surface() const { return surface_; }

 protected:
  std::vector<std::uint32_t> compiled(const DisplacedShader& shader, DisplacedStage stage, const char* name) const {
    return compiled_shader(displaced_shader_text(shader, language_, stage), language_, name);
  }

  void compute(std::span<const std::uint32_t> code, VkDescriptorSet set, std::size_t columns, std::uint32_t rows) {
    const gpu::OwnedShader module = make_shader(device_, code);
    const ComputePipeline pipeline = compute_pipeline(device_, module.get(), layout_.get());
    device_.run([&](VkCommandBuffer commands) {
      vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.get());
      const std::array sets = {set, texture_set_};
      vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_.get(), 0, sets.size(), sets.data(), 0,
                              nullptr);
      vkCmdDispatch(commands, static_cast<std::uint32_t>(columns), rows, 1);
      gpu::let_see(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT,
                   VK_PIPELINE_STAGE_HOST_BIT | VK_PIPELINE_STAGE_VERTEX_SHADER_BIT,
                   VK_ACCESS_HOST_READ_BIT | VK_ACCESS_SHADER_READ_BIT);
    });
  }

  gpu::PipelineState state_of(VkShaderModule vertex_shader) const {
    gpu::PipelineState state;
    state.layout = layout_.get();
    state.render_pass = render_pass_.get();
    state.vertex_shader = vertex_shader;
    state.culled = VK_CULL_MODE_NONE;
    return state;
  }

  gpu::OwnedPipeline pipeline_of(const DisplacedShader& shader, DisplacedStage first, bool has_fragments) const {
    const gpu::OwnedShader vertex_shader = make_shader(device_, compiled(shader, first, "vert"));
    const gpu::OwnedShader control = make_shader(device_, compiled(shader, DisplacedStage::control, "tesc"));
    const gpu::OwnedShader evaluation = make_shader(device_, compiled(shader, DisplacedStage::evaluation, "tese"));
    const gpu::OwnedShader fragments = make_shader(device_, counted_frag);
    gpu::PipelineState state = state_of(vertex_shader.get());
    state.control_shader = control.get();
    state.evaluation_shader = evaluation.get();
    if (has_fragments) {
      state.fragment_shader = fragments.get();
      state.render_pass = empty_pass_.get();
      state.samples = VK_SAMPLE_COUNT_4_BIT;
      state.has_pixels = false;
    }
    return graphics_pipeline(device_, state);
  }

  void bind(VkCommandBuffer commands, VkPipeline pipeline, const DisplacedFrame& frame) const {
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
    const std::array sets = {set_, texture_set_};
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.get(), 0, sets.size(), sets.data(), 0,
                            nullptr);
    vkCmdPushConstants(commands, layout_.get(), all_stages, 0, sizeof(frame), &frame);
  }
  void draw(VkCommandBuffer commands) const {
    vkCmdBindIndexBuffer(commands, indices_.get(), 0, VK_INDEX_TYPE_UINT32);
    // Mesa numbers what a draw's patches become with 16 bits. Stored levels and seams are found by the number within
    // the draw.
    const auto count = static_cast<std::uint32_t>(surface_.indices.size());
    const bool is_numbered = surface_.shader.levels == DisplacedShader::Levels::stored || surface_.shader.reads_seams;
    const std::uint32_t most = is_numbered ? count : 3 * 20;
    for (std::uint32_t from = 0; from < count; from += most)
      vkCmdDrawIndexed(commands, std::min(most, count - from), instances(), from, 0, 0);
  }

 private:
  static constexpr VkShaderStageFlags all_stages = VK_SHADER_STAGE_ALL_GRAPHICS | VK_SHADER_STAGE_COMPUTE_BIT;

  static VkRenderPassCreateInfo without_attachments() {
    static constexpr VkSubpassDescription subpass{.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS};
    return {.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO, .subpassCount = 1, .pSubpasses = &subpass};
  }
  static VkFramebufferCreateInfo framebuffer_of(VkRenderPass pass) {
    return {.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO,
            .renderPass = pass,
            .width = size,
            .height = size,
            .layers = 1};
  }

  std::vector<std::byte> texel_bytes() const {
    std::vector<std::byte> bytes;
    for (const std::uint16_t height : surface_.heights.texels) {
      if (surface_.format == VK_FORMAT_R8_UNORM) {
        bytes.push_back(static_cast<std::byte>(height / 257));
      } else {
        bytes.push_back(static_cast<std::byte>(height & 255));
        bytes.push_back(static_cast<std::byte>(height >> 8));
      }
    }
    return bytes;
  }

 protected:
  gpu::Device& device_;
  DisplacedSurface surface_;
  ShaderLanguage language_;
  std::array<gpu::VisibleBuffer, 7> buffers_;
  gpu::VisibleBuffer indices_;
  std::unique_ptr<gpu::Texture> texture_;
  gpu::OwnedRenderPass render_pass_ = make_render_pass(device_);
  gpu::Pictures pictures_{device_, render_pass_.get(), 16};
  gpu::OwnedRenderPass empty_pass_{device_.get(), without_attachments(), "vkCreateRenderPass"};
  gpu::OwnedFramebuffer framebuffer_{device_.get(), framebuffer_of(empty_pass_.get()), "vkCreateFramebuffer"};
  gpu::OwnedSampler sampler_ =
      make_sampler(device_, VK_FILTER_NEAREST, VK_SAMPLER_ADDRESS_MODE_REPEAT, VK_SAMPLER_ADDRESS_MODE_REPEAT);
  gpu::OwnedSetLayout set_layout_ = gpu::storage_layout(device_, 7, all_stages);
  gpu::OwnedSetLayout texture_layout_ =
      gpu::set_layout(device_, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, all_stages);
  gpu::StorageSets sets_{device_, set_layout_.get(), 7, 1};
  gpu::TextureSets texture_sets_{device_, texture_layout_.get(), 1, 1};
  VkDescriptorSet set_ = sets_.add(), texture_set_ = texture_sets_.add();
  gpu::OwnedPipelineLayout layout_ = pipeline_layout(device_, std::array{set_layout_.get(), texture_layout_.get()},
                                                     all_stages, sizeof(DisplacedFrame));
};

}  // namespace foredraw::testing
