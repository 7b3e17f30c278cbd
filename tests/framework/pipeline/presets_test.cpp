#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/presets.h>

#include "support/meshes.h"

#include <foredraw/pipeline/plan.h>
#include <foredraw/technique/built_in_plugins.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace foredraw::presets_test {
namespace {

TEST(Presets, AreThoseThatTheDocumentsName) {
  std::vector<std::string_view> names;
  for (const Preset& preset : presets()) names.push_back(preset.name);
  EXPECT_EQ(names, (std::vector<std::string_view>{"cache-only", "character", "city", "crowd", "default", "displaced",
                                                  "game", "levels", "simplify", "small", "sprites", "static-prop",
                                                  "streaming", "walk", "wires"}));
}

TEST(Presets, ParseSayWhatTheyAreForAndMeasure) {
  for (const Preset& preset : presets()) {
    Diagnostics diagnostics;
    const auto pipeline = load_pipeline("@" + std::string(preset.name), diagnostics);
    ASSERT_TRUE(pipeline) << to_text(diagnostics);
    EXPECT_TRUE(diagnostics.empty());
    EXPECT_FALSE(pipeline->about.empty()) << preset.name;
    EXPECT_FALSE(pipeline->stages.empty()) << preset.name;
    EXPECT_FALSE(pipeline->measure.empty()) << preset.name;
  }
}

TEST(Presets, LackNoStageAndHaveNoneInVain) {
  Registry registry;
  add_built_in_plugins(registry);
  Draw sprite = testing::draw_of(testing::grid(1, 1), "Smoke");
  sprite.traits.add(traits::sprite);
  const Scene scene = testing::scene_of({testing::draw_of(testing::grid(3, 3), "Rock"), std::move(sprite)});
  for (const Preset& preset : presets()) {
    Diagnostics diagnostics;
    EXPECT_TRUE(plan(*load_pipeline("@" + std::string(preset.name), diagnostics), registry, scene, diagnostics));
    for (const char* code : {"wants", "left-broken", "unused", "undoes"}) {
      EXPECT_EQ(std::ranges::count(diagnostics.all(), code, &Diagnostic::code), 0) << to_text(diagnostics);
    }
  }
}

TEST(Presets, DifferFromEachOther) {
  std::vector<Pipeline> pipelines;
  for (const Preset& preset : presets()) {
    Diagnostics diagnostics;
    pipelines.push_back(parse_file(preset.text, std::string(preset.name), diagnostics).value());
  }
  for (std::size_t i = 0; i < pipelines.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(same_pipeline(pipelines[i], pipelines[j]));
  }
}

}  // namespace
}  // namespace foredraw::presets_test
