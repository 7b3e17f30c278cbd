#pragma once
#include "box_tree.h"
#include "overdraw_embree.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace foredraw {

/// Parts made ready once for rays from everywhere. Any number of threads may count at once.
class TracedParts {
 public:
  /// Reads the parts here and never again. O(triangles log triangles).
  explicit TracedParts(std::span<const RasterPart> parts);

  /// [part], in one view of `size` x `size` pixels, as overdraw_embree() counts.
  std::vector<OverdrawCount> count(const View& view, int size, const OverdrawEmbreeOptions& options) const;

  struct Triangle {
    std::array<std::uint32_t, 3> corners;  ///< front faces counter-clockwise
    std::uint32_t part;
  };
  struct Surface {
    std::vector<bool> culls_back_faces;              ///< [part]
    std::vector<std::shared_ptr<const Mask>> masks;  ///< [part]
    std::vector<std::uint32_t> first_vertex;         ///< [part]
    std::vector<glm::dvec3> positions;               ///< of all parts, in radii from the centre of the sphere
    std::vector<Triangle> triangles;                 ///< of all parts, in draw order
  };

 private:
  Surface surface_;
  EmbreeBoxTree tree_;  ///< around the triangles
};

}  // namespace foredraw
