#pragma once
// What the GPU's caches make of a triangle order.

#include <foredraw/analysis/vertex_cache.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace foredraw {

struct VertexCacheOptions {
  int cache_size = 16;             ///< of the FIFO that acmr and atvr are of
  std::optional<int> vertex_size;  ///< bytes; absent: of all the base streams together
};

struct VertexCacheFigures {
  struct Model {
    std::string name;  ///< "fifo-16", "lru-16", "nvidia"
    CacheCount count;
  };
  CacheCount count;  ///< of the FIFO of `cache_size`
  FetchCount fetch;
  std::vector<Model> models;  ///< always the same ones, in the same sequence
};

/// Simulates every model on a triangle list whose indices are below `vertex_count`. `vertex_size` in bytes.
/// O(indices + vertices) for each model.
VertexCacheFigures vertex_cache(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                                std::size_t vertex_size, int cache_size = VertexCacheOptions().cache_size);

struct Plugin;
Plugin vertex_cache_plugin();

}  // namespace foredraw
