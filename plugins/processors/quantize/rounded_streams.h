#pragma once
// One stream at a time, rounded.

#include <foredraw/scene/vertex_streams.h>

#include <atomic>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace foredraw {

/// A stream in place of another one, and how far its farthest element is off; or why there is none. Neither where
/// nothing is to do.
struct RoundedStream {
  std::optional<VertexStream> stream;
  double error = 0;
  std::string plain;
};

/// Floats as whole multiples of a power of two, all elements within `distance` as points.
RoundedStream on_lattice(const VertexStream& stream, double distance);

/// Floats as unit vectors that the octahedral filter gives, of 8 bits for each component where that will do, else
/// of 16. A fourth component, which is -1 or 1, stays. Directions of length 0 become +z.
RoundedStream as_directions(const VertexStream& stream, double degrees, const std::atomic<bool>* cancel = nullptr);

/// Floats, or 16 bits, from 0 to 1 as 8 bits for each component where that will do, else as 16; others on a lattice.
RoundedStream as_parts(const VertexStream& stream, double error);

/// Joints and weights of a skin, which go together: by their number in VertexStreams::base.
struct SkinStreams {
  std::vector<std::pair<std::size_t, VertexStream>> streams;
  double error = 0;
  std::string plain;
};

/// Weights as 8 bits each where that will do, else as 16: those of a vertex sum up to 1 to the last bit. Joints as 8
/// bits where their numbers allow.
SkinStreams as_few_weights(const VertexStreams& vertices, double error);

/// The distance between two unit vectors at an angle of so many degrees.
double chord_of(double degrees);

}  // namespace foredraw
