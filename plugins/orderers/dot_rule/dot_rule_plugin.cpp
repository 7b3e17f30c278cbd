#include "dot_rule.h"

#include <foredraw/technique/plugin.h>

namespace foredraw {

namespace {

IndexOrder in_sequence(const Clusters& clusters, const std::vector<std::uint32_t>& sequence) {
  IndexOrder order;
  order.reserve(clusters.offsets.back());
  for (std::uint32_t c : sequence) {
    for (std::uint32_t t = clusters.offsets[c]; t < clusters.offsets[c + 1]; ++t) order.push_back(t);
  }
  return order;
}

class DotRule final : public DrawOrderer {
 public:
  NothingToGain nothing_to_gain(const DrawView& draw, Run&) override {
    if (draw.stream().clusters->count() > 1) return std::nullopt;
    return "its triangles are one cluster, so there is nothing to sort";
  }

  IndexOrder order(const DrawView& draw, Run& run) override {
    const Clusters& clusters = *draw.stream().clusters;
    const auto positions = positions_of(run.analyses, draw.vertices());
    return in_sequence(clusters, dot_rule(positions->values, draw.indices(), clusters));
  }
};

struct DotRuleOptions {};

}  // namespace

Plugin dot_rule_plugin() {
  Plugin plugin;
  plugin.kind = Kind::orderer;
  plugin.card = {
      .name = "dot-rule",
      .summary = "Draws clusters that face outwards first, for low overdraw from every side",
      .reference = "Sander, Nehab, Barczak 2007, section 5",
      .acts_on = {traits::triangles},
      .needs = {traits::clustered},
      .provides = {traits::overdraw_ordered},
      .breaks = {traits::fetch_ordered},
      .pays_if = "the draw has more than one cluster",
  };
  bind_options(plugin, OptionTable<DotRuleOptions>(),
               [](const DotRuleOptions&) { return std::make_unique<DotRule>(); });
  return plugin;
}

}  // namespace foredraw
