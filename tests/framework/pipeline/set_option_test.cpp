#include <foredraw/pipeline/output_words.h>
#include <foredraw/pipeline/parse.h>

#include <gtest/gtest.h>

namespace foredraw::set_option_test {
namespace {

Pipeline example() {
  Diagnostics diagnostics;
  return parse_file(R"toml(pipeline = 1
stages = [
  "weld",
  { use = "tipsify", cache-size = 16 },
  { use = "linear-clusters", growth = 1.05, enabled = false },
  "dot-rule(only='Rock_*', required=true)",
]
measure = [{ use = "overdraw-raster", views = "random", count = 300, seed = 7, distance = 3 }]
services.overdraw = { use = "overdraw-raster", faces = "front" }
)toml",
                    "props.toml", diagnostics)
      .value();
}

TEST(SetOption, SetsEveryStageOfTheName) {
  Pipeline pipeline = example();
  Diagnostics diagnostics;
  EXPECT_TRUE(set_option(pipeline, "overdraw-raster.faces=material", diagnostics));
  EXPECT_EQ(pipeline.measure[0].settings.at("faces"), OptionValue(std::string("material")));
  EXPECT_EQ(pipeline.measure[0].settings.size(), 5u);
  EXPECT_EQ(pipeline.overdraw->settings.at("faces"), OptionValue(std::string("material")));
  EXPECT_TRUE(set_option(pipeline, "tipsify.cache-size=24", diagnostics));
  EXPECT_EQ(pipeline.stages[1].settings, (Settings{{"cache-size", std::int64_t{24}}}));
  EXPECT_EQ(pipeline.stages[1].option_where.at("cache-size").file, "--set");
  EXPECT_EQ(pipeline.stages[1].option_where.at("cache-size").column, 20);
  EXPECT_EQ(pipeline.stages[1].where.line, 4);
  EXPECT_TRUE(diagnostics.empty());
}

TEST(SetOption, SetsReservedWords) {
  Pipeline pipeline = example();
  Diagnostics diagnostics;
  EXPECT_TRUE(set_option(pipeline, "dot-rule.enabled=false", diagnostics));
  EXPECT_TRUE(set_option(pipeline, "linear-clusters.enabled=true", diagnostics));
  EXPECT_TRUE(set_option(pipeline, "weld.only=\"a = b.c\"", diagnostics));
  EXPECT_FALSE(pipeline.stages[3].enabled);
  EXPECT_EQ(pipeline.stages[3].only, "Rock_*");
  EXPECT_TRUE(pipeline.stages[3].required);
  EXPECT_TRUE(pipeline.stages[2].enabled);
  EXPECT_EQ(pipeline.stages[0].only, "a = b.c");
}

TEST(SetOption, SetsHowGltfIsWritten) {
  Pipeline pipeline = example();
  Diagnostics diagnostics;
  EXPECT_TRUE(set_option(pipeline, "output.compression=khr-meshopt", diagnostics));
  EXPECT_EQ(pipeline.output.compression, Compression::khr);
  EXPECT_FALSE(set_option(pipeline, "output.compression=zip", diagnostics));
  EXPECT_FALSE(set_option(pipeline, "output.size=1", diagnostics));
}

TEST(SetOutput, ALineSetsWhatSetOptionSetsAndRefusesItInTheSameWords) {
  Pipeline pipeline = example();
  Diagnostics refused;
  for (const char* assignment : {"output.compression=draco", "output.corners=turn", "output.products=none"}) {
    EXPECT_TRUE(set_option(pipeline, assignment, refused));
  }
  OutputSettings output;
  Diagnostics diagnostics;
  EXPECT_TRUE(set_output(output, "compression=draco, corners = \"turn\", products=none", "settings", diagnostics));
  EXPECT_EQ(output, pipeline.output);
  EXPECT_EQ(words_of(output), (Settings{{"compression", "draco"}, {"corners", "turn"}, {"products", "none"}}));
  EXPECT_TRUE(set_output(output, " ", "settings", diagnostics)) << "none is set";
  for (const char* wrong : {"compression=zip", "size=1"}) {
    EXPECT_FALSE(set_option(pipeline, std::string("output.") + wrong, refused));
    EXPECT_FALSE(set_output(output, wrong, "settings", diagnostics));
    EXPECT_EQ(diagnostics.all().back().code, refused.all().back().code);
    EXPECT_EQ(diagnostics.all().back().message, refused.all().back().message);
    EXPECT_EQ(diagnostics.all().back().hint, refused.all().back().hint);
  }
  EXPECT_FALSE(set_output(output, "compression=none corners=turn", "settings", diagnostics));
  EXPECT_EQ(diagnostics.all().back().code, "syntax");
  EXPECT_EQ(output, pipeline.output) << "what is refused changes nothing";
}

TEST(SetOption, TakesNumbersWithoutTheirZero) {
  const auto value = [](std::string_view assignment) {
    Pipeline pipeline = example();
    Diagnostics diagnostics;
    EXPECT_TRUE(set_option(pipeline, assignment, diagnostics)) << assignment;
    return pipeline.stages[0].settings.at("x");
  };
  EXPECT_EQ(value("weld.x=.25"), OptionValue(.25));
  EXPECT_EQ(value("weld.x=-.5e-3"), OptionValue(-.5e-3));
  for (const std::string text : {".", "..5", "./5", ".5.5", ".hidden", "-."}) {
    EXPECT_EQ(value("weld.x=" + text), OptionValue(text));
  }
}

TEST(SetOption, RefusesWithoutChange) {
  const Pipeline before = example();
  const auto refusal = [&before](std::string_view assignment) {
    Pipeline pipeline = before;
    Diagnostics diagnostics;
    EXPECT_FALSE(set_option(pipeline, assignment, diagnostics));
    EXPECT_TRUE(same_pipeline(pipeline, before));
    return to_text(diagnostics);
  };
  EXPECT_EQ(refusal("tipsfy.cache-size=24"),
            "--set:1:1: error: the pipeline has no stage 'tipsfy'\n    hint: did you mean 'tipsify'?\n");
  for (const std::string_view odd : {"", "tipsify", "tipsify=3", "tipsify.cache-size", ".a=1", "a.=1", "=a.b"}) {
    EXPECT_TRUE(refusal(odd).starts_with("--set:1:1: error: expected stage.option=value, found")) << odd;
  }
  EXPECT_EQ(refusal("weld.enabled=maybe"), "--set:1:14: error: 'enabled' must be true or false, not \"maybe\"\n");
  EXPECT_EQ(refusal("weld.only=a b"),
            "--set:1:13: error: expected nothing after the value, found 'b'\n"
            "    hint: put text with spaces or commas in quotes that the shell leaves: 'STAGE.OPTION=\"0.5, 0.25\"'\n");
  EXPECT_EQ(refusal("weld.only=[0.5]"),
            "--set:1:11: error: expected a value, found '['\n"
            "    hint: put text with spaces or special characters in quotes, and lists, too, without brackets: "
            "\"0.5, 0.25\"\n");
  EXPECT_EQ(refusal("weld.only="),
            "--set:1:11: error: expected a value, found the end\n    hint: an empty text is written \"\"\n");
  EXPECT_NE(refusal("weld.only=\"a\\").find("has no end"), std::string::npos);
}

TEST(SetOption, ReachesThePipelinesOwnWords) {
  Diagnostics diagnostics;
  Pipeline pipeline;
  EXPECT_TRUE(set_option(pipeline, "views.count=162", diagnostics));
  EXPECT_TRUE(set_option(pipeline, "views.views=random", diagnostics));
  EXPECT_TRUE(set_option(pipeline, "poses.poses=64", diagnostics));
  EXPECT_TRUE(set_option(pipeline, "poses.clips=Walk*", diagnostics));
  EXPECT_TRUE(set_option(pipeline, "subjects.subject=scene", diagnostics));
  EXPECT_TRUE(set_option(pipeline, "frames.path=around", diagnostics));
  EXPECT_TRUE(set_option(pipeline, "frames.frames=30", diagnostics));
  EXPECT_TRUE(set_option(pipeline, "seed=7", diagnostics));
  EXPECT_EQ(pipeline.views.count, 162);
  EXPECT_EQ(pipeline.views.views, "random");
  EXPECT_EQ(pipeline.poses.poses, "64");
  EXPECT_EQ(pipeline.poses.clips, "Walk*");
  EXPECT_EQ(pipeline.subjects.subject, SubjectUnit::scene);
  EXPECT_EQ(pipeline.frames.path, "around");
  EXPECT_EQ(pipeline.frames.frames, 30);
  EXPECT_EQ(pipeline.seed, 7);
  EXPECT_TRUE(diagnostics.empty());
  for (const char* wrong : {"views.size=1", "views.colour=3", "poses.rate=0", "poses.rat=1", "subjects.subject=car",
                            "frames.frames=0", "about=x", "seed=x"})
    EXPECT_FALSE(set_option(pipeline, wrong, diagnostics)) << wrong;
}

TEST(SetOption, DoesNotTurnAStageIntoAnother) {
  Diagnostics diagnostics;
  Pipeline pipeline;
  pipeline.stages.push_back({.use = "tipsify"});
  EXPECT_FALSE(set_option(pipeline, "tipsify.use=weld", diagnostics));
  EXPECT_EQ(pipeline.stages[0].use, "tipsify");
}

}  // namespace
}  // namespace foredraw::set_option_test
