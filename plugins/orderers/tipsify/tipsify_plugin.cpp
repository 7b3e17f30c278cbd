#include "tipsify.h"

#include <foredraw/measuring/cache_orderer.h>
#include <foredraw/technique/plugin.h>
#include <foredraw/viewing/posed_positions.h>

namespace foredraw {

namespace {

struct Options : TipsifyOptions {
  int parts = 1;
};

class TipsifyOrderer final : public CacheOrderer {
 public:
  explicit TipsifyOrderer(const Options& options) : options_(options) {}

  int cache_size() const override { return options_.cache_size; }

 private:
  IndexOrder order_for_cache(const DrawView& draw, const Run& run) const override {
    if (options_.parts > 1) {
      const auto positions = posed_positions(draw.scene, {draw.id, {}}, {});
      const auto for_each = [&](std::size_t count, const std::function<void(std::size_t)>& task) {
        run.executor.for_each(count, task);
      };
      if (!positions.empty()) {
        return tipsify_parts(draw.indices(), {&positions[0].x, 3 * positions.size()}, options_.parts, options_,
                             for_each);
      }
    }
    return tipsify(draw.indices(), draw.vertex_count(), options_);
  }
  CacheCount count(std::span<const std::uint32_t> indices, std::size_t vertex_count) const override {
    return count_fifo(indices, vertex_count, static_cast<std::uint32_t>(options_.cache_size));
  }

  Options options_;
};

}  // namespace

Plugin tipsify_plugin() {
  Plugin plugin;
  plugin.kind = Kind::orderer;
  plugin.card = {
      .name = "tipsify",
      .summary = "Orders triangles for the vertex cache in linear time; faster than lookahead, with more misses",
      .reference = "Sander, Nehab, Barczak 2007, tipsy strips",
      .acts_on = {traits::triangles},
      .provides = {traits::cache_ordered},
      .breaks = {traits::overdraw_ordered, traits::fetch_ordered, traits::clustered},
      .pays_if = "fewer vertices miss the cache than in the current order",
  };
  OptionTable<Options> table;
  table.row(&TipsifyOptions::cache_size, "cache-size", "Size of the FIFO vertex cache to order for",
            {3, 1024, "entries"});
  table.row(&TipsifyOptions::built_for, "built-for",
            "Size of the cache that fans are chosen for; by default cache-size. Two entries more than a cache-size of "
            "12 or 16 give fewer misses in that cache and more in a smaller one",
            {3, 1024, "entries"});
  table.row(&Options::parts, "parts",
            "How many spatial parts the draw is cut into, to be ordered in parallel; more are faster, with slightly "
            "more misses. No part gets fewer than 10000 triangles",
            {1, 64, "parts"});
  bind_options(plugin, table, [](const Options& options) { return std::make_unique<TipsifyOrderer>(options); });
  return plugin;
}

}  // namespace foredraw
