// What a plan says of a stage's neighbours, which it knows by their cards.

#include <foredraw/pipeline/stage_order.h>

#include "support/meshes.h"
#include "support/test_plugins.h"

#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/plan.h>

#include <gtest/gtest.h>

namespace foredraw::stage_order_test {
namespace {

/// A sorter, a cutter of its order, two who sort what was cut or may be, and one who puts vertices in order at last.
class StageOrder : public ::testing::Test {
 protected:
  StageOrder() {
    add(Kind::orderer, {.name = "sorter",
                        .provides = {traits::cache_ordered},
                        .breaks = {traits::overdraw_ordered, traits::fetch_ordered, traits::clustered}});
    add(Kind::clusterer, {.name = "cutter", .wants = {traits::cache_ordered}, .provides = {traits::clustered}});
    add(Kind::orderer, {.name = "mover",
                        .needs = {traits::clustered},
                        .provides = {traits::overdraw_ordered},
                        .breaks = {traits::fetch_ordered}});
    add(Kind::orderer, {.name = "picker",
                        .wants = {traits::cache_ordered},
                        .uses = {traits::clustered},
                        .provides = {traits::overdraw_ordered},
                        .breaks = {traits::fetch_ordered}});
    add(Kind::orderer, {.name = "fetcher", .provides = {traits::fetch_ordered}});
    add(Kind::processor, {.name = "maker", .breaks = {traits::fetch_ordered, traits::cache_ordered}});
  }

  /// "code: hint" of all that is said.
  std::vector<std::string> said(const std::string& stages) const {
    Diagnostics diagnostics;
    const auto pipeline = parse_line(stages, diagnostics);
    plan(*pipeline, registry_, testing::scene_of(testing::grid(2, 2)), diagnostics);
    std::vector<std::string> all;
    for (const Diagnostic& diagnostic : diagnostics.all()) all.push_back(diagnostic.code + ": " + diagnostic.hint);
    return all;
  }

 private:
  void add(Kind kind, Card card) {
    Plugin plugin = testing::reverse_draw();
    plugin.kind = kind;
    plugin.card = std::move(card);
    registry_.add(std::move(plugin));
  }

  Registry registry_;
};

using Said = std::vector<std::string>;

TEST_F(StageOrder, TheHintOfAMissingTraitIsAWholePipeline) {
  EXPECT_EQ(said("mover"), (Said{"needs: put 'sorter', then 'cutter' before it, and 'fetcher' after it"}));
  EXPECT_EQ(said("sorter, mover"), (Said{"needs: put 'cutter' before it, and 'fetcher' after it"}));
  EXPECT_EQ(said("mover, fetcher"), (Said{"needs: put 'sorter', then 'cutter' before it"}));
  EXPECT_EQ(said("sorter, cutter, mover, fetcher"), Said{});
}

TEST_F(StageOrder, WarnsOfWhatAStageWantsAndNobodyMade) {
  EXPECT_EQ(said("picker, fetcher"), (Said{"wants: put 'sorter' before it"}));
  EXPECT_EQ(said("sorter, picker, fetcher"), Said{}) << "what it uses it can do without";
}

TEST_F(StageOrder, WarnsOfWhatIsLeftBrokenByTheLastThatBreaksIt) {
  EXPECT_EQ(said("sorter, picker"), (Said{"left-broken: put 'fetcher' after it"}));
  EXPECT_EQ(said("sorter, fetcher(enabled=false)"), (Said{"left-broken: put 'fetcher' after it"}));
  EXPECT_EQ(said("fetcher, sorter"), (Said{"undoes: put 'sorter' before 'fetcher'"})) << "said once";
  EXPECT_EQ(said("maker"), Said{}) << "it makes what no order held of";
}

TEST_F(StageOrder, WarnsOfClustersThatNobodyUses) {
  EXPECT_EQ(said("sorter, cutter, fetcher"), (Said{"unused: put 'mover' or 'picker' after it"}));
  EXPECT_EQ(said("sorter, cutter, picker, fetcher"), Said{});
}

TEST(WayTo, EndsWhereCardsNeedEachOther) {
  Registry registry;
  for (const auto& [name, needs, provides] : {std::tuple{"hen", "egg", "hen"}, std::tuple{"nest", "hen", "egg"}}) {
    Plugin plugin = testing::reverse_draw();
    plugin.card = {.name = name, .needs = {needs}, .provides = {provides}};
    registry.add(std::move(plugin));
  }
  EXPECT_EQ(way_to({"hen"}, {}, registry), "'nest', then 'hen'");
  EXPECT_EQ(way_to({"hen"}, {"egg"}, registry), "'hen'");
  EXPECT_EQ(way_to({"cow"}, {}, registry), "");
}

}  // namespace
}  // namespace foredraw::stage_order_test
