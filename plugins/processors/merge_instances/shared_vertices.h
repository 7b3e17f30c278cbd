#pragma once
// The vertices of several draws in one buffer.

#include <foredraw/scene/scene.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace foredraw::processors::merge_instances {

struct SharedVertices {
  std::shared_ptr<const VertexStreams> vertices;
  std::vector<std::uint32_t> first;  ///< [draw] where its vertices begin
};

/// The streams of all draws (of their full levels, which have one layout) one behind the other; vertices that several
/// draws look into are there once. Throws std::length_error where there are more than 32 bits can number.
SharedVertices shared_vertices(const Scene& scene, std::span<const DrawId> draws);

}  // namespace foredraw::processors::merge_instances
