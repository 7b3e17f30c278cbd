#include <foredraw/pipeline/measured_frames.h>

#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/plan.h>
#include <foredraw/technique/built_in_plugins.h>

#include "support/meshes.h"
#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace foredraw::measured_frames_test {
namespace {

/// The settings of the measures that the plan of this text has.
std::vector<Settings> frames_settings(const std::string& text, const std::string& name = "p.toml") {
  Registry registry;
  add_built_in_plugins(registry);
  Diagnostics diagnostics;
  const auto pipeline = parse_file(text, name, diagnostics);
  EXPECT_TRUE(pipeline) << to_text(diagnostics);
  const Scene scene = testing::scene_of(testing::grid(2, 2));
  const auto plan = foredraw::plan(*pipeline, registry, scene, diagnostics);
  EXPECT_TRUE(plan) << to_text(diagnostics);
  std::vector<Settings> settings;
  for (const Stage& stage : plan->pipeline.measure) settings.push_back(stage.settings);
  return settings;
}

TEST(MeasuredFrames, EvaluatorsOfFramesTakeWhatTheyDoNotSay) {
  const auto settings = frames_settings(
      "pipeline = 1\nmeasure = ['vertex-cache', 'lod-walk(frames=9)']\n"
      "[frames]\npath = 'around'\nframes = 30\nangle = 45.5\n");
  EXPECT_TRUE(settings[0].empty());
  EXPECT_EQ(settings[1].at("frames"), OptionValue(std::int64_t{9}));
  EXPECT_EQ(settings[1].at("path"), OptionValue(std::string("around")));
  EXPECT_EQ(settings[1].at("angle"), OptionValue(45.5));
  EXPECT_FALSE(settings[1].contains("seed"));
}

TEST(MeasuredFrames, PathsOfFilesCountFromThePipelinesFolder) {
  const testing::TestFolder own;
  const std::filesystem::path& folder = own.path();
  std::ofstream(folder / "a.walk") << "0  0 0 5  0 0 0\n";
  const auto settings = frames_settings("pipeline = 1\nmeasure = ['lod-walk']\n[frames]\npath = 'a.walk'\n",
                                        (folder / "p.toml").string());
  EXPECT_EQ(settings[0].at("path"), OptionValue((folder / "a.walk").string()));
}

TEST(MeasuredFrames, AWrongPathIsAMistakeOfThePipeline) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_file("pipeline = 1\n[frames]\npath = 'camra'\n", "p.toml", diagnostics));
  EXPECT_NE(to_text(diagnostics).find("did you mean 'camera'?"), std::string::npos);
}

}  // namespace
}  // namespace foredraw::measured_frames_test
