#pragma once
// Triangles on their way into the picture: cut where they leave what can be drawn.

#include <foredraw/viewing/coverage.h>

#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace foredraw {

/// A vertex before it is divided by its distance.
struct ViewVertex {
  float x = 0, y = 0;  ///< place in the picture in 1/256 sample, times w
  float w = 0;         ///< distance ahead of the camera
};

/// Places up to here are exact in a Corner's whole numbers.
inline constexpr float farthest_place = 1 << 22;

inline bool is_drawable(const ViewVertex& v, float near) {
  return v.w >= near && std::abs(v.x) <= farthest_place * v.w && std::abs(v.y) <= farthest_place * v.w;
}

/// A corner of what is left of a triangle: its place, and what share of it each of the triangle's own corners has.
struct CutCorner {
  ViewVertex at;
  glm::vec3 shares{0};
};

/// What of the triangle can be drawn: a convex polygon, empty where nothing is left. Neighbours are cut in the same
/// places along a common edge.
inline void cut_to_drawable(const std::array<ViewVertex, 3>& corners, float near, std::vector<CutCorner>& polygon) {
  polygon.clear();
  for (std::size_t i = 0; i < 3; ++i) {
    if (!std::isfinite(corners[i].x) || !std::isfinite(corners[i].y) || !std::isfinite(corners[i].w)) {
      polygon.clear();
      return;
    }
    polygon.push_back({corners[i], glm::vec3(i == 0, i == 1, i == 2)});
  }
  // Above 0 inside. Cut a little inside of what is_drawable() asks, so that rounding does not lead out again.
  constexpr float place = 0.99f * farthest_place;
  const auto inside = [&](int plane, const ViewVertex& v) {
    switch (plane) {
      case 0: return v.w - 1.01f * near;
      case 1: return place * v.w - v.x;
      case 2: return place * v.w + v.x;
      case 3: return place * v.w - v.y;
      default: return place * v.w + v.y;
    }
  };
  std::vector<CutCorner> left;
  for (int plane = 0; plane < 5 && !polygon.empty(); ++plane) {
    left.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const CutCorner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const float of_a = inside(plane, a.at), of_b = inside(plane, b.at);
      if (of_a >= 0) left.push_back(a);
      if ((of_a >= 0) == (of_b >= 0)) continue;
      const CutCorner &in = of_a >= 0 ? a : b, &out = of_a >= 0 ? b : a;
      const float from = std::max(of_a, of_b), to = std::min(of_a, of_b);
      const float part = from / (from - to);
      const auto between = [part](float p, float q) { return p + part * (q - p); };
      left.push_back({{between(in.at.x, out.at.x), between(in.at.y, out.at.y), between(in.at.w, out.at.w)},
                      in.shares + part * (out.shares - in.shares)});
    }
    polygon.swap(left);
  }
}

/// As far as is_drawable() holds.
inline Corner corner_of(const ViewVertex& v) {
  return {static_cast<std::int32_t>(std::floor(v.x / v.w + 0.5f)),
          static_cast<std::int32_t>(std::floor(v.y / v.w + 0.5f)), 0};
}

}  // namespace foredraw
