#include <foredraw/technique/cache_orderer.h>

#include <fmt/format.h>

namespace foredraw {

IndexOrder CacheOrderer::order(const DrawView& draw, Run& run) {
  const CacheCount before = count(draw.indices(), draw.vertex_count());
  if (before.misses == before.referenced) {
    run.keep("each of its vertices is shaded once, and no order does with less");
    return {};
  }
  IndexOrder order = order_for_cache(draw, run);
  const CacheCount after = count(with_triangle_order(draw.stream(), order).indices.view(), draw.vertex_count());
  if (after.misses >= before.misses) {
    run.keep(fmt::format("in the order found {} vertices would miss the cache, and in its own {} do", after.misses,
                         before.misses));
  }
  return order;
}

}  // namespace foredraw
