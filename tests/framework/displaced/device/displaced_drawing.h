#pragma once
// A displaced surface drawn by the shaders whose text displaced_shader.h makes.

#include "displaced_pipelines.h"

#include "support/capture.h"

#include <gtest/gtest.h>

namespace foredraw::testing {

class DisplacedDrawing : public DisplacedPipelines {
 public:
  struct Corner {
    std::array<float, 3> position, weights;
    std::array<std::uint32_t, 3> vertices;  ///< of the patch
    std::uint32_t instance = 0;
  };
  using Triangle = std::array<Corner, 3>;

  DisplacedDrawing(gpu::Device& device, DisplacedSurface surface, ShaderLanguage language = ShaderLanguage::glsl)
      : DisplacedPipelines(device, std::move(surface), language) {}

  /// What the evaluation stage puts out, triangle by triangle.
  std::vector<Triangle> captured(const DisplacedFrame& frame, std::size_t most) {
    DisplacedShader shader = surface_.shader;
    shader.captures = true;
    const gpu::OwnedPipeline pipeline = pipeline_of(shader, DisplacedStage::vertex, false);
    testing::Capture capture(device_, most * sizeof(Triangle));
    device_.run([&](VkCommandBuffer commands) {
      capture.reset(commands);
      pictures_.begin(commands, 0);
      bind(commands, pipeline.get(), frame);
      capture.begin(commands);
      draw(commands);
      capture.end(commands);
      vkCmdEndRenderPass(commands);
      capture.let_read(commands);
    });
    EXPECT_EQ(capture.triangles().written, capture.triangles().drawn);
    const auto triangles = capture.as<Triangle>().first(capture.triangles().written);
    return {triangles.begin(), triangles.end()};
  }

  /// The cage of all instances as a compute stage poses it; drawings from the cage read this one.
  std::vector<foredraw_cage_vertex> computed_cage() {
    compute(compiled(surface_.shader, DisplacedStage::cage, "comp"), set_, (vertices() + 63) / 64, instances());
    const auto cage = buffers_[3].as<foredraw_cage_vertex>().first(std::size_t{vertices()} * instances());
    return {cage.begin(), cage.end()};
  }

  /// What a compute shader of 64 to a group, behind the functions of the draw's shaders, writes to binding 1 for each
  /// question at binding 0.
  template <class Answer, class Question>
  std::vector<Answer> answered(const std::string& text, const std::vector<Question>& questions) {
    const gpu::VisibleBuffer asked = filled_buffer(device_, std::span<const Question>(questions));
    const gpu::VisibleBuffer given(device_, questions.size() * sizeof(Answer), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    gpu::StorageSets sets(device_, set_layout_.get(), 7, 1);
    const VkDescriptorSet set = sets.add();
    const VkBuffer unused = buffers_[2].get();
    sets.write(set, std::array{asked.get(), given.get(), unused, unused, unused, unused, unused});
    const std::string functions = displaced_shader_text(surface_.shader, language_, DisplacedStage::functions);
    compute(compiled_shader(functions + text, language_, "comp"), set, questions.size() / 64, 1);
    const auto answers = given.as<Answer>();
    return {answers.begin(), answers.end()};
  }

  /// The same by a vertex stage and transform feedback.
  std::vector<foredraw_cage_vertex> captured_cage() {
    const gpu::OwnedShader module =
        make_shader(device_, compiled(surface_.shader, DisplacedStage::cage_capture, "vert"));
    gpu::PipelineState state = state_of(module.get());
    state.topology = VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
    const gpu::OwnedPipeline pipeline = graphics_pipeline(device_, state);
    const std::size_t count = std::size_t{vertices()} * instances();
    testing::Capture capture(device_, count * sizeof(foredraw_cage_vertex));
    device_.run([&](VkCommandBuffer commands) {
      capture.reset(commands);
      pictures_.begin(commands, 0);
      bind(commands, pipeline.get(), {});
      capture.begin(commands);
      vkCmdDraw(commands, vertices(), instances(), 0, 0);
      capture.end(commands);
      vkCmdEndRenderPass(commands);
      capture.let_read(commands);
    });
    const auto cage = capture.as<foredraw_cage_vertex>().first(count);
    return {cage.begin(), cage.end()};
  }

  struct Counts {
    std::uint32_t front = 0, back = 0;
    friend bool operator==(const Counts&, const Counts&) = default;
  };
  /// [pixel][sample] How many triangles cover it.
  std::vector<Counts> counted(const DisplacedFrame& frame, DisplacedStage first = DisplacedStage::vertex) {
    std::ranges::fill(buffers_[6].as<std::uint32_t>(), 0u);
    const gpu::OwnedPipeline pipeline = pipeline_of(surface_.shader, first, true);
    device_.run([&](VkCommandBuffer commands) {
      const VkRect2D whole{{0, 0}, {size, size}};
      const VkRenderPassBeginInfo info{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO,
                                       .renderPass = empty_pass_.get(),
                                       .framebuffer = framebuffer_.get(),
                                       .renderArea = whole};
      vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
      const VkViewport viewport{0, 0, size, size, 0, 1};
      vkCmdSetViewport(commands, 0, 1, &viewport);
      vkCmdSetScissor(commands, 0, 1, &whole);
      bind(commands, pipeline.get(), frame);
      draw(commands);
      vkCmdEndRenderPass(commands);
      gpu::let_see(commands, VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT,
                   VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT);
    });
    const auto counts = buffers_[6].as<Counts>().first(std::size_t{size} * size * samples);
    return {counts.begin(), counts.end()};
  }
};

}  // namespace foredraw::testing
