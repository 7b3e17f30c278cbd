#include "tipsify.h"

#include <foredraw/technique/cache_orderer.h>
#include <foredraw/technique/plugin.h>

namespace foredraw {

namespace {

class Tipsify final : public CacheOrderer {
 public:
  explicit Tipsify(TipsifyOptions options) : options_(options) {}

  int cache_size() const override { return options_.cache_size; }

 private:
  IndexOrder order_for_cache(std::span<const std::uint32_t> indices, std::size_t vertex_count) const override {
    return tipsify(indices, vertex_count, options_);
  }
  CacheCount count(std::span<const std::uint32_t> indices, std::size_t vertex_count) const override {
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
