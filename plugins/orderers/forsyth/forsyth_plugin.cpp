#include "forsyth.h"

#include <foredraw/measuring/cache_orderer.h>
#include <foredraw/technique/plugin.h>

namespace foredraw {

namespace {

class ForsythOrderer final : public CacheOrderer {
 public:
  explicit ForsythOrderer(ForsythOptions options) : options_(options) {}

  int cache_size() const override { return options_.cache_size; }

 private:
  IndexOrder order_for_cache(const DrawView& draw, const Run&) const override {
    return forsyth(draw.indices(), draw.vertex_count(), options_);
  }
  CacheCount count(std::span<const std::uint32_t> indices, std::size_t vertex_count) const override {
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
      .summary = "Orders triangles by vertex scores, for vertex caches of unknown size and kind; slower than tipsify",
      .reference = "Forsyth 2006, Linear-Speed Vertex Cache Optimisation",
      .acts_on = {traits::triangles},
      .provides = {traits::cache_ordered},
      .breaks = {traits::overdraw_ordered, traits::fetch_ordered, traits::clustered},
      .pays_if = "fewer vertices miss an LRU cache of cache-size entries than in the current order",
  };
  OptionTable<ForsythOptions> table;
  table.row(&ForsythOptions::cache_size, "cache-size", "Size of the modelled LRU vertex cache", {3, 64, "entries"});
  bind_options(plugin, table, [](const ForsythOptions& options) { return std::make_unique<ForsythOrderer>(options); });
  return plugin;
}

}  // namespace foredraw
