#include "stored_polygon.h"

#include "plane.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace foredraw::processors::particle_trim {

namespace {

__extension__ typedef __int128 Wide;  // parts times steps times texels, squared: 110 bits

/// Each edge moved outwards by a distance.
std::vector<glm::dvec2> grown(std::span<const glm::dvec2> corners, double distance) {
  std::vector<glm::dvec2> made;
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec2 before = glm::normalize(corners[i] - corners[(i + count - 1) % count]);
    const glm::dvec2 behind = glm::normalize(corners[(i + 1) % count] - corners[i]);
    const double turn = cross(before, behind);
    const glm::dvec2 out = glm::dvec2(before.y, -before.x) + glm::dvec2(behind.y, -behind.x);
    // Where the moved lines meet; where they hardly turn, the middle will do.
    const double half = glm::dot(out, out);
    made.push_back(corners[i] + out * (turn > 1e-9 && half > 1e-12 ? 2 * distance / half : 0.5 * distance));
  }
  return made;
}

}  // namespace

std::optional<StoredPolygon> StoredPolygon::round(std::span<const glm::dvec2> corners, const AlphaImage& image,
                                                  UvFormat format) {
  const UvGrid grid(format);
  const glm::dvec2 size = static_cast<double>(steps_per_texel) * glm::dvec2(image.width, image.height);
  // Without corners that all but coincide, whose edge has no direction.
  std::vector<glm::dvec2> distinct;
  for (const glm::dvec2& corner : corners) {
    if (distinct.empty() || glm::distance(corner, distinct.back()) > 1e-6) distinct.push_back(corner);
  }
  while (distinct.size() > 1 && glm::distance(distinct.front(), distinct.back()) <= 1e-6) distinct.pop_back();
  if (distinct.size() < 3) return std::nullopt;
  double most = 0;
  for (const glm::dvec2& corner : distinct) {
    most = std::max({most, std::abs(corner.x / size.x), std::abs(corner.y / size.y)});
  }
  // A corner is rounded by at most .71 of that.
  const double error = grid.error(most) * std::max(size.x, size.y);
  std::vector<Point> stored;
  for (const glm::dvec2& corner : grown(distinct, error)) {
    stored.push_back({grid.nearest(corner.x / size.x), grid.nearest(corner.y / size.y)});
  }
  stored = monotone_chain(std::move(stored));
  if (stored.size() < 3) return std::nullopt;
  return StoredPolygon(std::move(stored), image, grid);
}

bool StoredPolygon::holds(const Point& point) const {
  const std::int64_t across = width_ * steps_per_texel, down = height_ * steps_per_texel, parts = grid_.parts();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Point &a = corners_[i], &b = corners_[(i + 1) % corners_.size()];
    const Wide edge_x = (b.x - a.x) * across, edge_y = (b.y - a.y) * down;
    const Wide x = point.x * parts - a.x * across, y = point.y * parts - a.y * down;
    if (edge_x * y - edge_y * x < 0) return false;
  }
  return true;
}

double StoredPolygon::area() const {
  std::int64_t doubled = 0;
  for (std::size_t i = 1; i + 1 < corners_.size(); ++i) {
    doubled += processors::particle_trim::cross(corners_[i] - corners_[0], corners_[i + 1] - corners_[0]);
  }
  const double part = 1.0 / static_cast<double>(grid_.parts());
  return 0.5 * static_cast<double>(doubled) * part * static_cast<double>(width_) * part * static_cast<double>(height_);
}

std::vector<glm::dvec2> StoredPolygon::texture_coordinates() const {
  std::vector<glm::dvec2> made;
  for (const Point& corner : corners_) made.emplace_back(grid_.value(corner.x), grid_.value(corner.y));
  return made;
}

std::vector<glm::dvec2> StoredPolygon::places() const {
  std::vector<glm::dvec2> made = texture_coordinates();
  for (glm::dvec2& place : made) {
    place *= static_cast<double>(steps_per_texel) * glm::dvec2(width_, height_);
  }
  return made;
}

}  // namespace foredraw::processors::particle_trim
