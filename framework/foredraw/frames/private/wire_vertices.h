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
                                   const std::array<glm::vec4, 3>& rows) {
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
    for (std::size_t v = 0; v < positions.size(); ++v) {
      const glm::vec4& wire = level.wires[v];
      const foredraw_wire_section at = section(positions[v] + glm::vec3(wire), level.wire_axes[v]);
      const bool covers = wires == FrameWires::covering;
      radii_[v] = covers ? foredraw_wire_mean(&wire.x, wire.w) : std::abs(wire.w);
      drawn_[v] = covers ? foredraw_wire_covering(wire.w, radii_[v], &at)
                         : foredraw_wire_drawn(wire.w, foredraw_wire_half_pixel(&at));
      foredraw_wire_moved(&positions[v].x, &wire.x, wire.w, drawn_[v], &moved_[v].x);
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

  /// Of a fragment. `parts`: of the triangle's corners in it; `x`, `y`: the pixel's middle, as the rows count.
  float alpha(const std::array<std::uint32_t, 3>& v, const glm::vec3& parts, float x, float y) const {
    if (wires_ == FrameWires::as_they_are) return 1;
    float radius = 0, drawn = 0;
    glm::vec3 centre(0), axis(0);
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t corner = v[static_cast<std::size_t>(i)];
      radius += parts[i] * radii_[corner];
      drawn += parts[i] * drawn_[corner];
      centre += parts[i] * (positions_[corner] + glm::vec3(level_->wires[corner]));
      axis += parts[i] * level_->wire_axes[corner];
    }
    if (wires_ == FrameWires::widened) return foredraw_wire_fade(radius, drawn);
    const foredraw_wire_section at = section(centre, axis);
    return foredraw_wire_coverage(&at, radius, x, y);
  }

 private:
  foredraw_wire_section section(const glm::vec3& centre, const glm::vec3& axis) const {
    return foredraw_wire_section_at(&view_, &centre.x, &axis.x);
  }

  const FrameLevel* level_ = nullptr;
  FrameWires wires_ = FrameWires::as_they_are;
  foredraw_wire_view view_{};
  std::span<const glm::vec3> positions_;
  std::vector<glm::vec3> moved_;
  std::vector<float> radii_, drawn_;
};

}  // namespace foredraw
