#pragma once
// What the rasteriser must draw, found without cleverness: every pixel asked of every triangle, in numbers of any size.

#include "support/covers_pixel.h"

#include <foredraw/viewing/camera.h>
#include <foredraw/viewing/raster_part.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace foredraw::testing {

using boost::multiprecision::cpp_int;
using boost::multiprecision::cpp_rational;

struct ExactFragment {
  std::size_t part;
  std::uint32_t triangle;  ///< counted through all parts
  int x, y;
  cpp_rational depth;  ///< where the triangle is, in steps
};

inline cpp_int rounded_down(const cpp_rational& value) {
  const cpp_int numerator = boost::multiprecision::numerator(value);
  const cpp_int denominator = boost::multiprecision::denominator(value);
  return numerator / denominator - (numerator < 0 && numerator % denominator != 0 ? 1 : 0);
}

/// Of three corners in the picture the one depth that is evenly spread between them, or in perspective its inverse,
/// counted from the eye.
inline cpp_rational exact_depth(const Camera& camera, const std::array<Corner, 3>& c, int x, int y) {
  const auto twice_area = [](cpp_int px, cpp_int py, cpp_int qx, cpp_int qy, cpp_int rx, cpp_int ry) -> cpp_int {
    return (qx - px) * (ry - py) - (qy - py) * (rx - px);
  };
  const cpp_int u = 256 * x + 128;
  const cpp_int v = 256 * y + 128;
  cpp_rational sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner& q = c[(i + 1) % 3];
    const Corner& r = c[(i + 2) % 3];
    const cpp_rational weight = cpp_rational(twice_area(q.x, q.y, r.x, r.y, u, v)) /
                                cpp_rational(twice_area(c[0].x, c[0].y, c[1].x, c[1].y, c[2].x, c[2].y));
    if (camera.is_perspective()) {
      sum += weight / (cpp_rational(camera.steps_before_sphere()) + c[i].depth);
    } else {
      sum += weight * c[i].depth;
    }
  }
  return camera.is_perspective() ? 1 / sum - cpp_rational(camera.steps_before_sphere()) : sum;
}

/// Triangle by triangle, in the order of drawing. Corners are snapped and their depths rounded as the camera does it.
inline std::vector<ExactFragment> exact_fragments(std::span<const RasterPart> parts, const View& view, int size) {
  std::vector<glm::dvec3> used;
  for (const RasterPart& part : parts) {
    for (const std::uint32_t index : part.indices) used.push_back(part.positions[index]);
  }
  if (used.empty()) return {};
  glm::dvec3 least(used[0]);
  glm::dvec3 most(used[0]);
  for (const glm::dvec3& p : used) {
    least = glm::min(least, p);
    most = glm::max(most, p);
  }
  const glm::dvec3 centre = (least + most) / 2.0;
  double radius = 0;
  for (const glm::dvec3& p : used) radius = std::max(radius, glm::length(p - centre));

  const Camera camera(view, size);
  std::vector<ExactFragment> fragments;
  std::uint32_t number = 0;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    for (std::size_t t = 0; t + 2 < parts[p].indices.size(); t += 3, ++number) {
      std::array<Corner, 3> c;
      for (std::size_t i = 0; i < 3; ++i) {
        c[i] = camera.project((glm::dvec3(parts[p].positions[parts[p].indices[t + i]]) - centre) / radius);
      }
      if (parts[p].is_mirrored) std::swap(c[1], c[2]);
      const std::int64_t area = doubled_area(c[0], c[1], c[2]);
      if (area == 0 || (area < 0 && parts[p].culls_back_faces)) continue;
      if (area < 0) std::swap(c[1], c[2]);
      for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
          if (!covers_pixel(c[0], c[1], c[2], x, y)) continue;
          fragments.push_back({p, number, x, y, exact_depth(camera, c, x, y)});
        }
      }
    }
  }
  return fragments;
}

}  // namespace foredraw::testing
