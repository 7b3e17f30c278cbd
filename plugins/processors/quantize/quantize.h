#pragma once
// Vertex attributes rounded to what takes few bytes in a compressed file, within an error that is asked for.
//
// Lengths are rounded to whole multiples of a power of two, counted from 0, and stay floats. So whatever is equal
// before is equal afterwards, in every draw with the same lattice, also where nodes place the draws apart by multiples
// of it. Directions are rounded to what the octahedral filter of meshopt compression gives, colours and weights to few
// bits.

#include <foredraw/scene/vertex_streams.h>

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace foredraw {

/// The most that each kind of attribute may be off afterwards; at 0 it stays as it is.
struct Tolerances {
  double position = 0;   ///< distance, in the draw's units; also of morph targets
  double direction = 0;  ///< degrees: of normals and tangents
  double uv = 0;         ///< distance, in widths of the texture
  double color = 0;      ///< of each component, 1 being full
  double weight = 0;     ///< of each skin weight, all of a vertex summing up to 1
};

/// The largest errors that there are, in the units of Tolerances. Measured over all vertices, so each is proved.
struct QuantizedErrors {
  double position = 0;
  double direction = 0;
  double uv = 0;
  double color = 0;
  double weight = 0;
};

struct Quantized {
  std::shared_ptr<const VertexStreams> vertices;  ///< as many, in the same sequence
  QuantizedErrors largest;
  std::vector<std::string> plain;  ///< streams that stay as they are although they were to change, each with the reason
};

/// For each component the exponent e of its lattice, whole multiples of 2^e, such that no point of space is farther
/// than `distance` (above 0) from the nearest one. All have the greatest that will do; then the first and the
/// third of three may have one more, else the second. The first and the third have the same, so that draws turned about
/// y by a right angle still meet.
std::vector<int> lattice_exponents(double distance, std::size_t components);

/// All streams that glTF knows, rounded. Streams of other names stay, and so do those that hold whole numbers already,
/// but for wide numbers of joints. Numbers of joints without weight become 0. O(vertices) for each bit that is tried.
/// Once `*cancel` is true, streams stay as they are.
Quantized quantize(const VertexStreams& vertices, const Tolerances& tolerances,
                   const std::atomic<bool>* cancel = nullptr);

struct Plugin;
Plugin quantize_plugin();

}  // namespace foredraw
