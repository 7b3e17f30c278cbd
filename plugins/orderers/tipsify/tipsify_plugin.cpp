#include "tipsify.h"

#include <foredraw/analysis/vertex_cache.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

namespace foredraw {

namespace {

class Tipsify final : public DrawOrderer {
 public:
  explicit Tipsify(TipsifyOptions options) : options_(options) {}

  IndexOrder order(const DrawView& draw, Run& run) override {
    const CacheCount before = count(draw.indices(), draw.vertex_count());
    if (before.misses == before.referenced) {
      run.keep("each of its vertices is shaded once, and no order does with less");
      return {};
    }
    IndexOrder order = tipsify(draw.indices(), draw.vertex_count(), options_);
    const CacheCount after = count(with_triangle_order(draw.stream(), order).indices.view(), draw.vertex_count());
    if (after.misses >= before.misses) {
      run.keep(fmt::format("in tipsify's order {} vertices would miss the cache, and in its own {} do", after.misses,
                           before.misses));
    }
    return order;
  }

  int cache_size() const override { return options_.cache_size; }

 private:
  CacheCount count(std::span<const std::uint32_t> indices, std::size_t vertex_count) const {
    return count_fifo(indices, vertex_count, static_cast<std::uint32_t>(options_.cache_size));
  }

  TipsifyOptions options_;
};

}  // namespace

Plugin tipsify_plugin() {
  Plugin plugin;
  plugin.kind = Kind::orderer;
  plugin.card = {
      .name = "tipsify",
      .summary = "Orders triangles for the vertex cache in linear time",
      .reference = "Sander, Nehab, Barczak 2007, tipsy strips",
      .acts_on = {traits::triangles},
      .provides = {traits::cache_ordered},
      .breaks = {traits::overdraw_ordered, traits::fetch_ordered, traits::clustered},
      .pays_if = "fewer vertices miss the cache than in the order there is",
  };
  OptionTable<TipsifyOptions> table;
  table.row(&TipsifyOptions::cache_size, "cache-size", "Size of the FIFO vertex cache to order for",
            {3, 1024, "entries"});
  bind_options(plugin, table, [](const TipsifyOptions& options) { return std::make_unique<Tipsify>(options); });
  return plugin;
}

}  // namespace foredraw
