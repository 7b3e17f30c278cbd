#pragma once
// One small plugin for every shape of technique, so that each is run by a test, and one that misbehaves.

#include <foredraw/technique/registry.h>

namespace foredraw::testing {

Plugin reverse_draw();      ///< draw orderer: the last triangle first; provides cache-ordered
Plugin two_orders();        ///< subject orderer: the order there is, and its reverse for looks from below
Plugin reverse_vertices();  ///< vertex orderer: the last vertex first
Plugin pairs();             ///< clusterer: two triangles each
Plugin add_draw();          ///< scene processor: one more draw, a copy of the first
Plugin double_triangles();  ///< draw processor: every triangle twice
Plugin count_draws();       ///< scene evaluator: metric "draws"
Plugin count_triangles();   ///< draw evaluator: metric "triangles"
Plugin ask_overdraw();      ///< draw orderer that asks run.overdraw, and fails where nobody answers
Plugin answer_overdraw();   ///< scene evaluator whose service answers 3 shaded of 2 visible

struct FaultyOptions {
  std::string fault = "throw";  ///< throw | odd-throw | short | repeat
  std::string on = "*";         ///< the draw it goes wrong on
};
Plugin faulty();            ///< draw orderer that throws or answers with no permutation
Plugin keeps_everything();  ///< draw orderer for a cache of 48 that keeps what there is; breaks clustered
Plugin unavailable();       ///< draw orderer that this machine lacks something for
Plugin needs_clusters();    ///< draw orderer that needs clustered, and undoes cache-ordered

/// All of them.
void add_test_plugins(Registry& registry);

/// A plugin of a technique that a test defines. It has no options.
template <class Technique>
Plugin plugin_of(Kind kind, Card card) {
  struct NoOptions {};
  Plugin plugin;
  plugin.kind = kind;
  if (card.summary.empty()) card.summary = "For tests";
  card.reference = "own";
  plugin.card = std::move(card);
  bind_options(plugin, OptionTable<NoOptions>(), [](const NoOptions&) { return std::make_unique<Technique>(); });
  return plugin;
}

}  // namespace foredraw::testing
