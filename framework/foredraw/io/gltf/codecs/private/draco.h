#pragma once
// Buffers of the Draco codec (bitstream 2.2) to plain arrays. Private to io.

#include <foredraw/scene/vertex_streams.h>

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace foredraw::gltf {

/// What a buffer should hold, as the accessors that it stands for say. Some exporters count before they encode, and the
/// encoder leaves out triangles without area and parts vertices: the counts are a measure of what may come out.
struct DracoClaim {
  struct Attribute {
    std::uint32_t id = 0;  ///< the buffer's unique id of it
    Format format;         ///< whether it is normalized does not matter here
    std::string semantic;  ///< glTF's word: "POSITION"
  };
  std::size_t points = 0;
  std::size_t triangles = 0;
  std::vector<Attribute> attributes;  ///< that are wanted; the buffer may have others

  /// Of everything that comes out, with indices of 32 bits.
  std::uint64_t bytes() const;
};

struct DracoMesh {
  std::size_t points = 0;
  std::vector<std::uint32_t> indices;              ///< three for each triangle, each below `points`
  std::vector<std::vector<std::byte>> attributes;  ///< as claimed: `points` elements each, without gaps
};

/// Draco rounds floats, and may so leave what glTF allows. Normals and tangents become of length 1, whatever length
/// they have but 0, as shaders make them. Colours are kept from 0 to 1, and weights to a sum of 1 over all their sets,
/// where they are as near as rounding brings them; what is farther away stays. `rounded`: of each attribute of the
/// claim, whether the encoder rounded it. The others are as they were before.
void undo_rounding(const DracoClaim& claim, const std::vector<bool>& rounded, DracoMesh& mesh);

/// Why a buffer is refused.
struct DracoFault {
  std::string code;
  std::string message;
};

/// Decodes a buffer. Before memory is asked for, what the buffer says of itself is held against the claim: decoding
/// takes at most 16 times the claimed bytes, and 64 KiB. So whoever bounds the claim bounds memory and time. Throws
/// std::bad_alloc, and nothing else.
std::variant<DracoMesh, DracoFault> draco_decoded(std::span<const std::byte> buffer, const DracoClaim& claim);

}  // namespace foredraw::gltf
