#pragma once
// Frames of a few bodies, drawn as a rasteriser of a device draws them: vertices on 1/256 pixel, depth linear within a
// triangle, the nearest front face in one buffer and the nearest back face in another.

#include "support/meshes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace foredraw::testing {

/// Looks along -z from the origin, 60 degrees from below to above.
struct SmallCamera {
  float near = 1, far = 40;
  bool reversed = false;
  int bits = 32;  ///< of depth: 16, 24, or 32-bit floats
  /// A length at a distance is so many pixels.
  static double pixels_per_unit(int size, double distance) { return 0.5 * focal() * size / distance; }
  static double focal() { return 1 / std::tan(0.5235987755982988); }

  float depth_of(double distance) const {
    const double n = near, f = far;
    return static_cast<float>(reversed ? n * (f - distance) / ((f - n) * distance)
                                       : f * (distance - n) / ((f - n) * distance));
  }
  float stored(double depth) const {
    if (bits == 32) return static_cast<float>(depth);
    const double most = bits == 16 ? 65535 : 16777215;
    return static_cast<float>(std::rint(depth * most) / most);
  }
  float clear() const { return reversed ? 0.f : 1.f; }
  bool is_nearer(float a, float b) const { return reversed ? a > b : a < b; }
};

struct SmallBody {
  TestMesh mesh;  ///< as the camera sees it
  float shade = 1;
};

/// Square.
struct SmallFrame {
  int size = 0;
  std::vector<float> depth, second, colour;  ///< [row * size + column]

  SmallFrame(int pixels, const SmallCamera& camera)
      : size(pixels),
        depth(static_cast<std::size_t>(pixels) * static_cast<std::size_t>(pixels), camera.clear()),
        second(depth),
        colour(depth.size(), 0.05f) {}
};

/// Lit by one light: a colour for each triangle.
inline float colour_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, float shade) {
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double length = glm::length(normal);
  if (length == 0) return 0;
  const double light = std::max(0.0, glm::dot(normal, glm::dvec3(0.4, 0.7, 0.59)) / length);
  return shade * static_cast<float>(0.25 + 0.6 * light + 0.1 * normal.x / length);
}

/// `place`: of the sample in its pixel, from the middle. What lies before the near plane is not drawn.
inline SmallFrame drawn(const std::vector<SmallBody>& bodies, int size, const SmallCamera& camera,
                        const glm::dvec2& place = {0, 0}) {
  SmallFrame frame(size, camera);
  for (const SmallBody& body : bodies) {
    for (std::size_t t = 0; t + 2 < body.mesh.indices.size(); t += 3) {
      std::array<glm::dvec3, 3> at, on;  // on the screen, in pixels from the upper left, and depth
      bool is_before = false;
      for (std::size_t c = 0; c < 3; ++c) {
        at[c] = glm::dvec3(body.mesh.positions[body.mesh.indices[t + c]]);
        const double distance = -at[c].z;
        is_before = is_before || distance < camera.near;
        const double scale = 0.5 * SmallCamera::focal() * size / distance;
        on[c] = {std::rint((0.5 * size + scale * at[c].x) * 256) / 256,
                 std::rint((0.5 * size - scale * at[c].y) * 256) / 256, camera.depth_of(distance)};
      }
      const auto cross = [](const glm::dvec3& o, const glm::dvec3& p, const glm::dvec3& q) {
        return (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
      };
      const double area = cross(on[0], on[1], on[2]);
      if (is_before || area == 0) continue;
      const bool is_front = area < 0;  // y points down
      const float colour = colour_of(at[0], at[1], at[2], body.shade);
      if (is_front) std::swap(on[1], on[2]);
      const glm::dvec3 low = glm::min(on[0], glm::min(on[1], on[2])), high = glm::max(on[0], glm::max(on[1], on[2]));
      const auto pixel = [&](double p) { return std::clamp(static_cast<int>(std::floor(p)), 0, size - 1); };
      for (int y = pixel(low.y - 1); y <= pixel(high.y + 1); ++y) {
        for (int x = pixel(low.x - 1); x <= pixel(high.x + 1); ++x) {
          const glm::dvec3 p(x + 0.5 + place.x, y + 0.5 + place.y, 0);
          std::array<double, 3> part;
          bool is_in = true;
          for (std::size_t e = 0; e < 3; ++e) {
            const glm::dvec3 &from = on[e], &to = on[(e + 1) % 3];
            part[(e + 2) % 3] = cross(from, to, p);
            const bool is_its_edge = to.y < from.y || (to.y == from.y && to.x > from.x);
            is_in = is_in && (part[(e + 2) % 3] > 0 || (part[(e + 2) % 3] == 0 && is_its_edge));
          }
          if (!is_in) continue;
          const double whole = part[0] + part[1] + part[2];
          const float z = camera.stored((part[0] * on[0].z + part[1] * on[1].z + part[2] * on[2].z) / whole);
          const auto i = static_cast<std::size_t>(y * size + x);
          float& kept = is_front ? frame.depth[i] : frame.second[i];
          if (!camera.is_nearer(z, kept)) continue;
          kept = z;
          if (is_front) frame.colour[i] = colour;
        }
      }
    }
  }
  return frame;
}

}  // namespace foredraw::testing
