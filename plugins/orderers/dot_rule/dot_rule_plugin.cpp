#include "dot_rule.h"

#include <foredraw/measuring/overdraw_service.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

namespace foredraw {

namespace {

struct DotRuleOptions {
  bool check = true;
};

class DotRuleOrderer final : public DrawOrderer {
 public:
  explicit DotRuleOrderer(DotRuleOptions options) : options_(options) {}

  IndexOrder order(const DrawView& draw, Run& run) const override {
    const Clusters& clusters = *draw.stream().clusters;
    if (clusters.count() < 2) {
      run.keep("it has only one cluster, so there is nothing to sort");
      return {};
    }
    const auto positions = positions_of(run.analyses, draw.vertices());
    IndexOrder order = in_sequence(clusters, dot_rule(positions->values, draw.indices(), clusters));
    if (options_.check) keep_if_no_better(draw, order, run);
    return order;
  }

 private:
  /// The rule is a guess, and on some meshes a wrong one: measured, the old order may be the better one.
  static void keep_if_no_better(const DrawView& draw, const IndexOrder& order, Run& run) {
    const Material* material = draw.scene.material_of(draw.draw());
    const double before = overdraw_of(draw.draw(), material, run);
    const double after = overdraw_of(with_triangle_order(draw.draw(), order), material, run);
    if (after >= before) {
      run.keep(fmt::format("sorting would not lower its overdraw: it is {:.4f}, and {:.4f} sorted", before, after));
    }
  }

  /// Of the draw alone, over all views.
  static double overdraw_of(Draw draw, const Material* material, Run& run) {
    Scene scene;
    if (material != nullptr) scene.materials.push_back(*material);
    draw.material = material != nullptr ? std::optional<MaterialId>(0) : std::nullopt;
    scene.draws.push_back(std::move(draw));
    const Subject alone{scene.draws[0].name, {{0, {}}}};
    const OverdrawCounts counts = run.overdraw->count(scene, alone, run.views, run);
    OverdrawCount sum;
    for (const OverdrawCount& count : counts[0]) sum += count;
    return sum.visible == 0 ? 1 : static_cast<double>(sum.shaded) / static_cast<double>(sum.visible);
  }

  DotRuleOptions options_;
};

}  // namespace

Plugin dot_rule_plugin() {
  Plugin plugin;
  plugin.kind = Kind::orderer;
  plugin.card = {
      .name = "dot-rule",
      .summary = "Draws outward-facing clusters first, which lowers overdraw from every side on most meshes",
      .reference = "Sander, Nehab, Barczak 2007, the DotRule",
      .acts_on = {traits::triangles},
      .needs = {traits::clustered},
      .provides = {traits::overdraw_ordered},
      .breaks = {traits::fetch_ordered},
      .pays_if = "the draw has several clusters, and sorting them lowers its measured overdraw",
      .uses_overdraw = true,
  };
  OptionTable<DotRuleOptions> table;
  table.row(&DotRuleOptions::check, "check",
            "Measure the draw's overdraw from the pipeline's views, and keep the old order where sorting does not "
            "lower it; false skips that, which is most of the time");
  bind_options(plugin, table, [](const DotRuleOptions& options) { return std::make_unique<DotRuleOrderer>(options); });
  return plugin;
}

}  // namespace foredraw
