#pragma once
// What gltfpack makes of vertices by default: KHR_mesh_quantization, 20 bytes each.

#include <foredraw/scene/vertex_streams.h>

namespace foredraw::bench {

/// Largest errors, in the units of PackedBounds; 0 where there is no such stream.
struct PeerErrors {
  double position = 0, normal = 0, tangent = 0, uv = 0;
};

/// Positions as 14 bits of the largest extent, normals and tangents as 8 bits with a sign, texture coordinates as 12
/// bits of each axis: as gltfpack's documentation and its files have it. Rounded by meshoptimizer's own functions.
PeerErrors peer_errors(const VertexStreams& vertices);

}  // namespace foredraw::bench
