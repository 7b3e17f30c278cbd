#include "vertex_cache.h"

namespace foredraw {

VertexCacheFigures vertex_cache(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                                std::size_t vertex_size, int cache_size) {
  VertexCacheFigures figures;
  figures.count = count_fifo(indices, vertex_count, static_cast<std::uint32_t>(cache_size));
  figures.fetch = count_fetches(indices, vertex_count, vertex_size);
  for (const std::uint32_t size : {12, 16, 20, 24, 32}) {
    figures.models.push_back({"fifo-" + std::to_string(size), count_fifo(indices, vertex_count, size)});
  }
  figures.models.push_back({"lru-16", count_lru(indices, vertex_count, 16)});
  for (const BatchModel& model : batch_models) {
    figures.models.push_back({std::string(model.name), count_batches(indices, vertex_count, model)});
  }
  return figures;
}

}  // namespace foredraw
