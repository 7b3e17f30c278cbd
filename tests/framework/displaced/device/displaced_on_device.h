#pragma once
// Surfaces on maps of noise, on Mesa's software driver.

#include <foredraw/base/random.h>
#include <foredraw/displaced/smooth_directions.h>

#include "displaced_drawing.h"
#include "support/meshes.h"
#include "support/on_device.h"

#include <memory>

namespace foredraw::testing {

class DisplacedOnDevice : public OnDevice {
 protected:
  DisplacedOnDevice() : OnDevice("llvmpipe") {}
  void SetUp() override {
    OnDevice::SetUp();
    if (!has_shader_compiler()) GTEST_SKIP() << "there is no glslangValidator";
    if (!IsSkipped()) device_ = std::make_unique<gpu::Device>(choice());
  }
  void TearDown() override {
    device_.reset();
    OnDevice::TearDown();
  }

  std::unique_ptr<gpu::Device> device_;
};

inline float between(Random& random, float low, float high) {
  return low + (high - low) * static_cast<float>(random.unit());
}

/// Heights without any pattern; `step`: they are multiples of it.
inline HeightMap noise(std::uint32_t width, std::uint32_t height, std::uint64_t seed, std::uint32_t step = 1) {
  Random random(seed);
  HeightMap map{width, height, {}};
  for (std::uint32_t i = 0; i < width * height; ++i)
    map.texels.push_back(static_cast<std::uint16_t>(step * random.below(65535 / step + 1)));
  return map;
}

/// A torus whose vertices lie anywhere on a map, also far beyond its edges.
inline DisplacedSurface torus_on_noise(std::uint64_t seed, HeightMap heights, const TestMesh& mesh = torus(9, 7)) {
  Random random(seed);
  DisplacedSurface surface;
  surface.heights = std::move(heights);
  surface.indices = mesh.indices;
  surface.positions = mesh.positions;
  const DirectedPart part{mesh.positions, {}, mesh.indices};
  surface.directions = smooth_directions(std::span(&part, 1)).front();
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    surface.places.push_back({foredraw_height_place(between(random, -3, 3), surface.heights.width),
                              foredraw_height_place(between(random, -3, 3), surface.heights.height)});
  }
  surface.shader.factor = between(random, 0.05f, 0.3f);
  surface.shader.offset = between(random, -0.1f, 0.1f);
  return surface;
}

}  // namespace foredraw::testing
