#pragma once
// Fast linear clustering: a cache-friendly triangle order cut into patches that may be drawn in any sequence for little
// more vertex work. Sander, Nehab, Barczak 2007, "Linear clustering"; Han, Sander 2016, section 3.1.

#include <foredraw/scene/clusters.h>

#include <cstdint>
#include <optional>
#include <span>

namespace foredraw {

struct LinearClustersOptions {
  std::optional<double> lambda;  ///< misses per triangle at which a patch is closed, 0.5 to 3; stands above growth
  double growth = 1.05;          ///< instead: that many times the hard patch's own misses per triangle, at least 1
};

/// Cuts the order for a FIFO cache of `cache_size` entries. Hard boundaries lie where all three vertices of a triangle
/// miss. Within them each patch is simulated from an empty cache and closed as soon as its misses per triangle are down
/// to lambda; what is left over at the end of a hard patch stays with the patch before it, as it never got so far.
/// Every index must be below `vertex_count`. O(triangles).
Clusters linear_clusters(std::span<const std::uint32_t> indices, std::size_t vertex_count, int cache_size,
                         const LinearClustersOptions& options = {});

struct Plugin;
Plugin linear_clusters_plugin();

}  // namespace foredraw
