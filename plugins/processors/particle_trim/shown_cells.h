#pragma once
#include "footprint.h"

#include <glm/vec2.hpp>

namespace foredraw::processors::particle_trim {

/// Which half texels of an image show, in part or whole: what a polygon must not cover outside of its own frame. Beyond
/// the image's edges as its sampler goes on there.
class ShownCells {
 public:
  explicit ShownCells(const ShownImage& image);

  /// Whether something shows in the triangle outside of the frame, further inside than a sampler's step. In steps from
  /// the image's upper left corner.
  bool shows_outside(const Box& frame, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) const;

 private:
  void mark(std::int64_t row, std::int64_t from, std::int64_t to);
  void mark_level(const AlphaImage& level, std::uint16_t limit, int reach);
  bool any_within(const std::vector<glm::dvec2>& corners) const;
  bool any(std::int64_t row, std::int64_t from, std::int64_t to) const;
  bool any_beyond(const std::vector<bool>& edge, const std::vector<glm::dvec2>& corners) const;

  std::int64_t width_, height_;  ///< in half texels
  std::array<Wrap, 2> wrap_;
  std::size_t words_;  ///< of a row
  std::vector<std::uint64_t> bits_;
  std::vector<bool> left_, right_;  ///< the first and the last cell of each row
};

}  // namespace foredraw::processors::particle_trim
