#pragma once
// Vertices that are equal in every bit made one.

#include <foredraw/scene/vertex_streams.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

struct WeldOptions {
  bool keep_unused = false;  ///< keep vertices that no triangle uses
};

struct Weld {
  std::vector<std::uint32_t> destination;  ///< [old] = new vertex, or no_vertex where it is left out
  std::uint32_t count = 0;                 ///< vertices afterwards
  std::uint32_t merged = 0;                ///< vertices that were equal to an earlier one
  std::uint32_t unused = 0;                ///< vertices that were left out, as no index names them
};

/// Where each vertex goes when those equal in every bit of every base stream and morph target become one. The first of
/// equals stays, in the old sequence. O(vertices).
Weld weld(const VertexStreams& vertices, std::span<const std::span<const std::uint32_t>> index_streams,
          const WeldOptions& options = {});

struct Plugin;
Plugin weld_plugin();

}  // namespace foredraw
