#include <foredraw/measuring/cache_orderer.h>

#include <foredraw/analysis/equal_vertices.h>
#include <foredraw/base/counted.h>

#include <fmt/format.h>

namespace foredraw {

namespace {

constexpr double near_best = 1.02;  ///< misses for each vertex, of which one is the least that there can be

/// True of any order, and yet a file whose equal vertices nobody merged has most to gain: so it is looked at here.
std::string why_no_order_helps(const DrawView& draw, Run& run) {
  const std::string why = "each of its vertices is shaded once, and no order shades fewer";
  const std::size_t equal = count_equal_vertices(draw.vertices(), draw.indices(), run.analyses);
  if (equal == 0) return why;
  return fmt::format("{}; but {} of them equal others: weld them first", why, counted(equal));
}

}  // namespace

IndexOrder CacheOrderer::order(const DrawView& draw, Run& run) const {
  const CacheCount before = count(draw.indices(), draw.vertex_count());
  if (before.misses == before.referenced) {
    run.keep(why_no_order_helps(draw, run));
    return {};
  }
  if (static_cast<double>(before.misses) <= near_best * static_cast<double>(before.referenced)) {
    run.keep(fmt::format("{} vertices miss the cache, and at best {} would: the gain is below {:.0f} per cent",
                         before.misses, before.referenced, 100 * (near_best - 1)));
    return {};
  }
  IndexOrder order = order_for_cache(draw, run);
  const CacheCount after = count(with_triangle_order(draw.stream(), order).indices.view(), draw.vertex_count());
  if (after.misses >= before.misses) {
    run.keep(
        fmt::format("in the new order {} vertices would miss the cache, in its own {}", after.misses, before.misses));
  }
  return order;
}

}  // namespace foredraw
