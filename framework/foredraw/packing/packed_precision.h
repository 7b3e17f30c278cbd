#pragma once
// What a layout of packed vertices promises, and what its rows keep.

#include <foredraw/base/parallel.h>
#include <foredraw/packing/packed_vertices.h>
#include <foredraw/scene/scene.h>

#include <span>

namespace foredraw {

/// Largest errors. Position as a distance, in the draw's units; normal and tangent as angles in degrees; u and v each
/// by itself, in units of TEXCOORD_0. What the layout does not have is 0.
struct PackedBounds {
  double position = 0, normal = 0, tangent = 0, u = 0, v = 0;

  double uv() const { return u > v ? u : v; }
};

/// What no vertex within the layout's lattices exceeds.
///   position  half the diagonal of a cell, sqrt(3) / 2 steps: floats hold the lattice, so nothing is added to that.
///   u, v      half a step, and what floats round.
///   normal    octahedral: 2 sqrt(2) / (2^bits - 2). The lattice cuts a face of the octahedron |x| + |y| + |z| = 1 into
///             equilateral triangles with sides of s = 2 sqrt(2) / (2^bits - 2), and each cell of the square is two of
///             them, folded or not. So three of the four corners that are tried lie around the normal's point of the
///             face, the nearest one within s / sqrt(3), the radius of their circle. The face is no nearer to the
///             middle than 1 / sqrt(3), so seen from there a way of length d along it is no wider than sqrt(3) d: the
///             angle is s at most. The middle cell of a face comes as near to that as it gets.
///             spherical: half a step of each angle, together.
///   tangent   `skew`, how far the tangent itself is from a right angle to its normal (degrees), and the normal's
///   bound,
///             both out of the plane; in the plane at most 4 / 2^bits, for a diamond's angle is no slower than half the
///             angle. At right angles to each other, they are sqrt(a^2 + b^2) together at most.
/// Where floats come near to a corner of a cell, they may take the cell beside it: that is in it too.
PackedBounds packed_bounds(const PackedLayout& layout, double skew = 0);

/// How many widths of the texture 1 of the draw's TEXCOORD_0 is at most, along u or v.
double packed_uv_widths(const Scene& scene, DrawId draw);

/// How far rows are from the streams that they stand for.
struct PackedErrors {
  PackedBounds most;               ///< over all vertices
  double skew = 0;                 ///< degrees: largest one of the tangents
  std::uint64_t handedness = 0;    ///< tangents whose sign is another
  std::uint64_t not_finite = 0;    ///< vertices with a position or texture coordinate that is no number
  std::uint64_t no_direction = 0;  ///< vertices with a normal or tangent of no direction, which count for no error
};

/// Of POSITION, NORMAL, TANGENT and TEXCOORD_0, as far as both have them. In doubles, whatever the rows were made with.
/// `rows`: four words a vertex.
PackedErrors packed_errors(const VertexStreams& vertices, const PackedLayout& layout,
                           std::span<const std::uint32_t> rows);

/// As the rest of a sentence; empty: the rows are as many as the vertices, and keep what the layout promises.
std::string broken_promise(const VertexStreams& vertices, const PackedLayout& layout,
                           std::span<const std::uint32_t> rows);

}  // namespace foredraw
