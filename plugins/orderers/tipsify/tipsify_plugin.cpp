#include "tipsify.h"

#include <foredraw/technique/plugin.h>

namespace foredraw {

namespace {

class Tipsify final : public DrawOrderer {
 public:
  explicit Tipsify(TipsifyOptions options) : options_(options) {}

  IndexOrder order(const DrawView& draw, Run&) override {
    return tipsify(draw.indices(), draw.vertex_count(), options_);
  }

  int cache_size() const override { return options_.cache_size; }

 private:
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
  };
  OptionTable<TipsifyOptions> table;
  table.row(&TipsifyOptions::cache_size, "cache-size", "Size of the FIFO vertex cache to order for",
            {3, 1024, "entries"});
  bind_options(plugin, table, [](const TipsifyOptions& options) { return std::make_unique<Tipsify>(options); });
  return plugin;
}

}  // namespace foredraw
