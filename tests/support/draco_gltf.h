#pragma once
// Files with KHR_draco_mesh_compression, made from plain ones by libdraco's encoder; and buffers decoded by libdraco
// alone, as a second opinion.

#include "support/gltf_builder.h"

#include <map>

namespace foredraw::testing {

struct DracoChoice {
  bool sequential = false;      ///< keeps the sequence of vertices and triangles; else the encoder's own (edgebreaker)
  int bits = 0;                 ///< floats are quantized to so many; 0: they stay as they are
  int speed = 5;                ///< 0 (slow, small) to 10; it decides how attributes are predicted
  bool plain_copy = false;      ///< accessors keep their bytes too
  bool counted_before = false;  ///< accessors keep the counts that they had, whatever was encoded
};

/// Every primitive of triangles is compressed, in a buffer view of its own; everything else is as it was.
GltfBuilder draco_compressed(const GltfBuilder& plain, const DracoChoice& choice = {});

/// What libdraco makes of a buffer. An empty one where it refuses it.
struct DracoDecoded {
  std::vector<std::uint32_t> indices;
  std::map<std::uint32_t, std::vector<std::byte>> attributes;  ///< by unique id
};
DracoDecoded decoded_by_draco(std::span<const std::byte> buffer);

/// The bytes of a view of the builder's one buffer.
std::span<const std::byte> view_bytes(const GltfBuilder& builder, std::size_t view);

}  // namespace foredraw::testing
