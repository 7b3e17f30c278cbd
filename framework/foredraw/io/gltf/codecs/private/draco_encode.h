#pragma once
// Plain arrays to buffers of the Draco codec (bitstream 2.2), without loss. Private to io.

#include <foredraw/io/gltf/codecs/private/draco.h>

#include <optional>

namespace foredraw::gltf {

/// Triangles as they are to be encoded. What it refers to must outlive it.
struct DracoInput {
  struct Attribute {
    std::string semantic;  ///< glTF's word: "POSITION"
    Format format;
    std::span<const std::byte> bytes;  ///< `points` elements, without gaps
  };
  std::size_t points = 0;
  std::span<const std::uint32_t> indices;  ///< three for each triangle, each below `points`
  std::vector<Attribute> attributes;       ///< one is POSITION
};

struct DracoCoded {
  std::vector<std::byte> bytes;
  DracoMesh decoded;  ///< what comes out, with the attributes that have an id, in their sequence
  std::vector<std::optional<std::uint32_t>> ids;  ///< [attribute]; none: Draco can not give it back, and it is left out
  bool keeps_order = true;                        ///< else triangles and vertices are others, which show the same
  std::size_t loose = 0;                          ///< attributes of floats on no lattice, which are not shorter
};

/// How floats are held so that they come back to the last bit: as numbers on a grid of steps of a power of two.
struct DracoGrid {
  int bits = 0;               ///< for the greatest number
  float step = 1;             ///< between numbers
  std::vector<float> origin;  ///< [component] the value of number 0
};

/// The coarsest grid that has all the values, `components` each; nothing where it takes more than 22 bits, beyond which
/// the codec's own arithmetic rounds, or where a value is no finite number, or is -0.
std::optional<DracoGrid> draco_grid(std::span<const float> values, std::size_t components);

/// The sequential method: triangles, their corners and vertices stay in their order. With `may_reorder` the edgebreaker
/// method, where that is shorter, everything comes back and no attribute is left out. The result is decoded and
/// compared; nothing is answered where positions or triangles do not come back.
std::optional<DracoCoded> draco_encoded(const DracoInput& input, bool may_reorder);

/// Whether the decoded mesh draws the same triangles with the same vertices, each with the same winding, in whichever
/// order and from whichever corner. Triangles of two equal positions draw nothing, and may be missing.
bool same_triangles(const DracoInput& input, const DracoMesh& decoded);

}  // namespace foredraw::gltf
