#pragma once
// What vertices have between the corners of a triangle.

#include <foredraw/displaced/tessellated_mesh.h>
#include <foredraw/scene/vertex_streams.h>

namespace foredraw {

/// The vertices themselves, byte for byte, and after them those of the samples, which lie on triangles of `indices`:
/// the streams of a tessellated_mesh(). In the formats that there are:
/// - Floats are (u a + v b) + w c, each step rounded to float, as a shader computes them that declares its sum
/// `precise`
///   and does not fuse: bit by bit the same. A corner of weight 0 is not asked, so that an infinity there does no harm.
/// - Whole and normalized numbers are rounded from the exact sum to the nearest one, halves away from 0.
/// - NORMAL and TANGENT get a length of 1 where they point somewhere; else they are the heaviest corner's. A tangent's
///   fourth component is the heaviest corner's. In morph targets they are differences, and treated like other numbers.
/// - JOINTS_n and WEIGHTS_n: the largest influences, as many as there are places, with a sum of 1; of equal weights the
///   smaller joints. No weights at all stay none.
/// - What is no is_amount() is the heaviest corner's. So is a float that comes out infinite or as NaN.
/// The heaviest corner is the one with the largest weight; of several, the vertex of the smallest number.
///
/// On an edge the result does not depend on which end comes first, nor on the third corner. So streams that are equal
/// at both ends of an edge are equal along it, also between vertices that only lie at the same position: but for what
/// is the heaviest corner's in the very middle.
VertexStreams interpolated(const VertexStreams& vertices, std::span<const std::uint32_t> indices,
                           std::span<const SurfaceSample> samples);

}  // namespace foredraw
