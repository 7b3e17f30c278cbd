#include "contained.h"

#include <foredraw/analysis/closed_surfaces.h>
#include <foredraw/analysis/closest_points.h>
#include <foredraw/analysis/ray_tree.h>

#include <glm/common.hpp>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace foredraw::processors::hidden {

namespace {

/// One component, as it stands.
struct Lump {
  std::uint32_t component = 0;
  std::vector<glm::vec3> positions;  ///< three a triangle, which turn counter-clockwise
  std::vector<std::uint32_t> indices;
  std::vector<std::uint32_t> triangles;  ///< of the surface
  glm::vec3 low{std::numeric_limits<float>::infinity()}, high{-std::numeric_limits<float>::infinity()};
  bool is_hidden = true;  ///< all of it was asked for
  bool hides = true;      ///< it is closed and faces outwards
};

/// Those that are here with all of their triangles.
std::vector<Lump> bodies_in(const Sight& sight, const Connected& surface, const Flags& asked) {
  std::vector<std::size_t> missing(surface.components(), 0);
  for (const std::uint32_t component : surface.component()) ++missing[component];
  std::vector<Lump> bodies(surface.components());
  std::size_t number = 0;
  for (std::size_t p = 0; p < sight.parts.size(); ++p) {
    const RasterPart& part = sight.parts[p];
    for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3, ++number) {
      const std::uint32_t triangle = sight.triangles[number];
      Lump& body = bodies[surface.component()[triangle]];
      --missing[surface.component()[triangle]];
      body.component = surface.component()[triangle];
      body.triangles.push_back(triangle);
      body.is_hidden = body.is_hidden && asked[triangle] != 0;
      body.hides = body.hides && sight.hides[p] != 0;
      for (const std::size_t c : {0, part.is_mirrored ? 2 : 1, part.is_mirrored ? 1 : 2}) {
        const glm::vec3& at = part.positions[part.indices[i + c]];
        body.indices.push_back(static_cast<std::uint32_t>(body.positions.size()));
        body.positions.push_back(at);
        body.low = glm::min(body.low, at);
        body.high = glm::max(body.high, at);
      }
    }
  }
  std::erase_if(bodies, [&](const Lump& body) { return body.triangles.empty() || missing[body.component] != 0; });
  for (Lump& body : bodies) {
    if (!body.hides) continue;
    const std::vector<bool> is_closed = closed_outwards(body.positions, body.indices);
    body.hides = std::ranges::all_of(is_closed, [](bool is) { return is; });
  }
  return bodies;
}

/// A body that questions are asked about.
class Solid {
 public:
  explicit Solid(const Lump& body)
      : tree_(body.positions, body.indices, std::vector<Blocks>(body.triangles.size(), Blocks::both)),
        points_({body.positions, body.indices}) {
    const glm::dvec3 extent(body.high - body.low);
    clearance_ = 1e-5 * std::max({extent.x, extent.y, extent.z});
  }

  bool keeps_clear_of(const Lump& other) const {
    for (std::size_t i = 0; i < other.positions.size(); ++i) {
      const glm::dvec3 a(other.positions[i]), b(other.positions[i % 3 == 2 ? i - 2 : i + 1]);
      if (!(points_.distance(a) > clearance_)) return false;
      if (a == b) continue;
      const auto hit = tree_.first({a, b - a});
      if (hit && hit->way <= 1) return false;
    }
    return true;
  }

  /// How often it winds around the point, where several lines agree.
  std::optional<int> winding(const glm::dvec3& point) const {
    // Of no plain ratio, so that no line runs along what was built at right angles.
    const glm::dvec3 lines[] = {
        {0.5411961, 0.8191725, 0.3073}, {-0.7071, 0.2937, 0.6432}, {0.1234567, -0.9238, -0.4142}};
    std::optional<int> result;
    for (const glm::dvec3& line : lines) {
      int winds = 0;
      RayTree::Ray ray{point, line};
      for (auto hit = tree_.first(ray); hit; hit = tree_.first(ray)) {
        winds += hit->at_front ? -1 : 1;
        ray.nearest = hit->way;
      }
      if (result && *result != winds) return std::nullopt;
      result = winds;
    }
    return result;
  }

 private:
  RayTree tree_;
  ClosestPoints points_;
  double clearance_ = 0;
};

bool is_box_within(const Lump& inner, const Lump& outer) {
  return glm::all(glm::greaterThan(inner.low, outer.low)) && glm::all(glm::lessThan(inner.high, outer.high));
}

}  // namespace

Flags inside_closed(const Sight& sight, const Connected& surface, const Flags& asked) {
  Flags result(surface.component().size(), 0);
  const std::vector<Lump> bodies = bodies_in(sight, surface, asked);
  std::vector<bool> is_proved(bodies.size(), false);
  for (const Lump& outer : bodies) {
    if (!outer.hides) continue;
    std::optional<Solid> solid;  // made for those that may have something in them
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const Lump& inner = bodies[i];
      if (is_proved[i] || !inner.is_hidden || !is_box_within(inner, outer)) continue;
      if (!solid) solid.emplace(outer);
      if (solid->winding(glm::dvec3(inner.positions[0])) != 1) continue;
      if (!solid->keeps_clear_of(inner) || !Solid(inner).keeps_clear_of(outer)) continue;
      is_proved[i] = true;
      for (const std::uint32_t triangle : inner.triangles) result[triangle] = 1;
    }
  }
  return result;
}

}  // namespace foredraw::processors::hidden
