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
    IndexOrder order = tipsify(draw.indices(), draw.vertex_count(), options_);
    keep_if_no_better(draw, order, run);
    return order;
  }

  int cache_size() const override { return options_.cache_size; }

 private:
  /// Some files come in an order that a greedy walk can not beat.
  void keep_if_no_better(const DrawView& draw, const IndexOrder& order, Run& run) const {
    const std::uint64_t before = misses(draw.indices(), draw.vertex_count());
    const std::uint64_t after = misses(with_triangle_order(draw.stream(), order).indices.view(), draw.vertex_count());
    if (after < before) return;
    run.keep(fmt::format("tipsify's order would have {} vertex cache misses, and the one there is has {}", after, before));
  }

  std::uint64_t misses(std::span<const std::uint32_t> indices, std::size_t vertex_count) const {
    return count_fifo(indices, vertex_count, static_cast<std::uint32_t>(options_.cache_size)).misses;
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
      .reference = "Sander, Nehab, Barczak 2007, section 3",
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
