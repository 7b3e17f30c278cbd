// On a device: the pass with front faces culled changes no pixel, and the shaders resolve the device's own depths as
// runtime/second_depth.h says.
#include "plugins/processors/second_depth/second_depth_shader.h"
#include "plugins/processors/second_depth/shells.h"

#include "hidden_shapes.h"
#include "support/closed_bodies.h"
#include "support/compiled_shader.h"
#include "support/small_frames.h"

#include <foredraw/analysis/welded_positions.h>
#include <foredraw/base/random.h>
#include <foredraw/runtime/second_depth.h>

#include <gtest/gtest.h>

#ifdef FOREDRAW_HAS_GPU
#include "second_depth_drawing.h"
#include "support/on_device.h"
#endif

#include <cstdint>

namespace foredraw::second_depth_device_test {
namespace {

using testing::SmallCamera;
using testing::TestMesh;

constexpr std::string_view resolve_in_glsl = R"(
layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, set = 0, binding = 0) readonly buffer Depths { float depths[]; };
layout(std430, set = 0, binding = 1) readonly buffer Seconds { float seconds[]; };
layout(std430, set = 0, binding = 2) writeonly buffer Offsets { vec2 offsets[]; };
layout(push_constant) uniform Frame { float towards_far, absolute, relative, round_rims; int size; };
float edge(ivec2 at, ivec2 step, int along) {
  int before = min(along, 3), behind = min(size - 1 - along, 3);
  float depth[7], second[7];
  for (int k = -3; k <= 3; ++k) {
    ivec2 from = at + step * clamp(k, -before, behind);
    depth[k + 3] = depths[from.y * size + from.x];
    second[k + 3] = seconds[from.y * size + from.x];
  }
  return second_depth_edge(SecondDepthRule(towards_far, absolute, relative, round_rims), depth, second, before, behind);
}
void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  offsets[at.y * size + at.x] = second_depth_offset(edge(at, ivec2(1, 0), at.x), edge(at, ivec2(0, 1), at.y));
}
)";
constexpr std::string_view resolve_in_hlsl = R"(
[[vk::binding(0)]] StructuredBuffer<float> depths : register(t0);
[[vk::binding(1)]] StructuredBuffer<float> seconds : register(t1);
[[vk::binding(2)]] RWStructuredBuffer<float2> offsets : register(u2);
struct Frame { float towards_far, absolute, relative, round_rims; int size; };
[[vk::push_constant]] ConstantBuffer<Frame> frame;
float edge(int2 at, int2 stride, int along) {
  int before = min(along, 3), behind = min(frame.size - 1 - along, 3);
  float depth[7], second[7];
  for (int k = -3; k <= 3; ++k) {
    int2 from = at + stride * clamp(k, -before, behind);
    depth[k + 3] = depths[from.y * frame.size + from.x];
    second[k + 3] = seconds[from.y * frame.size + from.x];
  }
  SecondDepthRule rule;
  rule.towards_far = frame.towards_far;
  rule.absolute = frame.absolute;
  rule.relative = frame.relative;
  rule.round_rims = frame.round_rims;
  return second_depth_edge(rule, depth, second, before, behind);
}
[numthreads(8, 8, 1)] void main(uint3 id : SV_DispatchThreadID) {
  int2 at = int2(id.xy);
  offsets[at.y * frame.size + at.x] = second_depth_offset(edge(at, int2(1, 0), at.x), edge(at, int2(0, 1), at.y));
}
)";

std::vector<std::uint32_t> resolve_shader(ShaderLanguage language) {
  const std::string_view main = language == ShaderLanguage::glsl ? resolve_in_glsl : resolve_in_hlsl;
  return testing::compiled_shader(second_depth_shader_text(language) + std::string(main), language, "comp");
}

TEST(SecondDepthShader, CompilesInBothLanguages) {
  if (!testing::has_shader_compiler()) GTEST_SKIP() << "there is no glslangValidator";
  for (const ShaderLanguage language : {ShaderLanguage::glsl, ShaderLanguage::hlsl}) {
    EXPECT_FALSE(resolve_shader(language).empty());
  }
}

#ifdef FOREDRAW_HAS_GPU

using testing::Piece;
using Drawing = testing::SecondDepthDrawing;
constexpr int size = Drawing::size;

/// Turned about all axes and put before the camera.
TestMesh placed(TestMesh mesh, Random& random, const glm::dvec3& at) {
  const auto any = [&] { return 6.28 * static_cast<double>(random.below(1 << 20)) / (1 << 20); };
  const double angles[] = {any(), any(), any()};
  for (glm::vec3& p : mesh.positions) {
    glm::dvec3 q(p);
    for (int axis = 0; axis < 3; ++axis) {
      double &a = q[axis], &b = q[(axis + 1) % 3];
      const double c = std::cos(angles[axis]), s = std::sin(angles[axis]), x = a * c - b * s;
      b = a * s + b * c;
      a = x;
    }
    p = glm::vec3(q + at);
  }
  return mesh;
}

/// Bodies that touch, pass through each other and stand before each other; those that the tool would name are closed.
std::vector<Piece> scene(Random& random) {
  const auto any = [&](double most) { return most * (static_cast<double>(random.below(1 << 20)) / (1 << 19) - 1); };
  const auto place = [&] { return glm::dvec3(any(2.5), any(2.5), -6 + any(2)); };
  std::vector<Piece> pieces;
  const auto add = [&](const TestMesh& mesh, bool is_masked = false) {
    const TestMesh there = placed(mesh, random, place());
    const auto kinds = processors::second_depth::kinds_of(there.positions, welded(there.positions), there.indices);
    Piece closed{there, true, false}, other{there, false, is_masked};
    closed.mesh.indices.clear();
    other.mesh.indices.clear();
    for (std::size_t t = 0; t < kinds.size(); ++t) {
      auto& to =
          kinds[t] == processors::second_depth::Kind::closed && !is_masked ? closed.mesh.indices : other.mesh.indices;
      to.insert(to.end(), &there.indices[3 * t], &there.indices[3 * t] + 3);
    }
    for (const Piece& piece : {closed, other}) {
      if (!piece.mesh.indices.empty()) pieces.push_back(piece);
    }
  };
  add(testing::closed_sphere(24, 12, 0.8f));
  add(testing::closed_torus(32, 12, 0.9f, 0.3f));
  add(testing::closed_cylinder(16, 0.4f, 1));
  add(testing::joined(testing::box(0.6f), testing::box(0.6f, {1.2f, 0, 0})));     // a wall in common
  add(testing::joined(testing::box(0.4f), testing::box(0.4f, {0.8f, 0.8f, 0})));  // an edge
  add(testing::joined(testing::box(0.5f), testing::turned(testing::box(0.3f))));  // a double-walled one
  add(testing::box(0.5f, {0, 0, 0}, true));                                       // open
  add(testing::turned(testing::closed_sphere(16, 8, 0.6f)));                      // inside out
  add(testing::joined(testing::box(0.5f), testing::grid(2, 2)));                  // with a sheet in it
  add(testing::closed_sphere(16, 8, 0.7f), true);                                 // masked
  TestMesh twisted = testing::box(0.6f);
  for (std::size_t i = 4; i < 8; ++i) twisted.positions[i].x *= -0.5f;
  add(twisted);
  add(testing::grid(4, 4));
  return pieces;
}

std::size_t different(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i];
  return count;
}

using SecondDepthOnDevice = testing::OnDevice;
using enum Drawing::Before;

/// Vertices are moved to whole 1/256 pixels, so a back face may come before the front within that of the edge where
/// both meet. Moved away by its slope per pixel it does not. As it is, it takes one pixel in 10,000 at most.
TEST_F(SecondDepthOnDevice, ThePassBeforeChangesNoPixel) {
  if (!testing::has_shader_compiler()) GTEST_SKIP() << "there is no glslangValidator";
  gpu::Device device(choice());
  Drawing drawing(device);
  Random random(5);
  std::size_t changed = 0, changed_without_bias = 0, shown = 0;
  for (int view = 0; view < 24; ++view) {
    const std::vector<Piece> pieces = scene(random);
    const SmallCamera camera;
    const auto without = drawing.scene(pieces, camera, nothing);
    changed += different(drawing.scene(pieces, camera, biased), without);
    changed_without_bias += different(drawing.scene(pieces, camera, plain), without);
    shown += static_cast<std::size_t>(std::ranges::count_if(without, [](auto p) { return p != gpu::empty_pixel; }));
  }
  EXPECT_EQ(changed, 0u) << "of " << shown;
  EXPECT_LT(changed_without_bias, shown / 10000);
}

/// Whatever is named wrongly does change the picture: the test above can fail.
TEST_F(SecondDepthOnDevice, ThePassBeforeMustNotHaveWhatIsOpenOrHoldsTheCamera) {
  if (!testing::has_shader_compiler()) GTEST_SKIP() << "there is no glslangValidator";
  gpu::Device device(choice());
  Drawing drawing(device);
  Random random(6);
  const SmallCamera camera;
  std::vector<Piece> pieces = scene(random);
  const auto without = drawing.scene(pieces, camera, nothing);
  for (Piece& piece : pieces) piece.is_closed = true;
  EXPECT_GT(different(drawing.scene(pieces, camera, biased), without), 100u);

  // The camera in a closed room, whose walls are culled from within.
  pieces = scene(random);
  TestMesh room = testing::box(20);
  pieces.push_back({room, false, false});
  const auto outside = drawing.scene(pieces, camera, nothing);
  EXPECT_EQ(different(drawing.scene(pieces, camera, biased), outside), 0u) << "left out, it does no harm";
  pieces.back().mesh = testing::box(4);  // around the camera, before the bodies
  const auto within = drawing.scene(pieces, camera, nothing);
  pieces.back().is_closed = true;
  EXPECT_GT(different(drawing.scene(pieces, camera, biased), within), 100u);
}

TEST_F(SecondDepthOnDevice, ResolvesItsOwnDepthsAsTheHeaderDoes) {
  if (!testing::has_shader_compiler()) GTEST_SKIP() << "there is no glslangValidator";
  gpu::Device device(choice());
  Drawing drawing(device);
  Random random(7);
  const SmallCamera camera;
  const foredraw_second_depth_rule rule = foredraw_second_depth_float(0);
  const auto glsl = resolve_shader(ShaderLanguage::glsl), hlsl = resolve_shader(ShaderLanguage::hlsl);
  std::size_t edges = 0;
  for (int view = 0; view < 6; ++view) {
    const std::vector<Piece> pieces = scene(random);
    const std::vector<float> depth = drawing.depths(pieces, camera, false);
    const std::vector<float> second = drawing.depths(pieces, camera, true);
    std::vector<float> wanted;
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        const auto edge = [&](int at, int dx, int dy) {
          float depths[7], seconds[7];
          const int before = std::min(at, 3), behind = std::min(size - 1 - at, 3);
          for (int k = -3; k <= 3; ++k) {
            const int step = std::clamp(k, -before, behind);
            const auto from = static_cast<std::size_t>((y + dy * step) * size + x + dx * step);
            depths[k + 3] = depth[from];
            seconds[k + 3] = second[from];
          }
          return foredraw_second_depth_edge(&rule, depths, seconds, before, behind);
        };
        float offset[2];
        foredraw_second_depth_offset(edge(x, 1, 0), edge(y, 0, 1), offset);
        edges += offset[0] != 0 || offset[1] != 0;
        wanted.insert(wanted.end(), offset, offset + 2);
      }
    }
    for (const auto* code : {&glsl, &hlsl}) {
      const std::vector<float> given = drawing.resolved(*code, depth, second, rule);
      ASSERT_EQ(given.size(), wanted.size());
      std::size_t wrong = 0;
      for (std::size_t i = 0; i < given.size(); ++i) wrong += !(std::abs(given[i] - wanted[i]) <= 1e-6f);
      EXPECT_EQ(wrong, 0u) << view;
    }
  }
  EXPECT_GT(edges, 5000u);
}

#endif

}  // namespace
}  // namespace foredraw::second_depth_device_test
