#include "traced_parts.h"

#include "row_spans.h"
#include "sample_pattern.h"

#include <foredraw/viewing/camera.h>
#include <foredraw/viewing/mask.h>

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

namespace foredraw {

namespace {

/// Corners are snapped to 1/256 pixel in a picture with so many more pixels along each edge: to a step of the samples.
/// At 4096 pixels the picture ends at 2^30, and sums of products below 2^63.
constexpr int fineness = SamplePattern::steps / subpixels;

/// Boxes are wider than their triangles by this, in radii, so that the tree finds whatever may be hit: more than floats
/// lose (2^-19) and snapping moves a corner by (2^-18, seen from 1.01 radii in a picture of 16 pixels) together.
constexpr double margin = 0x1p-16;

TracedParts::Surface joined(const std::vector<PreparedPart>& parts) {
  TracedParts::Surface surface;
  for (const PreparedPart& part : parts) {
    const auto first = static_cast<std::uint32_t>(surface.positions.size());
    const auto number = static_cast<std::uint32_t>(surface.culls_back_faces.size());
    for (std::size_t t = 0; t < part.triangle_count(); ++t) {
      const std::array<std::uint32_t, 3> corners = {part.corners[0][t], part.corners[1][t], part.corners[2][t]};
      if (corners[0] == corners[1]) continue;  // padding
      surface.triangles.push_back({{corners[0] + first, corners[1] + first, corners[2] + first}, number});
    }
    for (std::size_t v = 0; v < part.vertex_count(); ++v) surface.positions.push_back(part.position(v));
    surface.culls_back_faces.push_back(part.culls_back_faces);
    surface.masks.push_back(part.mask);
    surface.first_vertex.push_back(first);
  }
  return surface;
}

std::vector<Box<glm::vec3>> boxes_around(const TracedParts::Surface& surface) {
  std::vector<Box<glm::vec3>> boxes;
  boxes.reserve(surface.triangles.size());
  for (const TracedParts::Triangle& triangle : surface.triangles) {
    const glm::dvec3& a = surface.positions[triangle.corners[0]];
    const glm::dvec3& b = surface.positions[triangle.corners[1]];
    const glm::dvec3& c = surface.positions[triangle.corners[2]];
    boxes.push_back({glm::vec3(glm::min(glm::min(a, b), c) - margin), glm::vec3(glm::max(glm::max(a, b), c) + margin)});
  }
  return boxes;
}

/// Whether the point at which p, q and it have this doubled area is to the left of the line from p to q. On the line,
/// nudged to the right by an infinitely small step, and down by one smaller still, it is on one side: of two triangles
/// that share an edge it is in one, and of those around a vertex too.
bool is_left(const Corner& p, const Corner& q, std::int64_t area) {
  if (area != 0) return area > 0;
  return p.y != q.y ? p.y > q.y : p.x > q.x;
}

struct Hit {
  std::uint32_t triangle;
  std::uint32_t depth;
  bool is_there;
};

/// One view: where the corners lie in it, and what a ray hits there.
class TracedView {
 public:
  TracedView(const TracedParts::Surface& surface, const View& view, int size)
      : surface_(surface), camera_(view, size * fineness) {
    corners_.reserve(surface.positions.size());
    for (const glm::dvec3& position : surface.positions) corners_.push_back(camera_.project(position));
  }

  RowSpans worth_a_ray(int size) const {
    RowSpans spans(size);
    for (const auto& [corners, _] : surface_.triangles) {
      spans.add(corners_[corners[0]], corners_[corners[1]], corners_[corners[2]], SamplePattern::steps);
    }
    return spans;
  }

  Ray ray(const Corner& point) const {
    const LineOfSight line = camera_.line_of_sight(point.x, point.y);
    return {glm::vec3(line.from), glm::vec3(line.direction), static_cast<float>(LineOfSight::length)};
  }

  /// The depth at which the triangle is hit at that point of the picture, if it is.
  std::optional<std::uint32_t> depth(std::uint32_t triangle, const Corner& point) const {
    const auto& [corners, part] = surface_.triangles[triangle];
    const Corner& a = corners_[corners[0]];
    const Corner& b = corners_[corners[1]];
    const Corner& c = corners_[corners[2]];
    const std::int64_t of_a = doubled_area(b, c, point);
    const bool is_counter_clockwise = is_left(b, c, of_a);
    const std::int64_t of_b = doubled_area(c, a, point);
    if (is_left(c, a, of_b) != is_counter_clockwise) return std::nullopt;
    const std::int64_t of_c = doubled_area(a, b, point);
    if (is_left(a, b, of_c) != is_counter_clockwise) return std::nullopt;
    if (surface_.culls_back_faces[part] && !is_counter_clockwise) return std::nullopt;
    return depth_between({a.depth, b.depth, c.depth}, {of_a, of_b, of_c});
  }

  /// Whether the surface of a triangle that is hit there is there, or is a hole of its mask.
  bool is_there(std::uint32_t triangle, const Corner& point) const {
    const auto& [corners, part] = surface_.triangles[triangle];
    if (!surface_.masks[part]) return true;
    const std::uint32_t first = surface_.first_vertex[part];
    return MaskedTriangle(*surface_.masks[part], camera_, {corners[0] - first, corners[1] - first, corners[2] - first},
                          {corners_[corners[0]], corners_[corners[1]], corners_[corners[2]]})
        .is_there(point.x, point.y);
  }

 private:
  /// What runs evenly over the picture is depth, in perspective 1 / distance from the eye. Rounded to the nearest step,
  /// so that triangles that face the camera keep their corners' depth.
  std::uint32_t depth_between(const std::array<std::uint32_t, 3>& depths,
                              const std::array<std::int64_t, 3>& weights) const {
    const double before = camera_.is_perspective() ? camera_.steps_before_sphere() : 0;
    std::array<double, 3> shares;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto weight = static_cast<double>(std::abs(weights[i]));
      shares[i] = camera_.is_perspective() ? weight / (before + depths[i]) : weight * depths[i];
    }
    // Added up in the same sequence whichever corner comes first: a triangle drawn twice ties.
    std::sort(shares.begin(), shares.end());
    const double sum = shares[0] + shares[1] + shares[2];
    const auto area = static_cast<double>(std::abs(weights[0] + weights[1] + weights[2]));
    const double depth = camera_.is_perspective() ? area / sum - before : sum / area;
    return static_cast<std::uint32_t>(std::max(0.0, depth + 0.5));
  }

  const TracedParts::Surface& surface_;
  Camera camera_;
  std::vector<Corner> corners_;
};

/// Counts what a depth test lets pass of the hits along one ray, which are in draw order.
void draw(std::span<const Hit> hits, const TracedParts::Surface& surface, std::vector<OverdrawCount>& counts) {
  if (hits.empty()) return;
  std::uint32_t nearest = std::numeric_limits<std::uint32_t>::max();
  std::optional<std::uint32_t> shown;
  for (const auto& [triangle, depth, is_there] : hits) {
    const std::uint32_t part = surface.triangles[triangle].part;
    if (!is_there) {
      counts[part].discarded += depth < nearest ? 1 : 0;
    } else if (depth < nearest) {
      ++counts[part].shaded;
      nearest = depth;
      shown = part;
    } else if (depth == nearest) {
      ++counts[part].ties;
    }
  }
  if (shown) ++counts[*shown].visible;
}

}  // namespace

TracedParts::TracedParts(std::span<const RasterPart> parts)
    : surface_(joined(prepared(parts))), tree_(boxes_around(surface_)) {}

std::vector<OverdrawCount> TracedParts::count(const View& view, int size, const OverdrawEmbreeOptions& options) const {
  std::vector<OverdrawCount> counts(surface_.culls_back_faces.size());
  const TracedView traced(surface_, view, size);
  const RowSpans spans = traced.worth_a_ray(size);
  std::vector<Hit> hits;
  for (std::int32_t y = 0; y < size; ++y) {
    for (std::int32_t x = spans[y].begin; x < spans[y].end; ++x) {
      const SamplePattern pattern(options.seed, x, y, options.samples);
      for (int sample = 0; sample < options.samples; ++sample) {
        const auto [right, up] = pattern[sample];
        const Corner point = {x * SamplePattern::steps + right, y * SamplePattern::steps + up, 0};
        hits.clear();
        tree_.for_each_met(traced.ray(point), [&](std::uint32_t triangle) {
          const auto depth = traced.depth(triangle, point);
          if (depth) hits.push_back({triangle, *depth, traced.is_there(triangle, point)});
        });
        std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.triangle < b.triangle; });
        draw(hits, surface_, counts);
      }
    }
  }
  return counts;
}

}  // namespace foredraw
