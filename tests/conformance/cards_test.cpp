// Every plugin is what its card says.
#include "every_plugin.h"
#include "option_settings.h"

#include <foredraw/analysis/vertex_rows.h>
#include <foredraw/scene/levels.h>

#include <algorithm>
#include <set>

namespace foredraw::testing::cards_test {
namespace {

/// Whether the draw is what the trait says, as far as that can be seen from the draw.
bool holds(const std::string& trait, const Draw& draw) {
  const Level& level = draw.levels[0];
  if (trait == traits::clustered) return level.orders[0].clusters.has_value();
  if (trait == traits::welded) {
    const VertexRows rows(*level.vertices);
    std::set<Stamp> different;
    for (std::size_t v = 0; v < rows.size(); ++v) different.insert(content_hash(rows[v]));
    return different.size() == rows.size();
  }
  return true;
}

TEST_P(EveryPlugin, ProvidesWhatItsCardSays) {
  if (plugin().kind == Kind::evaluator) return;
  const Outcome outcome = run(pipeline_for(plugin(), few_pictures(plugin())), 2);
  const PlannedStage& stage = outcome.plan.stages.back();
  for (const Draw& draw : outcome.result.scene.draws) {
    for (const std::string& trait : plugin().card.provides) {
      EXPECT_TRUE(!traits_of(draw).has(trait) || holds(trait, draw)) << draw.name << ' ' << trait;
    }
    EXPECT_EQ(traits_of(draw).has(traits::clustered), draw.levels[0].orders[0].clusters.has_value()) << draw.name;
  }
  // Every draw that it was planned for has it now, but for those that vertices shared with others hold back. A stage
  // that finds nothing to gain in the scene as a whole has provided nothing.
  const StageRecord& record = outcome.result.report.stages.back();
  const auto is_of_all = [](const SkipRecord& skip) { return skip.code == "nothing-to-gain"; };
  if (record.changed == 0 && record.candidates == 1 && std::ranges::any_of(record.skipped, is_of_all)) return;
  for (DrawId id : stage.draws) {
    const Draw& draw = outcome.result.scene.draws[id];
    const bool held = draw.name.starts_with("held back");
    for (const std::string& trait : plugin().card.provides) {
      EXPECT_TRUE(held || traits_of(draw).has(trait)) << draw.name << ' ' << trait;
    }
  }
}

TEST_P(EveryPlugin, SaysWhatItIs) {
  const Card& card = plugin().card;
  EXPECT_FALSE(card.summary.empty());
  EXPECT_FALSE(card.reference.empty());
  EXPECT_NE(card.summary.back(), '.');
  for (const OptionSpec& option : plugin().options) EXPECT_FALSE(option.doc.empty()) << option.name;
  EXPECT_TRUE(plugin().kind != Kind::evaluator || !card.metrics.empty());
  for (const std::string& name : card.measured_by) {
    const Plugin* evaluator = registry().find(name);
    ASSERT_NE(evaluator, nullptr) << name;
    EXPECT_EQ(evaluator->kind, Kind::evaluator) << name;
  }
  for (const Traits* asked : {&card.wants, &card.uses}) {
    for (const std::string& trait : *asked) {
      const auto provides = [&](const Plugin* other) { return other->card.provides.has(trait); };
      EXPECT_TRUE(std::ranges::any_of(registry().all(), provides)) << "nobody makes draws " << trait;
    }
  }
}

}  // namespace
}  // namespace foredraw::testing::cards_test
