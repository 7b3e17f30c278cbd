#pragma once
#include <foredraw/analysis/vertex_cache.h>
#include <foredraw/technique/orderer.h>

namespace foredraw {

/// An orderer for the vertex cache. The order that is there stays where none can be better by more than 2 per cent, and
/// where its own is not better: both are counted in the cache that it orders for.
class CacheOrderer : public DrawOrderer {
 public:
  IndexOrder order(const DrawView& draw, Run& run) const final;

 private:
  virtual IndexOrder order_for_cache(const DrawView& draw, const Run& run) const = 0;
  virtual CacheCount count(std::span<const std::uint32_t> indices, std::size_t vertex_count) const = 0;
};

}  // namespace foredraw
