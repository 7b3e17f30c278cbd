#include <foredraw/pipeline/usual_measures.h>

#include "support/test_plugins.h"

#include <foredraw/pipeline/parse.h>

#include <gtest/gtest.h>

namespace foredraw::usual_measures_test {
namespace {

using Uses = std::vector<std::string>;

Uses measured(const std::string& stages) {
  Registry registry;
  testing::add_test_plugins(registry);
  for (const auto& [name, evaluators] :
       {std::pair{"trims", Uses{"count-triangles"}}, std::pair{"packs", Uses{"count-draws", "count-triangles"}},
        std::pair{"odd", Uses{"not-built-here"}}}) {
    Plugin plugin = testing::double_triangles();
    plugin.card.name = name;
    plugin.card.measured_by = evaluators;
    registry.add(std::move(plugin));
  }
  Diagnostics diagnostics;
  Uses uses;
  for (const Stage& stage : usual_measures(parse_line(stages, diagnostics)->stages, registry))
    uses.push_back(stage.use);
  return uses;
}

TEST(UsualMeasures, AreThoseThatTheCardsName) {
  EXPECT_EQ(measured("trims"), (Uses{"count-triangles"}));
  EXPECT_EQ(measured("trims, packs"), (Uses{"count-triangles", "count-draws"}));
}

TEST(UsualMeasures, AreThoseOfTheDefaultWhereACardNamesNone) {
  const Uses of_default{"vertex-cache", "overdraw-raster"};
  EXPECT_EQ(measured(""), of_default);
  EXPECT_EQ(measured("reverse-draw, pairs"), of_default);
  EXPECT_EQ(measured("odd"), of_default) << "an evaluator that the build lacks is none";
  EXPECT_EQ(measured("trims, reverse-draw"), (Uses{"count-triangles", "vertex-cache", "overdraw-raster"}));
  EXPECT_EQ(measured("trims, reverse-draw(enabled=false)"), (Uses{"count-triangles"}));
}

}  // namespace
}  // namespace foredraw::usual_measures_test
