#pragma once
// A straight tube that an animation bends by a right angle in its middle.

#include "support/meshes.h"

#include <foredraw/scene/scene.h>

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace foredraw::testing {

struct BendingTube {
  static constexpr float length = 10;  ///< along z
  std::uint32_t around = 24, along = 80;
  float bend = 2;  ///< length of the part that bends

  TestMesh mesh() const {
    TestMesh tube;
    for (std::uint32_t j = 0; j <= along; ++j) {
      for (std::uint32_t i = 0; i < around; ++i) {
        const double angle = 6.283185307179586 * i / around;
        tube.positions.push_back(glm::vec3(std::cos(angle), std::sin(angle), length * static_cast<float>(j) / along));
        if (j == along) continue;
        const std::uint32_t a = j * around + i, b = j * around + (i + 1) % around;
        tube.indices.insert(tube.indices.end(), {a, b, b + around, a, b + around, a + around});
      }
    }
    return tube;
  }

  /// How much the second joint moves a vertex.
  float weight(const glm::vec3& at) const {
    const float t = std::clamp((at.z - length / 2) / bend + 0.5f, 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
  }

  /// Node 0 shows the tube, `size` times as large; joint 1 stands, and joint 2, in the middle, turns by a right angle
  /// within a second.
  Scene scene(float size = 1) const {
    const TestMesh tube = mesh();
    Draw draw = draw_of(tube);
    VertexStreams streams = *draw.full().vertices;
    std::vector<std::uint8_t> joints;
    std::vector<float> weights;
    for (const glm::vec3& at : tube.positions) {
      joints.insert(joints.end(), {0, 1, 0, 0});
      weights.insert(weights.end(), {1 - weight(at), weight(at), 0, 0});
    }
    streams.base.push_back(stream("JOINTS_0", {Component::uint8, 4, false, 4}, joints));
    streams.base.push_back(stream("WEIGHTS_0", {Component::float32, 4, false, 16}, weights));
    draw.full().vertices = std::make_shared<const VertexStreams>(std::move(streams));
    draw.traits.add(traits::animated);
    Scene scene = scene_of({std::move(draw)});
    scene.nodes.resize(4);
    scene.nodes[0].mesh = 0;
    scene.nodes[0].skin = 0;
    scene.nodes[2].transform.translation = {0, 0, length / 2};
    scene.nodes[3].transform.scale = glm::vec3(size);
    scene.nodes[3].children = {1, 2};
    glm::mat4 from_middle(1);
    from_middle[3].z = -length / 2;
    scene.skins.push_back({"", {1, 2}, {glm::mat4(1), from_middle}});
    const float half = std::sqrt(0.5f);
    scene.animations.push_back(
        {"bend",
         {{2, AnimatedPath::rotation, Interpolation::linear, Shared<float>(std::vector<float>{0, 1}),
           Shared<float>(std::vector<float>{0, 0, 0, 1, half, 0, 0, half})}}});
    return scene;
  }

 private:
  template <class T>
  static VertexStream stream(std::string semantic, Format format, const std::vector<T>& values) {
    const auto bytes = std::as_bytes(std::span<const T>(values));
    return {std::move(semantic), format, Shared<std::byte>({bytes.begin(), bytes.end()})};
  }
};

}  // namespace foredraw::testing
