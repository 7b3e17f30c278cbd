#include "wire_blending.h"
#include "wire_drawing.h"

#include "support/on_device.h"

#include <glm/gtc/matrix_transform.hpp>

#include <memory>

namespace foredraw::device_wire_shader_test {
namespace {

using testing::ThinMesh;
using testing::WireFrame;

class WiresOnDevice : public testing::OnDevice {
 protected:
  WiresOnDevice() : OnDevice("llvmpipe") {}
  void SetUp() override {
    OnDevice::SetUp();
    if (!testing::has_shader_compiler()) GTEST_SKIP() << "there is no glslangValidator";
    if (!IsSkipped()) device_ = std::make_unique<gpu::Device>(choice());
  }
  void TearDown() override {
    device_.reset();
    OnDevice::TearDown();
  }
  std::unique_ptr<gpu::Device> device_;
};

/// Off-axis, so that rows and columns of the matrix are not taken for each other.
glm::mat4 projection(bool is_orthographic, bool is_reversed) {
  glm::mat4 clip(0);
  if (is_orthographic) {
    clip[0][0] = 0.11f;
    clip[1][1] = 0.13f;
    clip[3] = {0.07f, -0.05f, 0.5f, 1};
    clip[2][2] = -0.002f;
    return clip;
  }
  clip[0][0] = 1.3f;
  clip[1][1] = 1.7f;
  clip[2] = {0.21f, -0.16f, is_reversed ? 0.0f : -1.0f, -1};  // with its far plane at infinity
  clip[3][2] = is_reversed ? 0.1f : -0.1f;
  return clip;
}

glm::mat4 camera() {
  const glm::mat4 rolled = glm::rotate(glm::mat4(1), 0.5f, glm::vec3(0.1f, 0.2f, 0.95f));
  return rolled * glm::translate(glm::mat4(1), glm::vec3(0.3f, -0.2f, -22));
}

/// Straight ones at all angles, a long one towards the camera, and flat ones.
ThinMesh wires(float radius) {
  ThinMesh mesh = testing::lines_at_all_angles(radius, {16, 16});
  mesh.add_tube({{-2, -1.5f, 12}, {3, 2, -200}}, radius, 6);
  mesh.add_ribbon({{-4, 3, 2}, {4, 2, -1}}, glm::normalize(glm::vec3(0.1f, 0.9f, 0.4f)), radius);
  mesh.add_ribbon({{-4, 4, 1}, {0, 4, -1}, {4, 5, 1}}, glm::normalize(glm::vec3(0.02f, 0.1f, 0.99f)), radius);
  return mesh;
}

/// Every sample is covered as often, but one in a thousand and one, which a corner on the border between two places of
/// 1/256 pixel may lose or gain; and every pixel has the same alpha to a step of eight bits.
void expect_equal(gpu::Device& device, const ThinMesh& mesh, const WireFrame& frame, bool covers, int samples,
                  ShaderLanguage language) {
  const auto drawn = testing::WireDrawing(device).drawn(mesh, frame, covers, samples, language);
  const auto computed = testing::computed(mesh, frame, covers, samples);
  ASSERT_EQ(drawn.size(), computed.size());
  const auto n = static_cast<std::size_t>(samples);
  std::size_t covered = 0, differ = 0;
  double farthest = 0;
  for (std::size_t pixel = 0; pixel < drawn.size(); pixel += n) {
    double apart = 0;
    for (std::size_t i = pixel; i < pixel + n; ++i) {
      covered += computed[i].triangles > 0 ? 1 : 0;
      differ += drawn[i].triangles != computed[i].triangles ? 1 : 0;
      if (drawn[i].triangles != computed[i].triangles || drawn[i].triangles == 0) continue;
      apart +=
          std::abs(static_cast<double>(drawn[i].alpha) - static_cast<double>(computed[i].alpha)) / drawn[i].triangles;
    }
    farthest = std::max(farthest, apart / 65536 / samples);
  }
  EXPECT_GT(covered, 300 * n);
  EXPECT_LE(differ, covered / 1000 + 1) << "of " << covered;
  EXPECT_LE(farthest, 1.0 / 255);
}

enum class Projection { perspective, reversed, orthographic };

void expect_as_header(gpu::Device& device, int samples, bool covers, ShaderLanguage language, Projection kind) {
  SCOPED_TRACE(::testing::Message() << samples << covers << static_cast<int>(language) << static_cast<int>(kind));
  const bool is_reversed = kind == Projection::reversed;
  WireFrame frame;
  frame.viewport = glm::vec2(testing::wire_picture);
  frame.clip_from_mesh = projection(kind == Projection::orthographic, is_reversed) * camera();
  expect_equal(device, wires(0.004f), frame, covers, samples, language);
  if (is_reversed) return;
  glm::mat4 uneven = glm::mat4(1);
  uneven[0][0] = -1;  // mirrored
  uneven[2][2] = 5;
  frame.clip_from_mesh = frame.clip_from_mesh * uneven;
  expect_equal(device, testing::lines_at_all_angles(0.01f, {14, 14}), frame, covers, samples, language);
}

/// Each pair of two settings.
TEST_F(WiresOnDevice, DrawWhatTheHeaderSays) {
  using enum ShaderLanguage;
  expect_as_header(*device_, 1, false, glsl, Projection::perspective);
  expect_as_header(*device_, 4, true, hlsl, Projection::perspective);
  expect_as_header(*device_, 1, true, hlsl, Projection::reversed);
  expect_as_header(*device_, 4, false, glsl, Projection::reversed);
  expect_as_header(*device_, 1, false, hlsl, Projection::orthographic);
  expect_as_header(*device_, 4, true, glsl, Projection::orthographic);
}

TEST_F(WiresOnDevice, DrawWhatTheHeaderSaysAtEverySettingLong) {
  for (const int samples : {1, 4}) {
    for (const bool covers : {false, true}) {
      for (const ShaderLanguage language : {ShaderLanguage::glsl, ShaderLanguage::hlsl}) {
        for (const Projection kind : {Projection::perspective, Projection::reversed, Projection::orthographic}) {
          expect_as_header(*device_, samples, covers, language, kind);
        }
      }
    }
  }
}

/// Thin ones and wide ones cross before and behind broad bands, so that all are blended over each other, over the
/// ground and over what is opaque, and hidden as well.
ThinMesh crossing_wires() {
  ThinMesh mesh = wires(0.004f);
  const ThinMesh wide = testing::lines_at_all_angles(0.12f, {12, 12});
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), wide.positions.begin(), wide.positions.end());
  mesh.wires.insert(mesh.wires.end(), wide.wires.begin(), wide.wires.end());
  mesh.axes.insert(mesh.axes.end(), wide.axes.begin(), wide.axes.end());
  for (const std::uint32_t v : wide.indices) mesh.indices.push_back(first + v);
  mesh.add_ribbon({{-6, -1, 0.4f}, {6, -1.5f, -0.6f}}, {0, 1, 0}, 1);
  mesh.add_ribbon({{-6, 2, -0.5f}, {6, 1.5f, 0.5f}}, {0, 1, 0}, 0.7f);
  return mesh;
}

/// Colours as an engine blends them, in eight bits, by the fragment shaders of both languages.
void expect_blended(testing::BlendedWires& drawing, int samples, bool covers, ShaderLanguage language) {
  SCOPED_TRACE(::testing::Message() << samples << covers << static_cast<int>(language));
  const ThinMesh mesh = crossing_wires();
  WireFrame frame;
  frame.viewport = glm::vec2(testing::wire_picture);
  frame.clip_from_mesh = projection(false, false) * camera();
  const std::vector<float> wanted = testing::blended(mesh, frame, covers, samples);
  const std::vector<std::uint8_t> drawn = drawing.drawn(mesh, frame, covers, language);
  std::size_t blended = 0, differ = 0;
  double sum = 0;
  for (std::size_t pixel = 0; pixel < wanted.size(); pixel += 3) {
    double apart = 0, from_ground = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double of_header = wanted[pixel + c];
      apart = std::max(apart, std::abs(static_cast<double>(drawn[pixel + c]) - of_header));
      const double ground = 255.0 * static_cast<double>(testing::wire_ground[static_cast<int>(c)]);
      from_ground = std::max(from_ground, std::abs(of_header - ground));
    }
    blended += from_ground > 1 ? 1 : 0;
    differ += apart > 2 ? 1 : 0;
    sum += apart > 2 ? 0 : apart;
  }
  EXPECT_GT(blended, 800u);
  EXPECT_LE(differ, blended / 200) << "of " << blended;
  EXPECT_LE(sum / static_cast<double>(blended), 0.6) << "rounding to eight bits";
}

/// Each pair of two settings.
TEST_F(WiresOnDevice, BlendAsTheHeaderSays) {
  for (const int samples : {1, 4}) {
    testing::BlendedWires drawing(*device_, samples);
    expect_blended(drawing, samples, false, samples == 1 ? ShaderLanguage::glsl : ShaderLanguage::hlsl);
    expect_blended(drawing, samples, true, samples == 1 ? ShaderLanguage::hlsl : ShaderLanguage::glsl);
  }
}

}  // namespace
}  // namespace foredraw::device_wire_shader_test
