#pragma once
// The wires of a draw on their way into the picture.

#include <foredraw/frames/reference_renderer.h>
#include <foredraw/runtime/wire_radius.h>

#include <glm/geometric.hpp>

#include <array>
#include <span>
#include <vector>

namespace foredraw {

/// What wire_radius.h asks of a vertex and of a fragment, for the vertices of one draw after another.
class WireVertices {
 public:
  /// A draw's vertices where they are to be drawn: `positions` themselves, where no wire is widened. `rows`: as
  /// foredraw_wire_view has them.
  std::span<const glm::vec3> moved(const FrameLevel& level, std::span<const glm::vec3> positions, FrameWires wires,
                                   int samples, const std::array<glm::vec4, 3>& rows) {
    level_ = &level;
    wires_ = wires;
    if (wires == FrameWires::as_they_are || level.wires.size() < positions.size()) {
      wires_ = FrameWires::as_they_are;
      return positions;
    }
    for (std::size_t r = 0; r < 3; ++r) {
      for (int c = 0; c < 4; ++c) view_.row[r][c] = rows[r][c];
    }
    moved_.resize(positions.size());
    radii_.resize(positions.size());
    drawn_.resize(positions.size());
    half_pixels_.resize(positions.size());
    for (std::size_t v = 0; v < positions.size(); ++v) {
      const foredraw_wire_vertex at =
          foredraw_wire_vertex_at(&view_, &positions[v].x, &level.wires[v].x, &level.wire_axes[v].x,
                                  wires == FrameWires::covering ? samples : 0);
      radii_[v] = at.radius;
      drawn_[v] = at.drawn;
      half_pixels_[v] = at.half_pixel;
      moved_[v] = glm::vec3(at.position[0], at.position[1], at.position[2]);
    }
    positions_ = positions;
    return moved_;
  }

  /// Of the draw that moved() was asked for last: all corners belong to a wire, and one at least may be widened.
  bool is_wire(const std::array<std::uint32_t, 3>& v) const {
    if (level_->wires.empty()) return false;
    const float a = level_->wires[v[0]].w, b = level_->wires[v[1]].w, c = level_->wires[v[2]].w;
    return a != 0 && b != 0 && c != 0 && (a > 0 || b > 0 || c > 0);
  }

  /// Whether a triangle of a tube shows its far side, which must not be blended behind the near one. Of what is flat
  /// there is one side alone. `is_back`: of the triangle in the picture.
  bool is_far_side(const std::array<std::uint32_t, 3>& v, bool is_back) const {
    const glm::vec3 a = positions_[v[0]], normal = glm::cross(positions_[v[1]] - a, positions_[v[2]] - a);
    const glm::vec3 inwards(level_->wires[v[0]] + level_->wires[v[1]] + level_->wires[v[2]]);
    const float along = glm::dot(normal, inwards), all = glm::length(normal) * glm::length(inwards);
    if (!(std::abs(along) > 0.3f * all)) return false;
    return (along < 0) == is_back;
  }

  /// Of a fragment of a round wire: how much of the light in its own place is shown; 1 of anything else.
  float lit(const std::array<std::uint32_t, 3>& v, const glm::vec3& parts) const {
    if (wires_ == FrameWires::as_they_are || level_->wire_axes[v[0]].w > 0.5f) return 1;
    float radius = 0, half_pixel = 0;
    for (int i = 0; i < 3; ++i) {
      radius += parts[i] * radii_[v[static_cast<std::size_t>(i)]];
      half_pixel += parts[i] * half_pixels_[v[static_cast<std::size_t>(i)]];
    }
    return foredraw_wire_lit(radius, half_pixel);
  }

  /// In the mesh's space.
  glm::vec3 axis(const std::array<std::uint32_t, 3>& v, const glm::vec3& parts) const {
    glm::vec3 sum(0);
    for (int i = 0; i < 3; ++i) sum += parts[i] * glm::vec3(level_->wire_axes[v[static_cast<std::size_t>(i)]]);
    return sum;
  }

  /// Of a fragment. `parts`: of the triangle's corners in it; `x`, `y`: the pixel's middle, as the rows count.
  float alpha(const std::array<std::uint32_t, 3>& v, const glm::vec3& parts, float x, float y) const {
    if (wires_ == FrameWires::as_they_are) return 1;
    float radius = 0, drawn = 0;
    glm::vec3 centre(0);
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t corner = v[static_cast<std::size_t>(i)];
      radius += parts[i] * radii_[corner];
      drawn += parts[i] * drawn_[corner];
      centre += parts[i] * (positions_[corner] + glm::vec3(level_->wires[corner]));
    }
    if (wires_ == FrameWires::widened) return foredraw_wire_fade(radius, drawn);
    const glm::vec3 along = axis(v, parts);
    const foredraw_wire_section at = foredraw_wire_section_at(&view_, &centre.x, &along.x);
    return foredraw_wire_coverage(&at, radius, x, y);
  }

 private:
  const FrameLevel* level_ = nullptr;
  FrameWires wires_ = FrameWires::as_they_are;
  foredraw_wire_view view_{};
  std::span<const glm::vec3> positions_;
  std::vector<glm::vec3> moved_;
  std::vector<float> radii_, drawn_, half_pixels_;
};

}  // namespace foredraw
