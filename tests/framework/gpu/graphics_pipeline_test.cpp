#include <foredraw/gpu/graphics_pipeline.h>
#include <foredraw/gpu/memory.h>
#include <foredraw/gpu/pictures.h>
#include <foredraw/gpu/queries.h>
#include <foredraw/gpu/storage_sets.h>

#include "shaders/numbered_frag.h"
#include "shaders/numbered_vert.h"
#include "support/on_device.h"

#include <glm/vec2.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace foredraw::gpu::graphics_pipeline_test {
namespace {

constexpr std::uint32_t size = 64;

template <class T, std::size_t count>
DeviceBuffer uploaded(Device& device, const std::array<T, count>& content, VkBufferUsageFlags usage) {
  return {device, std::as_bytes(std::span(content)), usage};
}

/// Two triangles that turn clockwise on the screen, each of which covers all of it. The second one lies behind the
/// first.
class Drawing {
 public:
  explicit Drawing(const DeviceChoice& choice) : device_(choice) {
    const std::array<std::uint32_t, 1> offset = {100};
    const std::array<std::uint32_t, 3> numbers = {1, 20, 3};
    const std::array<glm::vec2, 3> corners = {{{-1, -1}, {3, -1}, {-1, 3}}};
    offset_ = uploaded(device_, offset, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    numbers_ = uploaded(device_, numbers, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    corners_ = uploaded(device_, corners, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    depths_ =
        uploaded(device_, std::array{0.25f, 0.25f, 0.25f, 0.75f, 0.75f, 0.75f}, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    sets_.write(set_, std::array{offset_.get(), numbers_.get()});
  }

  struct Seen {
    std::uint32_t number = 0;           ///< everywhere, or empty_pixel
    std::vector<std::uint64_t> passed;  ///< [triangle] fragments
  };

  /// Triangle by triangle, 0: the near one.
  Seen seen(PipelineState state, std::vector<std::uint32_t> triangles) {
    constexpr std::array inputs = {VertexInput{1, 0, sizeof(float), VK_FORMAT_R32_SFLOAT},
                                   VertexInput{0, 1, sizeof(glm::vec2), VK_FORMAT_R32G32_SFLOAT}};
    state.layout = layout_.get();
    state.render_pass = render_pass_.get();
    state.vertex_shader = vertex_shader_.get();
    state.fragment_shader = fragment_shader_.get();
    state.inputs = inputs;
    const OwnedPipeline pipeline = graphics_pipeline(device_, state);
    Seen seen;
    seen.passed.resize(triangles.size());
    const Queries queries(device_, VK_QUERY_TYPE_OCCLUSION, static_cast<std::uint32_t>(triangles.size()));
    device_.run([&](VkCommandBuffer commands) {
      queries.reset(commands);
      pictures_.begin(commands, 0);
      vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.get());
      vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.get(), 0, 1, &set_, 0, nullptr);
      for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const std::uint32_t which = triangles[i];
        const std::array buffers = {depths_.get(), corners_.get()};
        const std::array<VkDeviceSize, 2> offsets = {3 * sizeof(float) * which, 0};
        vkCmdBindVertexBuffers(commands, 0, buffers.size(), buffers.data(), offsets.data());
        vkCmdPushConstants(commands, layout_.get(), VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(which), &which);
        vkCmdBeginQuery(commands, queries.get(), i, VK_QUERY_CONTROL_PRECISE_BIT);
        vkCmdDraw(commands, 3, 1, 0, 0);
        vkCmdEndQuery(commands, queries.get(), i);
      }
      vkCmdEndRenderPass(commands);
      pictures_.copy_out(commands, 1);
    });
    queries.read(0, seen.passed);
    const auto pixels = pictures_.pixels(0);
    seen.number = pixels[0];
    EXPECT_EQ(std::ranges::count(pixels, seen.number), size * size);
    return seen;
  }

 private:
  Device device_;
  OwnedRenderPass render_pass_ = make_render_pass(device_);
  Pictures pictures_{device_, render_pass_.get(), size};
  OwnedSetLayout set_layout_ = storage_layout(device_, 2, VK_SHADER_STAGE_VERTEX_BIT);
  StorageSets sets_{device_, set_layout_.get(), 2, 1};
  VkDescriptorSet set_ = sets_.add();
  OwnedPipelineLayout layout_ =
      pipeline_layout(device_, std::array{set_layout_.get()}, VK_SHADER_STAGE_VERTEX_BIT, sizeof(std::uint32_t));
  OwnedShader vertex_shader_ = make_shader(device_, numbered_vert);
  OwnedShader fragment_shader_ = make_shader(device_, numbered_frag);
  DeviceBuffer offset_, numbers_, corners_, depths_;
};

constexpr std::uint64_t all = size * size;

using GraphicsPipeline = testing::OnDevice;

TEST_F(GraphicsPipeline, reads_its_vertices_buffers_and_constants) {
  Drawing drawing(choice());
  PipelineState state;
  state.front_face = VK_FRONT_FACE_CLOCKWISE;
  EXPECT_EQ(drawing.seen(state, {0}).number, 101u);
  EXPECT_EQ(drawing.seen(state, {1}).number, 120u);
  const std::uint32_t factor = 7;
  const VkSpecializationMapEntry entry{0, 0, sizeof(factor)};
  const VkSpecializationInfo constants{1, &entry, sizeof(factor), &factor};
  state.fragment_constants = &constants;
  EXPECT_EQ(drawing.seen(state, {1}).number, 840u);
}

TEST_F(GraphicsPipeline, shows_what_is_near_whatever_the_sequence) {
  Drawing drawing(choice());
  PipelineState state;
  state.front_face = VK_FRONT_FACE_CLOCKWISE;
  const Drawing::Seen behind_first = drawing.seen(state, {1, 0});
  EXPECT_EQ(behind_first.number, 101u);
  EXPECT_EQ(behind_first.passed, (std::vector<std::uint64_t>{all, all}));
  const Drawing::Seen near_first = drawing.seen(state, {0, 1, 0});
  EXPECT_EQ(near_first.number, 101u);
  EXPECT_EQ(near_first.passed, (std::vector<std::uint64_t>{all, 0, 0}));
  state.passing = VK_COMPARE_OP_LESS_OR_EQUAL;
  EXPECT_EQ(drawing.seen(state, {0, 1, 0}).passed, (std::vector<std::uint64_t>{all, 0, all}));
}

TEST_F(GraphicsPipeline, leaves_out_faces_that_are_culled) {
  Drawing drawing(choice());
  EXPECT_EQ(drawing.seen({}, {0}).number, empty_pixel);  // front faces turn counter-clockwise
  PipelineState both_sides;
  both_sides.culled = VK_CULL_MODE_NONE;
  EXPECT_EQ(drawing.seen(both_sides, {0}).number, 101u);
}

}  // namespace
}  // namespace foredraw::gpu::graphics_pipeline_test
