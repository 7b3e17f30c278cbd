#pragma once
#include <foredraw/page/shown_subject.h>

#include <glm/mat4x4.hpp>

#include <optional>

namespace foredraw {

/// The wires of a part, which are its last triangles, as wire_radius.h needs them: in the space of the mesh.
struct ShownWires {
  static constexpr std::size_t row_floats = 11;

  std::uint32_t first = 0;             ///< so many of the triangles that are shown are no wire's
  std::vector<std::uint32_t> corners;  ///< three for each of the others, as they are drawn: numbers of rows
  std::vector<float> rows;             ///< position, _FOREDRAW_WIRE, _FOREDRAW_WIRE_AXIS
};

/// Nothing where the draw has no wires, where joints or morph targets move it, or where not all of it is shown.
std::optional<ShownWires> shown_wires(const Scene& scene, const ShownPart& part);

/// To where a page shows the part.
glm::mat4 shown_from_mesh(const ShownPart& part, const PosedNodes& nodes);

}  // namespace foredraw
