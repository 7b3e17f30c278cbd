#include <foredraw/gpu/graphics_pipeline.h>
#include <foredraw/gpu/pictures.h>

#include "shaders/patch_frag.h"
#include "shaders/patch_tesc.h"
#include "shaders/patch_tese.h"
#include "shaders/patch_vert.h"
#include "support/capture.h"
#include "support/on_device.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace foredraw::gpu::capture_test {
namespace {

struct Output {
  glm::vec3 weights;
  std::uint32_t patch = 0;
};

/// Two patches, each of which covers half of the picture.
class Patches {
 public:
  explicit Patches(Device& device) : device_(device) {}

  testing::Capture drawn(float level, VkDeviceSize bytes, bool has_fragments = true) {
    const OwnedShader vertex_shader = make_shader(device_, patch_vert),
                      control_shader = make_shader(device_, patch_tesc),
                      evaluation_shader = make_shader(device_, patch_tese),
                      fragment_shader = make_shader(device_, patch_frag);
    constexpr std::array inputs = {VertexInput{0, 0, sizeof(glm::vec2), VK_FORMAT_R32G32_SFLOAT}};
    PipelineState state;
    state.layout = layout_.get();
    state.render_pass = render_pass_.get();
    state.vertex_shader = vertex_shader.get();
    state.control_shader = control_shader.get();
    state.evaluation_shader = evaluation_shader.get();
    if (has_fragments) state.fragment_shader = fragment_shader.get();
    state.inputs = inputs;
    state.culled = VK_CULL_MODE_NONE;
    const OwnedPipeline pipeline = graphics_pipeline(device_, state);
    testing::Capture capture(device_, bytes);
    device_.run([&](VkCommandBuffer commands) {
      capture.reset(commands);
      pictures_.begin(commands, 0);
      vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.get());
      vkCmdPushConstants(commands, layout_.get(), VK_SHADER_STAGE_TESSELLATION_CONTROL_BIT, 0, sizeof(level), &level);
      const VkBuffer corners = corners_.get();
      const VkDeviceSize offset = 0;
      vkCmdBindVertexBuffers(commands, 0, 1, &corners, &offset);
      capture.begin(commands);
      vkCmdDraw(commands, 6, 1, 0, 0);
      capture.end(commands);
      vkCmdEndRenderPass(commands);
      capture.let_read(commands);
      pictures_.copy_out(commands, 1);
    });
    return capture;
  }

  std::ptrdiff_t pixels(std::uint32_t number) const { return std::ranges::count(pictures_.pixels(0), number); }

  static constexpr std::uint32_t size = 64;

 private:
  Device& device_;
  OwnedRenderPass render_pass_ = make_render_pass(device_);
  Pictures pictures_{device_, render_pass_.get(), size};
  OwnedPipelineLayout layout_ = pipeline_layout(device_, {}, VK_SHADER_STAGE_TESSELLATION_CONTROL_BIT, sizeof(float));
  static constexpr std::array<glm::vec2, 6> places = {{{-1, -1}, {1, -1}, {-1, 1}, {-1, 1}, {1, -1}, {1, 1}}};
  DeviceBuffer corners_{device_, std::as_bytes(std::span(places)), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT};
};

class GpuCapture : public testing::OnDevice {
 protected:
  void SetUp() override {
    OnDevice::SetUp();
    if (IsSkipped()) return;
    device_ = std::make_unique<Device>(choice());
    if (!device_->tessellates() || !device_->captures()) GTEST_SKIP() << device_->name() << " does not";
    patches_ = std::make_unique<Patches>(*device_);
  }
  void TearDown() override {
    patches_.reset();
    device_.reset();
    OnDevice::TearDown();
  }

  std::unique_ptr<Device> device_;
  std::unique_ptr<Patches> patches_;
};

constexpr VkDeviceSize enough = 1 << 20;

TEST_F(GpuCapture, has_what_the_evaluation_shader_puts_out) {
  for (const auto& [level, triangles] : {std::pair{1.0f, 1u}, {2.0f, 6u}, {5.0f, 37u}, {16.0f, 384u}}) {
    const testing::Capture capture = patches_->drawn(level, enough);
    EXPECT_EQ(capture.triangles().written, 2u * triangles);
    EXPECT_EQ(capture.triangles().drawn, 2u * triangles);
    const std::span<const Output> outputs = capture.as<Output>();
    for (std::uint32_t i = 0; i < 6 * triangles; ++i) {
      EXPECT_EQ(outputs[i].weights.x + outputs[i].weights.y + outputs[i].weights.z, 1);
      EXPECT_EQ(outputs[i].patch, i / (3 * triangles));
    }
  }
}

TEST_F(GpuCapture, says_how_much_there_was_no_room_for) {
  const testing::Capture capture = patches_->drawn(5, 3 * sizeof(Output) * 10);
  EXPECT_EQ(capture.triangles().written, 10u);
  EXPECT_EQ(capture.triangles().drawn, 74u);
  EXPECT_EQ(capture.as<Output>().size(), 30u);
}

TEST_F(GpuCapture, patches_are_rasterised_beside_it_or_not_at_all) {
  patches_->drawn(7, enough);
  EXPECT_EQ(patches_->pixels(7) + patches_->pixels(8), Patches::size * Patches::size);
  EXPECT_NEAR(static_cast<double>(patches_->pixels(7)), Patches::size * Patches::size / 2.0, Patches::size);
  const testing::Capture capture = patches_->drawn(7, enough, false);
  EXPECT_EQ(capture.triangles().written, 146u);
  EXPECT_EQ(patches_->pixels(empty_pixel), Patches::size * Patches::size);
}

}  // namespace
}  // namespace foredraw::gpu::capture_test
