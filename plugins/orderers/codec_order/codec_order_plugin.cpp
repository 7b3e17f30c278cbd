#include "codec_order.h"

#include <foredraw/technique/plugin.h>

#include <algorithm>

namespace foredraw {

namespace {

class CodecOrderOrderer final : public DrawOrderer {
 public:
  IndexOrder order(const DrawView& draw, Run& run) const override {
    IndexOrder order = codec_order(draw.indices(), draw.vertex_count());
    if (std::ranges::is_sorted(order)) run.keep("its triangles are in this order already");
    return order;
  }
};

struct CodecOrderOptions {};

}  // namespace

Plugin codec_order_plugin() {
  Plugin plugin;
  plugin.kind = Kind::orderer;
  plugin.card = {
      .name = "codec-order",
      .summary = "Orders triangles so that compressed files are short; put vertex-fetch(always=true) behind it",
      .reference = "own; for the codec of Giesen 2013 and Stokes 2014",
      .acts_on = {traits::triangles},
      .provides = {traits::cache_ordered},
      .breaks = {traits::overdraw_ordered, traits::fetch_ordered, traits::clustered},
  };
  bind_options(plugin, OptionTable<CodecOrderOptions>(),
               [](const CodecOrderOptions&) { return std::make_unique<CodecOrderOrderer>(); });
  return plugin;
}

}  // namespace foredraw
