#include "lookahead.h"

#include <foredraw/measuring/cache_orderer.h>
#include <foredraw/technique/plugin.h>

namespace foredraw {

namespace {

class LookaheadOrderer final : public CacheOrderer {
 public:
  explicit LookaheadOrderer(LookaheadOptions options) : options_(options), cache_(cache_of(options)) {}

  int cache_size() const override { return static_cast<int>(cache_.cache_size); }

 private:
  IndexOrder order_for_cache(const DrawView& draw, const Run& run) const override {
    LookaheadOptions options = options_;
    options.cancel = run.cancel;
    return lookahead(draw.indices(), draw.vertex_count(), options);
  }
  CacheCount count(std::span<const std::uint32_t> indices, std::size_t vertex_count) const override {
    return count_batches(indices, vertex_count, cache_);
  }

  LookaheadOptions options_;
  BatchModel cache_;
};

}  // namespace

Plugin lookahead_plugin() {
  Plugin plugin;
  plugin.kind = Kind::orderer;
  plugin.card = {
      .name = "lookahead",
      .summary =
          "Orders triangles for the vertex cache by trying several continuations; slower than tipsify, with fewer "
          "misses",
      .reference = "own; fans as in Sander, Nehab, Barczak 2007, tipsy strips",
      .acts_on = {traits::triangles},
      .provides = {traits::cache_ordered},
      .breaks = {traits::overdraw_ordered, traits::fetch_ordered, traits::clustered},
      .pays_if = "fewer vertices miss the cache than in the current order",
  };
  OptionTable<LookaheadOptions> table;
  table.choice(
      &LookaheadOptions::quality, "quality",
      "How much is tried: high gives the fewest misses, fast takes the least time. Sets `candidates` and `depth`",
      {{"fast", LookaheadQuality::fast}, {"balanced", LookaheadQuality::balanced}, {"high", LookaheadQuality::high}});
  table.row(&LookaheadOptions::candidates, "candidates",
            "How many centres of the next fan of triangles are tried; more take longer. 0: set by `quality`",
            {0, 64, "fans"});
  table.row(&LookaheadOptions::depth, "depth",
            "How many further fans are tried after each candidate; more take longer. 0: set by `quality`",
            {0, 64, "fans"});
  table.choice(&LookaheadOptions::target, "target",
               "Cache to order for. robust: a FIFO of `cache-size`, but good for other caches too; fifo: that FIFO "
               "only; nvidia, amd, intel: the batch models of these names",
               {{"robust", LookaheadTarget::robust},
                {"fifo", LookaheadTarget::fifo},
                {"nvidia", LookaheadTarget::nvidia},
                {"amd", LookaheadTarget::amd},
                {"intel", LookaheadTarget::intel}});
  table.row(&LookaheadOptions::cache_size, "cache-size",
            "Size of the FIFO vertex cache to order for, with the targets robust and fifo", {3, 256, "entries"});
  bind_options(plugin, table,
               [](const LookaheadOptions& options) { return std::make_unique<LookaheadOrderer>(options); });
  return plugin;
}

}  // namespace foredraw
