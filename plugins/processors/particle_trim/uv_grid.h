#pragma once
#include "particle_trim.h"

#include <glm/vec2.hpp>

namespace foredraw::processors::particle_trim {

/// The texture coordinates that a format can hold, as whole numbers of parts() of an image's side. Of floats those are
/// taken that are multiples of what numbers near 1 are multiples of, so that everything can be computed exactly.
class UvGrid {
 public:
  explicit UvGrid(UvFormat format) : format_(format) {}

  std::int64_t parts() const;
  /// The nearest one to a texture coordinate.
  std::int64_t nearest(double coordinate) const;
  /// The texture coordinate; exact for floats.
  double value(std::int64_t number) const { return static_cast<double>(number) / static_cast<double>(parts()); }
  /// How far the nearest one can be from a coordinate whose size is at most so much.
  double error(double size) const;
  /// Coordinates beyond the image's edges can be stored.
  bool reaches_out() const { return format_ != UvFormat::unorm16; }

 private:
  UvFormat format_;
};

}  // namespace foredraw::processors::particle_trim
