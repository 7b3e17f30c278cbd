#include <foredraw/analysis/vertex_cache.h>

#include <algorithm>

namespace foredraw {

namespace {

std::uint64_t count_different(std::span<const std::uint32_t> indices, std::size_t vertex_count) {
  std::vector<char> seen(vertex_count, 0);
  for (const std::uint32_t vertex : indices) seen[vertex] = 1;
  return static_cast<std::uint64_t>(std::count(seen.begin(), seen.end(), 1));
}

/// A queue threaded through the vertices themselves, so that moving one to the front costs the same at any size.
class LruCache {
 public:
  LruCache(std::size_t vertex_count, std::uint32_t size)
      : links_(vertex_count + 1),
        holds_(vertex_count, 0),
        ends_(static_cast<std::uint32_t>(vertex_count)),
        left_(size) {
    links_[ends_] = {ends_, ends_};
  }

  bool misses(std::uint32_t vertex) {
    const bool missed = !holds_[vertex];
    if (!missed) {
      unlink(vertex);
    } else if (left_ > 0) {
      --left_;
    } else {
      const std::uint32_t oldest = links_[ends_].newer;
      unlink(oldest);
      holds_[oldest] = 0;
    }
    holds_[vertex] = 1;
    const std::uint32_t newest = links_[ends_].older;
    links_[vertex] = {newest, ends_};
    links_[newest].newer = vertex;
    links_[ends_].older = vertex;
    return missed;
  }

 private:
  struct Link {
    std::uint32_t older = 0;
    std::uint32_t newer = 0;
  };

  void unlink(std::uint32_t vertex) {
    links_[links_[vertex].older].newer = links_[vertex].newer;
    links_[links_[vertex].newer].older = links_[vertex].older;
  }

  std::vector<Link> links_;  ///< a ring; the last entry stands between the newest and the oldest
  std::vector<char> holds_;
  std::uint32_t ends_;
  std::uint32_t left_;  ///< entries never used yet
};

}  // namespace

CacheCount count_fifo(std::span<const std::uint32_t> indices, std::size_t vertex_count, std::uint32_t size) {
  FifoCache cache(vertex_count, size);
  return {cache.misses(indices), indices.size() / 3, count_different(indices, vertex_count)};
}

CacheCount count_lru(std::span<const std::uint32_t> indices, std::size_t vertex_count, std::uint32_t size) {
  CacheCount count{0, indices.size() / 3, count_different(indices, vertex_count)};
  LruCache cache(vertex_count, size);
  for (const std::uint32_t vertex : indices) count.misses += cache.misses(vertex);
  return count;
}

CacheCount count_batches(std::span<const std::uint32_t> indices, std::size_t vertex_count, const BatchModel& model) {
  return {batch_misses(indices, vertex_count, model), indices.size() / 3, count_different(indices, vertex_count)};
}

FetchCount count_fetches(std::span<const std::uint32_t> indices, std::size_t vertex_count, std::size_t vertex_size) {
  constexpr std::size_t line_bytes = 64;
  constexpr std::size_t cache_bytes = 128 * 1024;
  std::vector<std::size_t> held(cache_bytes / line_bytes, ~std::size_t{0});  // by slot: the line of memory in it

  FetchCount count{0, count_different(indices, vertex_count) * vertex_size};
  for (const std::uint32_t vertex : indices) {
    const std::size_t first = vertex * vertex_size / line_bytes;
    const std::size_t end = (vertex * vertex_size + vertex_size + line_bytes - 1) / line_bytes;
    for (std::size_t line = first; line < end; ++line) {
      std::size_t& slot = held[line % held.size()];
      if (slot == line) continue;
      slot = line;
      count.fetched += line_bytes;
    }
  }
  return count;
}

}  // namespace foredraw
