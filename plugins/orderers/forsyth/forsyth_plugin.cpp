#include "forsyth.h"

#include <foredraw/analysis/vertex_cache.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

namespace foredraw {

namespace {

class Forsyth final : public DrawOrderer {
 public:
  explicit Forsyth(ForsythOptions options) : options_(options) {}

  IndexOrder order(const DrawView& draw, Run& run) override {
    const CacheCount before = count(draw.indices(), draw.vertex_count());
    if (before.misses == before.referenced) {
      run.keep("each of its vertices is shaded once, and no order does with less");
      return {};
    }
    IndexOrder order = forsyth(draw.indices(), draw.vertex_count(), options_);
    const CacheCount after = count(with_triangle_order(draw.stream(), order).indices.view(), draw.vertex_count());
    if (after.misses >= before.misses) {
      run.keep(fmt::format("in forsyth's order {} vertices would miss the cache, and in its own {} do", after.misses,
                           before.misses));
    }
    return order;
  }

  int cache_size() const override { return options_.cache_size; }

 private:
  CacheCount count(std::span<const std::uint32_t> indices, std::size_t vertex_count) const {
    return count_lru(indices, vertex_count, static_cast<std::uint32_t>(options_.cache_size));
  }

  ForsythOptions options_;
};

}  // namespace

Plugin forsyth_plugin() {
  Plugin plugin;
  plugin.kind = Kind::orderer;
  plugin.card = {
      .name = "forsyth",
      .summary = "Orders triangles for vertex caches of any kind by scores, slower than tipsify",
      .reference = "Forsyth 2006, Linear-Speed Vertex Cache Optimisation",
      .acts_on = {traits::triangles},
      .provides = {traits::cache_ordered},
      .breaks = {traits::overdraw_ordered, traits::fetch_ordered, traits::clustered},
      .pays_if = "fewer vertices miss an LRU cache of that size than in the order there is",
  };
  OptionTable<ForsythOptions> table;
  table.row(&ForsythOptions::cache_size, "cache-size", "Size of the LRU vertex cache that is modelled",
            {3, 64, "entries"});
  bind_options(plugin, table, [](const ForsythOptions& options) { return std::make_unique<Forsyth>(options); });
  return plugin;
}

}  // namespace foredraw
