#include <foredraw/pipeline/parse.h>

#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace foredraw::load_pipeline_test {
namespace {

TEST(LoadPipeline, TakesALineAPresetOrAFile) {
  Diagnostics diagnostics;
  const auto line = load_pipeline("weld, tipsify", diagnostics);
  ASSERT_TRUE(line);
  EXPECT_EQ(line->stages.size(), 2u);
  const auto preset = load_pipeline("@default", diagnostics);
  ASSERT_TRUE(preset);
  EXPECT_EQ(preset->stages.front().where.file, "@default");

  const testing::TestFolder folder;
  const auto file = folder.path() / "a pipeline.toml";
  std::ofstream(file) << "pipeline = 1\nseed = 7\n";
  const auto read = load_pipeline(file.string(), diagnostics);
  ASSERT_TRUE(read) << to_text(diagnostics);
  EXPECT_EQ(read->seed, 7);
  EXPECT_TRUE(diagnostics.empty());
}

TEST(LoadBranches, CallsALineByItself) {
  Diagnostics diagnostics;
  const auto branches = load_branches("weld, tipsify", diagnostics);
  ASSERT_TRUE(branches);
  EXPECT_EQ(branches->front().name, "weld, tipsify");
  EXPECT_EQ(load_branches("@default", diagnostics)->front().name, "@default");
  EXPECT_FALSE(load_branches("@defualt", diagnostics));
}

TEST(LoadPipeline, SaysWhatItLookedFor) {
  const auto refusal = [](const std::string& argument) {
    Diagnostics diagnostics;
    EXPECT_FALSE(load_pipeline(argument, diagnostics));
    return to_text(diagnostics);
  };
  EXPECT_EQ(refusal("@defualt"), "@defualt: error: there is no preset 'defualt'\n    hint: did you mean '@default'?\n");
  EXPECT_EQ(refusal("@"),
            "@: error: there is no preset ''\n    hint: there are @cache-only, @character, @city, @crowd, @default, "
            "@displaced, @game, @levels, @simplify, @small, @sprites, @static-prop, @streaming, @walk, @wires\n");
  EXPECT_NE(refusal("missing/props.toml").find("missing/props.toml"), std::string::npos);
  EXPECT_TRUE(
      refusal("missing/props").starts_with("missing/props: error: there is no such file\n    hint: a pipeline is"));
  EXPECT_TRUE(refusal("props.tml").starts_with("props.tml: error: there is no such file"));
}

}  // namespace
}  // namespace foredraw::load_pipeline_test
