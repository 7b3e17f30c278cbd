#pragma once
// Wires drawn by the shaders whose text wire_shader.h makes, and the same by wire_radius.h.

#include <foredraw/frames/sample_places.h>
#include <foredraw/gpu/graphics_pipeline.h>
#include <foredraw/gpu/memory.h>
#include <foredraw/gpu/storage_sets.h>
#include <foredraw/runtime/wire_radius.h>
#include <foredraw/viewing/coverage.h>
#include <foredraw/wires/wire_shader.h>

#include "support/compiled_shader.h"
#include "support/thin_scenes.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace foredraw::testing {

struct WireFrame {
  glm::mat4 clip_from_mesh{1};
  glm::vec2 viewport{0};
};

inline constexpr int wire_picture = 96;  ///< pixels along an edge

/// [row][column][sample] How many triangles cover it, of both sides, and the sum of their alphas in 1/65536.
struct WireSample {
  std::uint32_t triangles = 0, alpha = 0;
};

/// What every fragment adds to the samples that it covers, by the functions of the text before it.
inline std::string counting_fragments(bool covers, int samples) {
  const std::string alpha =
      covers
          ? "wire_coverage(wire_section(wire_view(frame.clip_from_mesh, frame.viewport), centre, axis), radii.x, pixel)"
          : "wire_fade(radii.x, radii.y)";
  return R"(layout(location = 0) in vec3 radii;
#ifdef WIRE_COVERAGE
layout(location = 1) in vec3 centre;
layout(location = 2) in vec3 axis;
#endif
layout(set = 0, binding = 0) buffer Samples { uint samples[]; };
layout(push_constant) uniform Frame { mat4 clip_from_mesh; vec2 viewport; } frame;
void main() {
  vec2 pixel = gl_FragCoord.xy;
  uint part = uint()" +
         alpha + " * 65536.0 + 0.5);\n  uint first = " + std::to_string(2 * samples) + "u * (" +
         std::to_string(wire_picture) + "u * uint(pixel.y) + uint(pixel.x));\n  for (uint s = 0u; s < " +
         std::to_string(samples) + R"(u; ++s) {
    if ((gl_SampleMaskIn[0] >> s & 1) == 0) continue;
    atomicAdd(samples[first + 2u * s], 1u);
    atomicAdd(samples[first + 2u * s + 1u], part);
  }
}
)";
}

/// On the device.
class WireDrawing {
 public:
  explicit WireDrawing(gpu::Device& device) : device_(device) {}

  /// `language`: of the vertex shader; fragments are counted in GLSL.
  std::vector<WireSample> drawn(const ThinMesh& mesh, const WireFrame& frame, bool covers, int samples,
                                ShaderLanguage language) {
    const std::string text = wire_shader_text(language);
    const std::string defined = std::string(covers ? "#define WIRE_COVERAGE\n" : "") + "#define WIRE_SAMPLES " +
                                std::to_string(samples) + "\n" + "#define WIRE_VULKAN\n";
    const gpu::OwnedShader vertices =
        make_shader(device_, compiled_shader("#define WIRE_VERTEX\n" + defined + text, language, "vert"));
    const std::string fragment_text =
        defined + wire_shader_text(ShaderLanguage::glsl) + counting_fragments(covers, samples);
    const gpu::OwnedShader fragments =
        make_shader(device_, compiled_shader(fragment_text, ShaderLanguage::glsl, "frag"));
    const std::array inputs = {gpu::VertexInput{0, 0, sizeof(glm::vec3), VK_FORMAT_R32G32B32_SFLOAT},
                               gpu::VertexInput{1, 1, sizeof(glm::vec4), VK_FORMAT_R32G32B32A32_SFLOAT},
                               gpu::VertexInput{2, 2, sizeof(glm::vec4), VK_FORMAT_R32G32B32A32_SFLOAT}};
    gpu::PipelineState state;
    state.layout = layout_.get();
    state.render_pass = pass_.get();
    state.vertex_shader = vertices.get();
    state.fragment_shader = fragments.get();
    state.inputs = inputs;
    state.samples = static_cast<VkSampleCountFlagBits>(samples);
    state.has_pixels = false;
    state.culled = VK_CULL_MODE_NONE;
    const gpu::OwnedPipeline pipeline = graphics_pipeline(device_, state);
    const auto positions = filled(mesh.positions), wires = filled(mesh.wires), axes = filled(mesh.axes);
    const gpu::VisibleBuffer indices = filled(mesh.indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
    const std::size_t count = std::size_t{wire_picture} * wire_picture * static_cast<std::size_t>(samples);
    const gpu::VisibleBuffer result(device_, count * sizeof(WireSample), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    std::ranges::fill(result.as<std::uint32_t>(), 0u);
    gpu::StorageSets sets(device_, set_layout_.get(), 1, 1);
    const VkDescriptorSet set = sets.add();
    sets.write(set, std::array{result.get()});
    device_.run([&](VkCommandBuffer commands) {
      const VkRect2D whole{{0, 0}, {wire_picture, wire_picture}};
      const VkRenderPassBeginInfo info{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO,
                                       .renderPass = pass_.get(),
                                       .framebuffer = framebuffer_.get(),
                                       .renderArea = whole};
      vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
      const VkViewport viewport{0, 0, wire_picture, wire_picture, 0, 1};
      vkCmdSetViewport(commands, 0, 1, &viewport);
      vkCmdSetScissor(commands, 0, 1, &whole);
      vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.get());
      vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.get(), 0, 1, &set, 0, nullptr);
      vkCmdPushConstants(commands, layout_.get(), stages, 0, sizeof(frame), &frame);
      const std::array buffers = {positions.get(), wires.get(), axes.get()};
      const std::array<VkDeviceSize, 3> offsets{};
      vkCmdBindVertexBuffers(commands, 0, buffers.size(), buffers.data(), offsets.data());
      vkCmdBindIndexBuffer(commands, indices.get(), 0, VK_INDEX_TYPE_UINT32);
      vkCmdDrawIndexed(commands, static_cast<std::uint32_t>(mesh.indices.size()), 1, 0, 0, 0);
      vkCmdEndRenderPass(commands);
      gpu::let_see(commands, VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT,
                   VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT);
    });
    const auto all = result.as<WireSample>();
    return {all.begin(), all.end()};
  }

 private:
  static constexpr VkShaderStageFlags stages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;

  template <class T>
  gpu::VisibleBuffer filled(const std::vector<T>& content,
                            VkBufferUsageFlags usage = VK_BUFFER_USAGE_VERTEX_BUFFER_BIT) const {
    gpu::VisibleBuffer buffer(device_, content.size() * sizeof(T), usage);
    std::ranges::copy(content, buffer.as<T>().begin());
    return buffer;
  }
  static VkRenderPassCreateInfo without_attachments() {
    static constexpr VkSubpassDescription subpass{.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS};
    return {.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO, .subpassCount = 1, .pSubpasses = &subpass};
  }
  static VkFramebufferCreateInfo framebuffer_of(VkRenderPass pass) {
    return {.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO,
            .renderPass = pass,
            .width = wire_picture,
            .height = wire_picture,
            .layers = 1};
  }

  gpu::Device& device_;
  gpu::OwnedRenderPass pass_{device_.get(), without_attachments(), "vkCreateRenderPass"};
  gpu::OwnedFramebuffer framebuffer_{device_.get(), framebuffer_of(pass_.get()), "vkCreateFramebuffer"};
  gpu::OwnedSetLayout set_layout_ = gpu::storage_layout(device_, 1, stages);
  gpu::OwnedPipelineLayout layout_ = pipeline_layout(device_, std::array{set_layout_.get()}, stages, sizeof(WireFrame));
};

/// What covers a sample, by the C arithmetic.
struct WireFragment {
  float alpha = 1, lit = 1;
  double depth = 0;  ///< of the sample, as the device stores it
};

/// By the C arithmetic and this project's rasteriser: calls visit(sample, fragment) in the sequence of drawing. What is
/// drawn has to lie ahead of the camera. Samples of a pixel follow each other, pixels run along rows from the top.
template <class Visit>
void for_each_covered_sample(const ThinMesh& mesh, const WireFrame& frame, bool covers, int samples, Visit visit) {
  const foredraw_wire_view view = foredraw_wire_view_of(&frame.clip_from_mesh[0].x, frame.viewport.x, frame.viewport.y);
  struct Vertex {
    Corner corner;
    float inverse = 0, radius = 0, drawn = 0, half_pixel = 0, depth = 0;
    glm::vec3 centre{0};
  };
  std::vector<Vertex> vertices;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::vec4& wire = mesh.wires[v];
    Vertex vertex;
    vertex.centre = mesh.positions[v] + glm::vec3(wire);
    const foredraw_wire_vertex at =
        foredraw_wire_vertex_at(&view, &mesh.positions[v].x, &wire.x, &mesh.axes[v].x, covers ? samples : 0);
    vertex.radius = at.radius;
    vertex.drawn = at.drawn;
    vertex.half_pixel = at.half_pixel;
    const glm::vec4 clip = frame.clip_from_mesh * glm::vec4(at.position[0], at.position[1], at.position[2], 1);
    vertex.inverse = 1 / clip.w;
    vertex.depth = clip.z / clip.w;
    const glm::vec2 half = frame.viewport * 0.5f;
    const glm::vec2 place(clip.x / clip.w * half.x + half.x, clip.y / clip.w * half.y + half.y);
    const auto snapped = [](float pixels) { return static_cast<std::int32_t>(std::floor(pixels * 256 + 0.5f)); };
    vertex.corner = {snapped(place.x), 256 * wire_picture - snapped(place.y), 0};
    vertices.push_back(vertex);
  }
  const SamplePlaces places = standard_places(samples);
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    std::array<const Vertex*, 3> v = {&vertices[mesh.indices[i]], &vertices[mesh.indices[i + 1]],
                                      &vertices[mesh.indices[i + 2]]};
    if (doubled_area(v[0]->corner, v[1]->corner, v[2]->corner) < 0) std::swap(v[1], v[2]);
    const auto area = static_cast<double>(doubled_area(v[0]->corner, v[1]->corner, v[2]->corner));
    if (area == 0) continue;
    const auto edges = edges_of(v[0]->corner, v[1]->corner, v[2]->corner);
    for (std::size_t s = 0; s < places.size(); ++s) {
      std::array<Corner, 3> corners = {v[0]->corner, v[1]->corner, v[2]->corner};
      for (Corner& corner : corners) {
        corner.x -= static_cast<std::int32_t>(places[s].x * 256);
        corner.y -= static_cast<std::int32_t>(places[s].y * 256);
      }
      PixelBox box(corners[0], corners[1], corners[2]);
      box.first_x = std::max(box.first_x, 0);
      box.first_y = std::max(box.first_y, 0);
      box.last_x = std::min(box.last_x, wire_picture - 1);
      box.last_y = std::min(box.last_y, wire_picture - 1);
      for_each_covered(corners[0], corners[1], corners[2], box,
                       [&](std::int32_t x, std::int32_t y, const std::array<std::int64_t, 3>& weights) {
                         std::array<double, 3> parts{};  // in the pixel's middle, wherever the sample is
                         double sum = 0;
                         WireFragment fragment;
                         for (std::size_t c = 0; c < 3; ++c) {
                           parts[c] = static_cast<double>(edges[c].at(x, y)) * static_cast<double>(v[c]->inverse);
                           sum += parts[c];
                           fragment.depth += static_cast<double>(weights[c]) / area * static_cast<double>(v[c]->depth);
                         }
                         float radius = 0, drawn = 0, half_pixel = 0;
                         glm::vec3 centre(0), axis(0);
                         for (std::size_t c = 0; c < 3; ++c) {
                           const auto part = static_cast<float>(parts[c] / sum);
                           radius += part * v[c]->radius;
                           drawn += part * v[c]->drawn;
                           half_pixel += part * v[c]->half_pixel;
                           centre += part * v[c]->centre;
                           axis += part * glm::vec3(mesh.axes[static_cast<std::size_t>(v[c] - vertices.data())]);
                         }
                         const foredraw_wire_section at = foredraw_wire_section_at(&view, &centre.x, &axis.x);
                         const int row = wire_picture - 1 - y;
                         fragment.alpha = covers ? foredraw_wire_coverage(&at, radius, static_cast<float>(x) + 0.5f,
                                                                          static_cast<float>(row) + 0.5f)
                                                 : foredraw_wire_fade(radius, drawn);
                         fragment.lit = foredraw_wire_lit(radius, half_pixel);
                         visit(static_cast<std::size_t>(row * wire_picture + x) * places.size() + s, fragment);
                       });
    }
  }
}

inline std::vector<WireSample> computed(const ThinMesh& mesh, const WireFrame& frame, bool covers, int samples) {
  std::vector<WireSample> result(std::size_t{wire_picture} * wire_picture * static_cast<std::size_t>(samples));
  for_each_covered_sample(mesh, frame, covers, samples, [&](std::size_t sample, const WireFragment& fragment) {
    ++result[sample].triangles;
    result[sample].alpha += static_cast<std::uint32_t>(fragment.alpha * 65536 + 0.5f);
  });
  return result;
}

}  // namespace foredraw::testing
