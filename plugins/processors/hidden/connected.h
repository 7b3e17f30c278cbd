#pragma once
// What hangs together on a surface: whole components, and rings around triangles.

#include "sight.h"

#include <span>

namespace foredraw::processors::hidden {

class Connected {
 public:
  /// Triangles are counted through the parts; vertices at the same position are one, whichever part has them.
  explicit Connected(std::span<const RasterPart> parts);

  /// Every triangle of a component of which one is flagged.
  Flags with_components(const Flags& flags) const;
  /// What shares a vertex with a flagged triangle, and so on `rings` times.
  Flags with_rings(Flags flags, int rings) const;

  /// Three a triangle, of vertices that are one where they lie at the same position.
  std::span<const std::uint32_t> corners() const { return corners_; }
  std::size_t vertices() const { return vertices_; }

  /// [triangle] the number of its component, below `components()`; they are numbered by their first triangle.
  std::span<const std::uint32_t> component() const { return component_; }
  std::size_t components() const { return components_; }

 private:
  std::vector<std::uint32_t> corners_;  ///< three a triangle, of welded vertices
  std::size_t vertices_ = 0;
  std::vector<std::uint32_t> component_;
  std::size_t components_ = 0;
};

}  // namespace foredraw::processors::hidden
