#pragma once
// What the GPU's caches make of a triangle order.

#include <foredraw/analysis/vertex_cache.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foredraw {

/// A vertex cache: FIFO, LRU, or a GPU that shades in batches.
struct CacheModel {
  enum class Kind { fifo, lru, batches };
  std::string name;
  Kind kind = Kind::fifo;
  std::uint32_t cache_size = 16;      ///< entries
  std::uint32_t warp_size = 0;        ///< of batches, see BatchModel
  std::uint32_t primitive_group = 0;  ///< of batches
};

/// The model of a name: "fifo-N" and "lru-N" for N entries, "batches-C-W-P" for a cache of C, warps of W vertices and
/// groups of P triangles (0: any number), and the vendors' "nvidia", "amd", "intel". Sizes are 1 to 65535.
std::optional<CacheModel> cache_model(std::string_view name);

CacheCount count(std::span<const std::uint32_t> indices, std::size_t vertex_count, const CacheModel& model);

struct VertexCacheOptions {
  int cache_size = 16;             ///< of the FIFO that acmr and atvr are of
  std::optional<int> vertex_size;  ///< bytes; absent: of all the base streams together
  std::string models = "fifo-12 fifo-16 fifo-20 fifo-24 fifo-32 lru-16 nvidia amd intel";  ///< names, spaces between
};

struct Plugin;
Plugin vertex_cache_plugin();

}  // namespace foredraw
