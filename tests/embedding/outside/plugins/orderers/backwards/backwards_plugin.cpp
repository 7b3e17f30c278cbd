#include "backwards.h"

#include <foredraw/technique/plugin.h>

namespace foredraw {

namespace {

struct Options {};

class Backwards final : public DrawOrderer {
 public:
  IndexOrder order(const DrawView& draw, Run&) const override { return backwards(draw.triangle_count()); }
};

}  // namespace

Plugin backwards_plugin() {
  Plugin plugin;
  plugin.kind = Kind::orderer;
  plugin.card = {
      .name = "backwards",
      .summary = "Draws the last triangle first",
      .reference = "own",
      .acts_on = {traits::triangles},
      .breaks = {traits::cache_ordered, traits::overdraw_ordered, traits::fetch_ordered, traits::clustered},
  };
  bind_options(plugin, OptionTable<Options>(), [](const Options&) { return std::make_unique<Backwards>(); });
  return plugin;
}

}  // namespace foredraw
