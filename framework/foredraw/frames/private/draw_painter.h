#pragma once
// From the triangles of a draw to samples of a frame.

#include <foredraw/frames/private/shaded_corners.h>
#include <foredraw/frames/private/wire_vertices.h>
#include <foredraw/frames/reference_renderer.h>
#include <foredraw/frames/screen_triangle.h>
#include <foredraw/frames/surface_shading.h>

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace foredraw {

/// Draws draws at a level, one after the other, into the samples of a frame: coverage, depth, and a colour for each
/// sample that is seen.
class DrawPainter {
 public:
  DrawPainter(FrameSamples& to, const FrameCamera& camera, const FrameDetail& detail)
      : to_(to), camera_(camera), detail_(detail) {
    const double scale = subpixels * to.size.height / (2 * camera.half_height);
    right_ = camera.right * scale;
    up_ = camera.up * scale;
    middle_ = glm::dvec2(to.size.width, to.size.height) * (subpixels / 2.0) - to.shift * double{subpixels};
  }

  /// What is drawn when, all objects after each other.
  enum class Turn : std::uint8_t {
    opaque,   ///< and masked
    faded,    ///< fragments of opaque draws' wires that are not opaque
    blended,  ///< draws
  };

  struct Task {
    const FrameLevel& level;
    const FrameSurface& surface;
    std::span<const glm::vec3> positions, normals;  ///< in the space that `world` is from
    glm::dmat4 world;
    bool is_mirrored;
    Rendering rendering;
    const glm::vec3* flat_colour;  ///< of the levels' style; else null
    Turn turn;
    bool is_posed;
    std::size_t first_triangles;  ///< only so many are drawn
  };

  void draw(const Task& task) {
    if (task.turn == Turn::faded && (task.is_posed || task.level.wires.empty())) return;
    task_ = &task;
    world_ = glm::mat4(task.world);
    const glm::dmat3 turn(task.world);
    is_mirrored_ = task.is_mirrored;
    const glm::dmat3 cofactors(glm::cross(turn[1], turn[2]), glm::cross(turn[2], turn[0]),
                               glm::cross(turn[0], turn[1]));
    of_normals_ = glm::mat3(glm::determinant(turn) < 0 ? -cofactors : cofactors);
    const std::size_t vertices = task.positions.size();
    move_vertices(vertices);
    DrawnWork& work = to_.work[static_cast<std::size_t>(task.rendering)];
    work_ = &work;
    ++work.draws;
    work.vertices += vertices;
    const auto indices = task.level.indices.first(std::min(task.level.indices.size() / 3, task.first_triangles) * 3);
    work.triangles += indices.size() / 3;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      draw_triangle({indices[i], indices[i + 1], indices[i + 2]});
    }
  }

 private:
  template <class T>
  static T blend(const std::array<T, 3>& of, const glm::vec3& shares) {
    return of[0] * shares[0] + of[1] * shares[1] + of[2] * shares[2];
  }

  void move_vertices(std::size_t count) {
    // One row for each of x, y and w, in doubles until they are one: the eye may be far from the origin.
    const glm::dmat4& world = task_->world;
    std::array<glm::vec4, 3> rows;
    const glm::dvec3 along[3] = {right_ + middle_.x * camera_.ahead, up_ + middle_.y * camera_.ahead, camera_.ahead};
    for (std::size_t r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) rows[r][c] = static_cast<float>(glm::dot(along[r], glm::dvec3(world[c])));
      rows[r][3] = static_cast<float>(glm::dot(along[r], glm::dvec3(world[3]) - camera_.eye));
    }
    moved_.resize(count);
    corners_.resize(count);
    inverse_.resize(count);
    const auto near = static_cast<float>(camera_.near);
    std::array<glm::vec4, 3> in_pixels = rows;
    for (std::size_t r = 0; r < 2; ++r) in_pixels[r] /= static_cast<float>(subpixels);
    const bool keeps_wires = task_->is_posed || task_->turn == Turn::blended;
    const std::span<const glm::vec3> positions =
        wires_.moved(task_->level, task_->positions, keeps_wires ? FrameWires::as_they_are : detail_.wires,
                     detail_.wire_samples, in_pixels);
    for (std::size_t v = 0; v < count; ++v) {
      const glm::vec3& p = positions[v];
      const auto by = [&p](const glm::vec4& row) { return row.x * p.x + row.y * p.y + row.z * p.z + row.w; };
      const ViewVertex at{by(rows[0]), by(rows[1]), by(rows[2])};
      moved_[v] = at;
      const bool can_be_drawn = is_drawable(at, near);
      inverse_[v] = can_be_drawn ? 1 / at.w : 0;  // 0: it has to be cut
      if (can_be_drawn) corners_[v] = corner_of(at);
    }
  }

  void draw_triangle(const std::array<std::uint32_t, 3>& v) {
    vertices_ = v;
    has_data_ = false;
    is_wire_ = wires_.is_wire(v);
    if (task_->turn == Turn::faded && !is_wire_) return;
    const std::array<float, 3> inverse = {inverse_[v[0]], inverse_[v[1]], inverse_[v[2]]};
    if (inverse[0] > 0 && inverse[1] > 0 && inverse[2] > 0) {
      cover({corners_[v[0]], corners_[v[1]], corners_[v[2]]}, inverse, nullptr);
      return;
    }
    if (inverse[0] == 0 && inverse[1] == 0 && inverse[2] == 0 && is_behind(v)) return;
    cut_to_drawable({moved_[v[0]], moved_[v[1]], moved_[v[2]]}, static_cast<float>(camera_.near), polygon_);
    for (std::size_t i = 2; i < polygon_.size(); ++i) {
      const CutCorner *a = &polygon_[0], *b = &polygon_[i - 1], *c = &polygon_[i];
      const std::array<glm::vec3, 3> shares = {a->shares, b->shares, c->shares};
      cover({corner_of(a->at), corner_of(b->at), corner_of(c->at)}, {1 / a->at.w, 1 / b->at.w, 1 / c->at.w}, &shares);
    }
  }

  bool is_behind(const std::array<std::uint32_t, 3>& v) const {
    const auto near = static_cast<float>(camera_.near);
    return moved_[v[0]].w < near && moved_[v[1]].w < near && moved_[v[2]].w < near;
  }

  /// `shares`: of the triangle's corners in these ones; null: they are the same.
  void cover(std::array<Corner, 3> corners, std::array<float, 3> inverse, const std::array<glm::vec3, 3>* shares) {
    PixelBox box(corners[0], corners[1], corners[2]);
    box.first_x = std::max(box.first_x, 0);
    box.first_y = std::max(box.first_y, 0);
    box.last_x = std::min(box.last_x, to_.size.width - 1);
    box.last_y = std::min(box.last_y, to_.size.height - 1);
    if (box.is_empty()) return;
    std::int64_t area = doubled_area(corners[0], corners[1], corners[2]);
    const bool is_clockwise = area < 0;
    if (area == 0) return;
    const bool is_back = is_clockwise != is_mirrored_;
    const bool is_shown = detail_.backs_of == nullptr ? !is_back || task_->surface.is_double_sided : is_back;
    if (!is_shown) return;
    area_ = static_cast<double>(std::abs(area)) / (subpixels * subpixels);
    is_back_ = is_back;
    if (task_->turn == Turn::faded && wires_.is_far_side(vertices_, is_back)) return;
    std::array<std::size_t, 3> from = {0, 1, 2};
    if (is_clockwise) {
      std::swap(corners[1], corners[2]);
      std::swap(from[1], from[2]);
      area = -area;
    }
    const float scale = 1 / static_cast<float>(area);
    const std::array<float, 3> scaled = {inverse[from[0]] * scale, inverse[from[1]] * scale, inverse[from[2]] * scale};
    const std::array<EdgeFunction, 3> edges = edges_of(corners[0], corners[1], corners[2]);
    const auto visit = [&](std::int32_t x, std::int32_t y, const std::array<std::int64_t, 3>& weights) {
      float a = static_cast<float>(weights[0]) * scaled[0], b = static_cast<float>(weights[1]) * scaled[1],
            c = static_cast<float>(weights[2]) * scaled[2];
      const float nearness = a + b + c;
      const std::size_t sample =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(to_.size.width) + static_cast<std::size_t>(x);
      if (!(nearness > to_.nearness[sample])) return;
      float whole = nearness;
      if (detail_.shades_middles) {
        std::array<double, 3> middle{};
        for (std::size_t i = 0; i < 3; ++i) {
          middle[i] = static_cast<double>(weights[i]) - to_.shift.x * static_cast<double>(edges[i].per_column()) -
                      to_.shift.y * static_cast<double>(edges[i].per_row());
        }
        if (middle[0] >= 0 && middle[1] >= 0 && middle[2] >= 0) {
          a = static_cast<float>(middle[0]) * scaled[0];
          b = static_cast<float>(middle[1]) * scaled[1];
          c = static_cast<float>(middle[2]) * scaled[2];
          whole = a + b + c;
        }
      }
      glm::vec3 parts(0);
      parts[static_cast<int>(from[0])] = a / whole;
      parts[static_cast<int>(from[1])] = b / whole;
      parts[static_cast<int>(from[2])] = c / whole;
      if (shares != nullptr) parts = blend(*shares, parts);
      float alpha = 1;
      if (is_wire_) {
        alpha = wires_.alpha(vertices_, parts, static_cast<float>(x + 0.5 - to_.shift.x),
                             static_cast<float>(y + 0.5 - to_.shift.y));
        if ((alpha < 1) != (task_->turn == Turn::faded)) return;
      }
      shade(sample, nearness, parts, alpha);
    };
    const std::int32_t columns = box.last_x - box.first_x + 1, rows = box.last_y - box.first_y + 1;
    if (columns > 8 || rows > 8) {
      for_each_covered(corners[0], corners[1], corners[2], box, visit);
      return;
    }
    for (std::int32_t y = box.first_y; y <= box.last_y; ++y) {
      for (std::int32_t x = box.first_x; x <= box.last_x; ++x) {
        if (edges[0].contains(x, y) && edges[1].contains(x, y) && edges[2].contains(x, y)) {
          visit(x, y, {edges[0].at(x, y), edges[1].at(x, y), edges[2].at(x, y)});
        }
      }
    }
  }

  /// `alpha`: of a wire's fragment, 1 of any other.
  void shade(std::size_t sample, float nearness, const glm::vec3& parts, float alpha) {
    ++work_->samples;
    if (task_->flat_colour != nullptr && task_->surface.alpha_mode != AlphaMode::mask) {
      put(sample, nearness, *task_->flat_colour, alpha, task_->turn == Turn::faded);
      return;
    }
    if (!has_data_) {
      data_ = shaded_corners({task_->level, task_->surface, task_->positions, task_->normals}, vertices_,
                             {world_, of_normals_, camera_.eye, is_mirrored_, is_back_}, area_);
      has_data_ = true;
    }
    ShadedPoint& point = data_.point;
    point.base_place = blend(data_.base_places, parts);
    const glm::vec4 base = base_colour(task_->surface, point);
    if (task_->surface.alpha_mode == AlphaMode::mask && base.w < task_->surface.alpha_cutoff) return;
    glm::vec3 colour(base);
    if (task_->flat_colour != nullptr) {
      colour = *task_->flat_colour;
    } else {
      point.normal = blend(data_.normals, parts);
      point.to_eye = blend(data_.to_eye, parts);
      point.normal_map_place = blend(data_.normal_map_places, parts);
      const float lit = is_wire_ ? wires_.lit(vertices_, parts) : 1;
      const glm::vec3 whole = lit < 1 ? lit_all_over(parts, colour) : glm::vec3(0);
      colour = shaded(task_->surface, task_->rendering, point, colour) * lit + whole * (1 - lit);
    }
    if (task_->turn == Turn::blended) alpha = base.w;
    put(sample, nearness, colour, alpha, task_->turn != Turn::opaque);
  }

  /// The mean over the width of a round wire, of three places.
  glm::vec3 lit_all_over(const glm::vec3& parts, const glm::vec3& base) const {
    ShadedPoint point = data_.point;
    const glm::vec3 axis = glm::mat3(world_) * wires_.axis(vertices_, parts);
    glm::vec3 sum(0);
    for (const auto& [part, weight] : {std::pair{-0.7746f, 5.0f}, {0.0f, 8.0f}, {0.7746f, 5.0f}}) {
      foredraw_wire_normal(&axis.x, &point.to_eye.x, part, &point.normal.x);
      sum += shaded(task_->surface, task_->rendering, point, base) * (weight / 18);
    }
    return sum;
  }

  void put(std::size_t sample, float nearness, const glm::vec3& colour, float alpha, bool is_blended) {
    glm::vec3& to = to_.colours[sample];
    const float wire = is_wire_ ? 1.0f : 0.0f;
    if (is_blended) {
      to = to * (1 - alpha) + colour * alpha;
      if (detail_.marks_wires) to_.wires[sample] = to_.wires[sample] * (1 - alpha) + wire * alpha;
      return;
    }
    to = colour;
    to_.nearness[sample] = nearness;
    if (detail_.marks_wires) to_.wires[sample] = wire;
  }

  FrameSamples& to_;
  const FrameCamera& camera_;
  const FrameDetail& detail_;
  glm::dvec3 right_, up_;
  glm::dvec2 middle_;

  const Task* task_ = nullptr;
  DrawnWork* work_ = nullptr;
  glm::mat4 world_{1};
  glm::mat3 of_normals_{1};
  bool is_mirrored_ = false;
  std::vector<ViewVertex> moved_;
  std::vector<Corner> corners_;
  std::vector<float> inverse_;
  std::vector<CutCorner> polygon_;
  WireVertices wires_;

  std::array<std::uint32_t, 3> vertices_{};
  bool is_wire_ = false;
  bool is_back_ = false;
  double area_ = 1;  // twice the triangle's, in samples
  bool has_data_ = false;
  ShadedCorners data_;
};

}  // namespace foredraw
