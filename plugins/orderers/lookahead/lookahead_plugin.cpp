#include "lookahead.h"

#include <foredraw/measuring/cache_orderer.h>
#include <foredraw/technique/plugin.h>

namespace foredraw {

namespace {

class Lookahead final : public CacheOrderer {
 public:
  explicit Lookahead(LookaheadOptions options) : options_(options), cache_(cache_of(options)) {}

  int cache_size() const override { return static_cast<int>(cache_.cache_size); }

 private:
  IndexOrder order_for_cache(const DrawView& draw, const Run&) const override {
    return lookahead(draw.indices(), draw.vertex_count(), options_);
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
      .summary = "Orders triangles for the vertex cache by trying out what might follow",
      .reference = "own; fans as in Sander, Nehab, Barczak 2007, tipsy strips",
      .acts_on = {traits::triangles},
      .provides = {traits::cache_ordered},
      .breaks = {traits::overdraw_ordered, traits::fetch_ordered, traits::clustered},
      .pays_if = "fewer vertices miss the cache than in the order there is",
  };
  OptionTable<LookaheadOptions> table;
  table.choice(
      &LookaheadOptions::quality, "quality", "How much is tried out, against time: sets `candidates` and `depth`",
      {{"fast", LookaheadQuality::fast}, {"balanced", LookaheadQuality::balanced}, {"high", LookaheadQuality::high}});
  table.row(&LookaheadOptions::candidates, "candidates",
            "Centres of the next fan of triangles that are tried out; 0: as `quality` says", {0, 64, "fans"});
  table.row(&LookaheadOptions::depth, "depth", "Fans drawn on trial behind each; 0: as `quality` says",
            {0, 64, "fans"});
  table.choice(&LookaheadOptions::target, "target",
               "Cache to order for: robust and fifo mean a FIFO of `cache-size`, robust with care for all others",
               {{"robust", LookaheadTarget::robust},
                {"fifo", LookaheadTarget::fifo},
                {"nvidia", LookaheadTarget::nvidia},
                {"amd", LookaheadTarget::amd},
                {"intel", LookaheadTarget::intel}});
  table.row(&LookaheadOptions::cache_size, "cache-size", "Size of the FIFO vertex cache to order for",
            {3, 256, "entries"});
  bind_options(plugin, table, [](const LookaheadOptions& options) { return std::make_unique<Lookahead>(options); });
  return plugin;
}

}  // namespace foredraw
