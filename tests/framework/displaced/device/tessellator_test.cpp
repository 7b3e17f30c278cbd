// Patterns and tessellated meshes, against the tessellator of Mesa's software driver and what its shaders sum up.

#include <foredraw/base/random.h>
#include <foredraw/displaced/interpolated.h>
#include <foredraw/gpu/graphics_pipeline.h>
#include <foredraw/gpu/pictures.h>

#include "shaders/equal_tese.h"
#include "shaders/fractional_even_tese.h"
#include "shaders/fractional_odd_tese.h"
#include "shaders/surface_tesc.h"
#include "shaders/surface_vert.h"
#include "support/capture.h"
#include "support/on_device.h"

#include <glm/vec3.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>

namespace foredraw::tessellator_test {
namespace {

using enum TessellationSpacing;

/// What the evaluation shader puts out.
struct Corner {
  std::array<float, 3> weights, position;
  auto operator<=>(const Corner&) const = default;
};
using Triangle = std::array<Corner, 3>;

/// The same wherever the triangle begins.
template <class Three>
Three turned(const Three& triangle) {
  return std::min(
      {triangle, Three{triangle[1], triangle[2], triangle[0]}, Three{triangle[2], triangle[0], triangle[1]}});
}

std::vector<Triangle> sorted(std::vector<Triangle> triangles) {
  for (Triangle& triangle : triangles) triangle = turned(triangle);
  std::ranges::sort(triangles);
  return triangles;
}

class Tessellator {
 public:
  explicit Tessellator(const gpu::DeviceChoice& choice) : device_(choice) {
    const std::array shaders = {std::span<const std::uint32_t>(equal_tese),
                                std::span<const std::uint32_t>(fractional_odd_tese),
                                std::span<const std::uint32_t>(fractional_even_tese)};
    constexpr std::array inputs = {gpu::VertexInput{0, 0, sizeof(glm::vec3), VK_FORMAT_R32G32B32_SFLOAT}};
    for (std::size_t s = 0; s < shaders.size(); ++s) {
      const gpu::OwnedShader evaluation_shader = make_shader(device_, shaders[s]);
      gpu::PipelineState state;
      state.layout = layout_.get();
      state.render_pass = render_pass_.get();
      state.vertex_shader = vertex_shader_.get();
      state.control_shader = control_shader_.get();
      state.evaluation_shader = evaluation_shader.get();
      state.inputs = inputs;
      pipelines_[s] = graphics_pipeline(device_, state);
    }
  }

  /// What becomes of patches of the same levels, three corners each.
  std::vector<Triangle> triangles(std::span<const glm::vec3> corners, const TessellationLevels& levels,
                                  TessellationSpacing spacing) {
    const gpu::DeviceBuffer buffer(device_, std::as_bytes(corners), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    device_.run([&](VkCommandBuffer commands) {
      capture_.reset(commands);
      pictures_.begin(commands, 0);
      vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_[static_cast<std::size_t>(spacing)].get());
      const std::array constants = {levels.outer[0], levels.outer[1], levels.outer[2], levels.inner};
      vkCmdPushConstants(commands, layout_.get(), VK_SHADER_STAGE_TESSELLATION_CONTROL_BIT, 0, sizeof(constants),
                         constants.data());
      const VkBuffer bound = buffer.get();
      const VkDeviceSize offset = 0;
      vkCmdBindVertexBuffers(commands, 0, 1, &bound, &offset);
      capture_.begin(commands);
      vkCmdDraw(commands, static_cast<std::uint32_t>(corners.size()), 1, 0, 0);
      capture_.end(commands);
      vkCmdEndRenderPass(commands);
      capture_.let_read(commands);
    });
    EXPECT_EQ(capture_.triangles().written, capture_.triangles().drawn);
    const auto captured = capture_.as<Triangle>().first(capture_.triangles().written);
    return {captured.begin(), captured.end()};
  }

 private:
  gpu::Device device_;
  gpu::OwnedRenderPass render_pass_ = make_render_pass(device_);
  gpu::Pictures pictures_{device_, render_pass_.get(), 16};
  gpu::OwnedPipelineLayout layout_ =
      pipeline_layout(device_, {}, VK_SHADER_STAGE_TESSELLATION_CONTROL_BIT, 4 * sizeof(float));
  gpu::OwnedShader vertex_shader_ = make_shader(device_, surface_vert);
  gpu::OwnedShader control_shader_ = make_shader(device_, surface_tesc);
  testing::Capture capture_{device_, 2 * 6144 * sizeof(Triangle)};
  std::array<gpu::OwnedPipeline, 3> pipelines_;
};

class OnTessellator : public testing::OnDevice {
 protected:
  OnTessellator() : OnDevice("llvmpipe") {}
  void SetUp() override {
    OnDevice::SetUp();
    if (!IsSkipped()) tessellator_ = std::make_unique<Tessellator>(choice());
  }
  void TearDown() override {
    tessellator_.reset();
    OnDevice::TearDown();
  }

  static constexpr std::array<glm::vec3, 3> corners = {
      {{0.3f, -7.1f, 100.7f}, {-0.9f, 3.3f, 0.001f}, {11.7f, 0.13f, -55.5f}}};

  void expect_the_same(const TessellationLevels& levels, TessellationSpacing spacing) {
    const TessellationPattern pattern = tessellation_pattern(levels, spacing);
    const std::vector<std::uint32_t> indices = {0, 1, 2};
    std::vector<Triangle> expected;
    for (const auto& points : pattern.triangles) {
      Triangle& triangle = expected.emplace_back();
      for (std::size_t c = 0; c < 3; ++c) {
        const auto weights = pattern.points[points[c]].coordinates();
        triangle[c].weights = weights;
        for (int axis = 0; axis < 3; ++axis) {
          triangle[c].position[static_cast<std::size_t>(axis)] =
              weights[0] * corners[0][axis] + weights[1] * corners[1][axis] + weights[2] * corners[2][axis];
        }
      }
    }
    const std::vector<Triangle> found = tessellator_->triangles(corners, levels, spacing);
    ASSERT_EQ(found.size(), expected.size()) << told(levels, spacing);
    EXPECT_TRUE(sorted(found) == sorted(expected)) << told(levels, spacing);
  }

  static std::string told(const TessellationLevels& levels, TessellationSpacing spacing) {
    std::string text = "spacing " + std::to_string(static_cast<int>(spacing)) + ", levels";
    for (const float level : {levels.outer[0], levels.outer[1], levels.outer[2], levels.inner}) {
      text += ' ' + std::to_string(level);
    }
    return text;
  }

  std::unique_ptr<Tessellator> tessellator_;
};

constexpr TessellationSpacing spacings[] = {equal, fractional_odd, fractional_even};

TEST_F(OnTessellator, one_level_for_all) {
  for (const TessellationSpacing spacing : spacings) {
    for (float level = 1; level <= 64; level += 0.5f) expect_the_same({{level, level, level}, level}, spacing);
  }
}

TEST_F(OnTessellator, every_pair_of_an_outer_and_the_inner_level) {
  for (float outer = 1; outer <= 32; ++outer) {  // another edge has the higher ones
    for (float inner = 1; inner <= 64; ++inner) expect_the_same({{outer, 65 - outer, inner}, inner}, equal);
  }
}

TEST_F(OnTessellator, random_levels) {
  Random random(1);
  const auto level = [&] { return static_cast<float>(random.below(3) == 0 ? 6 * random.unit() : 66 * random.unit()); };
  for (const TessellationSpacing spacing : spacings) {
    for (int i = 0; i < 400; ++i) expect_the_same({{level(), level(), level()}, level()}, spacing);
  }
}

TEST_F(OnTessellator, levels_beside_whole_numbers_and_ties) {
  for (const TessellationSpacing spacing : spacings) {
    for (float whole = 1; whole < 64; whole = 2 * whole + 1) {
      for (const float units :
           {-2.0f, -1.5f, -1.0f, -0.75f, -0.5f, -0.25f, 0.25f, 0.5f, 0.75f, 1.0f, 1.5f, 2.0f, 2.5f}) {
        const float level = whole + units / 65536;
        expect_the_same({{level, level, level}, level}, spacing);
        expect_the_same({{level, 1, 1}, 1}, spacing);
        expect_the_same({{1, 1, 1}, level}, spacing);
      }
    }
    expect_the_same({{30.000015f, 30.00006f, 2.00002f}, 30.000015f}, spacing);  // where parts are turned over
  }
}

TEST_F(OnTessellator, levels_that_are_none_or_too_high) {
  constexpr float none = std::numeric_limits<float>::quiet_NaN(), endless = std::numeric_limits<float>::infinity();
  for (const TessellationSpacing spacing : spacings) {
    for (const float odd : {0.0f, -0.0f, -1.0f, -endless, none, 1e-30f, 64.5f, 1e9f, endless}) {
      for (std::size_t e = 0; e < 3; ++e) {
        TessellationLevels levels{{3, 3, 3}, 3};
        levels.outer[e] = odd;
        expect_the_same(levels, spacing);
      }
      expect_the_same({{3, 4, 5}, odd}, spacing);
      expect_the_same({{1, 1, 1}, odd}, spacing);
    }
  }
}

TEST_F(OnTessellator, a_mesh_has_what_shaders_put_out_and_no_crack) {
  // Two triangles at an edge that they go along in opposite directions, each from another corner on.
  const std::vector<glm::vec3> vertices = {
      {0.3f, -7.1f, 100.7f}, {-0.9f, 3.3f, 0.001f}, {11.7f, 0.13f, -55.5f}, {5, 6, 7.7f}};
  const std::vector<std::uint32_t> indices = {0, 1, 2, 3, 2, 1};
  VertexStreams streams;
  streams.count = 4;
  const auto bytes = std::as_bytes(std::span(vertices));
  streams.base = {{"POSITION", {}, Shared<std::byte>(std::vector<std::byte>(bytes.begin(), bytes.end()))}};
  std::vector<glm::vec3> drawn;
  for (const std::uint32_t v : indices) drawn.push_back(vertices[v]);
  for (const TessellationSpacing spacing : spacings) {
    for (const float level : {1.0f, 2.0f, 3.7f, 12.5f, 30.3f, 63.0f, 64.0f}) {
      const TessellationLevels levels{{level, 5, 2.5f}, 6};  // edge 0 is the shared one
      const TessellatedMesh mesh = tessellated_mesh(indices, 4, std::vector(2, levels), spacing);
      const std::vector<glm::vec3> positions = decode_vec3(interpolated(streams, indices, mesh.samples).base[0]);
      const std::vector<Triangle> found = tessellator_->triangles(drawn, levels, spacing);
      ASSERT_EQ(mesh.indices.size(), 3 * found.size());
      using Places = std::array<std::array<float, 3>, 3>;
      std::vector<Places> ours, theirs;
      for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        Places places;
        for (std::size_t c = 0; c < 3; ++c) {
          const glm::vec3& p = positions[mesh.indices[i + c]];
          places[c] = {p.x, p.y, p.z};
        }
        ours.push_back(turned(places));
      }
      for (const Triangle& triangle : found) {
        theirs.push_back(turned(Places{triangle[0].position, triangle[1].position, triangle[2].position}));
      }
      // The first half of the triangles is the first patch's.
      std::array<std::vector<std::array<float, 3>>, 2> along;
      for (std::size_t i = 0; i < found.size(); ++i) {
        for (const Corner& corner : found[i]) {
          if (corner.weights[0] == 0) along[2 * i / found.size()].push_back(corner.position);
        }
      }
      for (auto& points : along) {
        std::ranges::sort(points);
        points.erase(std::unique(points.begin(), points.end()), points.end());
      }
      EXPECT_TRUE(along[0] == along[1]) << told(levels, spacing);
      EXPECT_GT(along[0].size(), effective_level(level, spacing));
      std::ranges::sort(ours);
      std::ranges::sort(theirs);
      EXPECT_TRUE(ours == theirs) << told(levels, spacing);
    }
  }
}

}  // namespace
}  // namespace foredraw::tessellator_test
