#pragma once
// What one scene, the input or what a pipeline made of it, draws of a subject, as a page shows it.

#include <foredraw/page/shown_triangles.h>

#include <foredraw/scene/subject.h>
#include <foredraw/viewing/animation.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace foredraw {

/// How many triangles of a subject are shown: what a small machine's browser turns smoothly.
inline constexpr std::size_t most_shown_triangles = 200'000;

/// The triangles that are shown, in the sequence in which one of the draw's orders draws them.
struct ShownOrder {
  std::vector<std::uint32_t> triangles;  ///< their numbers among those of the part
  std::vector<std::uint32_t> drawn;      ///< their numbers in the draw's order, rising
  std::vector<std::uint32_t> clusters;   ///< where each begins, and the end of the last; empty: there are none
};

/// A draw, by numbers that no order of it changes (file_numbering.h): two scenes that draw the same triangles have the
/// same indices, and the same positions.
struct ShownPart {
  SubjectPart part;
  std::vector<std::uint32_t> indices;   ///< three a triangle, into `vertices`
  std::vector<std::uint32_t> vertices;  ///< their numbers in the draw
  std::vector<ShownOrder> orders;       ///< as many as the draw's

  std::size_t triangles() const { return indices.size() / 3; }
  /// Of the vertices that are shown.
  std::vector<glm::vec3> positions(const Scene& scene, const PosedNodes& nodes) const;
};

struct ShownSubject {
  std::vector<ShownPart> parts;  ///< as they are drawn; what is not drawn where overdraw is measured is left out
  std::string note;              ///< what is not shown of it; empty: nothing is left out
};

/// Of large subjects, so many triangles that a browser can turn them. `once`: shared by the scenes of a subject.
ShownSubject shown_subject(const Scene& scene, const Subject& subject, ShownTrianglesOnce& once);

}  // namespace foredraw
