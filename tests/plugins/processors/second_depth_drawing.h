#pragma once
// Pieces of a scene drawn on a device: with and without the pass before, their depths, and what the shader resolves.

#include "support/compiled_shader.h"
#include "support/compute_pipeline.h"
#include "support/small_frames.h"

#include <foredraw/gpu/memory.h>
#include <foredraw/gpu/pictures.h>
#include <foredraw/gpu/storage_sets.h>
#include <foredraw/runtime/second_depth.h>

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foredraw::testing {

/// As the camera sees it.
struct Piece {
  TestMesh mesh;
  bool is_closed = false;  ///< it goes into the pass before
  bool is_masked = false;  ///< it has holes
};

inline constexpr std::string_view piece_vertex_shader = R"(
layout(location = 0) in vec4 position;
layout(location = 1) in uint number;
layout(location = 0) flat out uint piece;
invariant gl_Position;
void main() {
  gl_Position = position;
  piece = number;
}
)";
inline constexpr std::string_view piece_depth_shader = R"(
layout(location = 0) flat in uint piece;
layout(location = 0) out uint pixel;
void main() { pixel = floatBitsToUint(gl_FragCoord.z); }
)";
inline constexpr std::string_view piece_number_shader = R"(
layout(location = 0) flat in uint piece;
layout(location = 0) out uint pixel;
void main() {
  if ((piece & 1u) != 0u && ((uint(gl_FragCoord.x) ^ uint(gl_FragCoord.y)) & 2u) == 0u) discard;
  pixel = piece;
}
)";

class SecondDepthDrawing {
 public:
  static constexpr int size = 256;  ///< of pictures, in pixels

  explicit SecondDepthDrawing(gpu::Device& device)
      : device_(device), render_pass_(gpu::make_render_pass(device)), pictures_(device, render_pass_.get(), size) {
    layout_ = gpu::pipeline_layout(device, {}, 0, 0);
    const auto shader = [&](std::string_view text, const char* stage) {
      return gpu::make_shader(device, compiled_shader(std::string(text), ShaderLanguage::glsl, stage));
    };
    vertex_ = shader(piece_vertex_shader, "vert");
    numbers_ = shader(piece_number_shader, "frag");
    depths_ = shader(piece_depth_shader, "frag");
    scene_ = pipeline(numbers_.get(), VK_CULL_MODE_BACK_BIT, VK_COLOR_COMPONENT_R_BIT);
    plain_before_ = pipeline(numbers_.get(), VK_CULL_MODE_FRONT_BIT, 0);
    before_ = pipeline(numbers_.get(), VK_CULL_MODE_FRONT_BIT, 0, 1);
    front_ = pipeline(depths_.get(), VK_CULL_MODE_BACK_BIT, VK_COLOR_COMPONENT_R_BIT);
    back_ = pipeline(depths_.get(), VK_CULL_MODE_FRONT_BIT, VK_COLOR_COMPONENT_R_BIT);
  }

  enum class Before { nothing, plain, biased };

  /// Which triangle of which piece each pixel shows. `before`: the pass with the back faces of what is closed.
  std::vector<std::uint32_t> scene(const std::vector<Piece>& pieces, const SmallCamera& camera, Before before) {
    const Uploaded up(device_, pieces, camera);
    return drawn(up, [&](VkCommandBuffer commands) {
      const VkPipeline pass = before == Before::biased ? before_.get() : plain_before_.get();
      if (before != Before::nothing) draw(commands, pass, pieces, [](const Piece& piece) { return piece.is_closed; });
      draw(commands, scene_.get(), pieces, [](const Piece&) { return true; });
    });
  }

  /// What the device's depth buffer holds of front faces, or of back faces.
  std::vector<float> depths(const std::vector<Piece>& pieces, const SmallCamera& camera, bool of_backs) {
    const Uploaded up(device_, pieces, camera);
    std::vector<float> depths;
    const auto pixels = drawn(up, [&](VkCommandBuffer commands) {
      draw(commands, of_backs ? back_.get() : front_.get(), pieces,
           [&](const Piece& piece) { return piece.is_closed || !of_backs; });
    });
    for (const std::uint32_t bits : pixels) {
      depths.push_back(bits == gpu::empty_pixel ? camera.clear() : std::bit_cast<float>(bits));
    }
    return depths;
  }

  /// The shader's offsets, x and y a pixel.
  std::vector<float> resolved(std::span<const std::uint32_t> code, const std::vector<float>& depth,
                              const std::vector<float>& second, const foredraw_second_depth_rule& rule) {
    const gpu::OwnedShader shader = gpu::make_shader(device_, code);
    const gpu::OwnedSetLayout set_layout = gpu::storage_layout(device_, 3, VK_SHADER_STAGE_COMPUTE_BIT);
    const VkDescriptorSetLayout layouts[] = {set_layout.get()};
    const gpu::OwnedPipelineLayout layout = gpu::pipeline_layout(device_, layouts, VK_SHADER_STAGE_COMPUTE_BIT, 20);
    const ComputePipeline pipeline = compute_pipeline(device_, shader.get(), layout.get());
    constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    const gpu::DeviceBuffer depths(device_, std::as_bytes(std::span(depth)), storage);
    const gpu::DeviceBuffer seconds(device_, std::as_bytes(std::span(second)), storage);
    const gpu::VisibleBuffer offsets(device_, 8 * depth.size(), storage);
    gpu::StorageSets sets(device_, set_layout.get(), 3, 1);
    const VkDescriptorSet set = sets.add();
    const VkBuffer buffers[] = {depths.get(), seconds.get(), offsets.get()};
    sets.write(set, buffers);
    struct {
      foredraw_second_depth_rule rule;
      std::int32_t frame_size;
    } constants{rule, size};
    device_.run([&](VkCommandBuffer commands) {
      vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.get());
      vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout.get(), 0, 1, &set, 0, nullptr);
      vkCmdPushConstants(commands, layout.get(), VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(constants), &constants);
      vkCmdDispatch(commands, size / 8, size / 8, 1);
      gpu::let_see(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT,
                   VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT);
    });
    return {offsets.as<float>().begin(), offsets.as<float>().end()};
  }

 private:
  /// Corners one behind the other, in clip space.
  struct Uploaded {
    gpu::DeviceBuffer positions, numbers;

    Uploaded(gpu::Device& device, const std::vector<Piece>& pieces, const SmallCamera& camera) {
      std::vector<std::array<float, 4>> clip;
      std::vector<std::uint32_t> number;
      for (const Piece& piece : pieces) {
        for (const std::uint32_t v : piece.mesh.indices) {
          const glm::dvec3 p(piece.mesh.positions[v]);
          const double n = camera.near, f = camera.far, scale = SmallCamera::focal();
          clip.push_back({static_cast<float>(scale * p.x), static_cast<float>(-scale * p.y),
                          static_cast<float>(f / (f - n) * (-p.z - n)), static_cast<float>(-p.z)});
          number.push_back(static_cast<std::uint32_t>(number.size() / 3 * 2) + (piece.is_masked ? 1 : 0));
        }
      }
      positions = gpu::DeviceBuffer(device, std::as_bytes(std::span(clip)), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
      numbers = gpu::DeviceBuffer(device, std::as_bytes(std::span(number)), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    }
  };

  gpu::OwnedPipeline pipeline(VkShaderModule fragments, VkCullModeFlags culled, VkColorComponentFlags written,
                              float bias_by_slope = 0) const {
    static constexpr gpu::VertexInput inputs[] = {{0, 0, 16, VK_FORMAT_R32G32B32A32_SFLOAT},
                                                  {1, 1, 4, VK_FORMAT_R32_UINT}};
    gpu::PipelineState state;
    state.layout = layout_.get();
    state.render_pass = render_pass_.get();
    state.vertex_shader = vertex_.get();
    state.fragment_shader = fragments;
    state.inputs = inputs;
    state.culled = culled;
    state.passing = VK_COMPARE_OP_LESS_OR_EQUAL;
    state.written = written;
    state.depth_bias_by_slope = bias_by_slope;
    return gpu::graphics_pipeline(device_, state);
  }

  template <class Draw>
  std::vector<std::uint32_t> drawn(const Uploaded& up, Draw draw) {
    device_.run([&](VkCommandBuffer commands) {
      pictures_.begin(commands, 0);
      const VkBuffer buffers[] = {up.positions.get(), up.numbers.get()};
      const VkDeviceSize offsets[] = {0, 0};
      vkCmdBindVertexBuffers(commands, 0, 2, buffers, offsets);
      draw(commands);
      vkCmdEndRenderPass(commands);
      pictures_.copy_out(commands, 1);
    });
    const auto pixels = pictures_.pixels(0);
    return {pixels.begin(), pixels.end()};
  }

  template <class Goes>
  static void draw(VkCommandBuffer commands, VkPipeline pipeline, const std::vector<Piece>& pieces, Goes goes) {
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
    std::uint32_t first = 0;
    for (const Piece& piece : pieces) {
      const auto corners = static_cast<std::uint32_t>(piece.mesh.indices.size());
      if (goes(piece)) vkCmdDraw(commands, corners, 1, first, 0);
      first += corners;
    }
  }

  gpu::Device& device_;
  gpu::OwnedRenderPass render_pass_;
  gpu::Pictures pictures_;
  gpu::OwnedPipelineLayout layout_;
  gpu::OwnedShader vertex_, numbers_, depths_;
  gpu::OwnedPipeline scene_, plain_before_, before_, front_, back_;
};

}  // namespace foredraw::testing
