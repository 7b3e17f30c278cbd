#include <foredraw/pipeline/parse.h>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstring>

namespace foredraw::print_test {
namespace {

/// Names and texts as people never write them, but files may hold them.
rc::Gen<std::string> any_text() {
  const auto piece = rc::gen::element<std::string>(
      "a", "Z", "7", "-", "_", ".", "/", "*", "?", "@", "+", " ", "\"", "'", "\\", "\n", "\r", "\t", "\x01", "\x7f",
      ",", "=", "(", ")", "#", "{", "]", "\xc3\xa4", "\xe6\xbc\xa2", "\xf0\x9f\xaa\xa8", "true", "inf", "1e5");
  const auto joined = rc::gen::map(rc::gen::container<std::vector<std::string>>(piece), [](const auto& pieces) {
    std::string text;
    for (const std::string& each : pieces) text += each;
    return text;
  });
  const auto ordinary = rc::gen::element<std::string>("tipsify", "dot-rule", "true", "-inf", "nan", "16", "1.5", "0x10",
                                                      "1979-05-27", "Rock_*", "");
  return rc::gen::oneOf(joined, ordinary);
}

rc::Gen<double> any_finite() {
  const auto bits = rc::gen::map(rc::gen::arbitrary<std::uint64_t>(), [](std::uint64_t pattern) {
    double number;
    std::memcpy(&number, &pattern, sizeof number);
    return std::isfinite(number) ? number : 5e-324;
  });
  return rc::gen::oneOf(bits, rc::gen::arbitrary<double>(), rc::gen::element(0.0, 1.0, -3.0, 16.0, 1e20, 1e-5, 0.1));
}

rc::Gen<OptionValue> any_value() {
  return rc::gen::oneOf(rc::gen::map(rc::gen::arbitrary<bool>(), [](bool v) { return OptionValue(v); }),
                        rc::gen::map(rc::gen::arbitrary<std::int64_t>(), [](std::int64_t v) { return OptionValue(v); }),
                        rc::gen::map(any_finite(), [](double v) { return OptionValue(v); }),
                        rc::gen::map(any_text(), [](std::string v) { return OptionValue(std::move(v)); }));
}

Stage any_stage() {
  Stage stage;
  stage.use = *any_text();
  stage.settings = *rc::gen::container<Settings>(any_text(), any_value());
  for (const char* reserved : {"use", "only", "required", "enabled", "blended", "level"})
    stage.settings.erase(reserved);
  stage.only = *any_text();
  stage.required = *rc::gen::arbitrary<bool>();
  stage.enabled = *rc::gen::arbitrary<bool>();
  stage.blended = *rc::gen::arbitrary<bool>();
  stage.level = *rc::gen::inRange(0, 256);
  return stage;
}

std::vector<Stage> any_stages() {
  std::vector<Stage> stages(*rc::gen::inRange<std::size_t>(0, 4));
  for (Stage& stage : stages) stage = any_stage();
  return stages;
}

ViewSet any_views() {
  ViewSet views;
  views.views = *rc::gen::element<std::string>("icosphere", "fibonacci", "random", "cone", "42");
  if (views.views == "fibonacci" || views.views == "random") {
    if (*rc::gen::arbitrary<bool>()) views.count = *rc::gen::inRange(1, 100000);
  }
  views.seed = *rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 53);
  if (*rc::gen::arbitrary<bool>()) views.axis = std::to_string(*rc::gen::inRange(1, 9)) + " 0 -1.5";
  if (*rc::gen::arbitrary<bool>()) views.angle = *rc::gen::inRange(1, 180);
  if (*rc::gen::arbitrary<bool>()) views.rotation = *rc::gen::inRange(0, 1000);
  if (*rc::gen::arbitrary<bool>()) views.distance = 1.01 + *rc::gen::inRange(0, 1000) / 7.0;
  views.size = *rc::gen::inRange(16, 4097);
  return views;
}

PoseSet any_poses() {
  PoseSet poses;
  poses.poses = *rc::gen::element<std::string>("all", "bind", "64");
  if (*rc::gen::arbitrary<bool>()) poses.clips = "Walk *\"";
  if (*rc::gen::arbitrary<bool>()) {
    poses.rate = *rc::gen::inRange(1, 1000) / 7.0;
  } else if (*rc::gen::arbitrary<bool>()) {
    poses.moments = "0 " + std::to_string(*rc::gen::inRange(1, 9)) + ".5";
  }
  return poses;
}

Pipeline any_pipeline() {
  Pipeline pipeline;
  pipeline.about = *any_text();
  pipeline.stages = any_stages();
  pipeline.measure = any_stages();
  pipeline.views = any_views();
  pipeline.poses = any_poses();
  pipeline.subjects.subject = *rc::gen::element(SubjectUnit::mesh, SubjectUnit::character, SubjectUnit::scene);
  pipeline.frames.path = *rc::gen::element<std::string>("auto", "around", "camera", "../walks/a.walk");
  if (*rc::gen::arbitrary<bool>()) pipeline.frames.frames = *rc::gen::inRange(1, 1000);
  if (*rc::gen::arbitrary<bool>()) pipeline.frames.width = *rc::gen::inRange(16, 4096);
  if (*rc::gen::arbitrary<bool>()) pipeline.frames.height = *rc::gen::inRange(16, 4096);
  if (*rc::gen::arbitrary<bool>()) pipeline.frames.angle = *rc::gen::inRange(10, 1000) / 7.0;
  if (*rc::gen::arbitrary<bool>()) pipeline.frames.seed = *rc::gen::inRange<std::int64_t>(0, 1000);
  if (*rc::gen::arbitrary<bool>()) pipeline.overdraw = any_stage();
  pipeline.output.compression = *rc::gen::element(Compression::keep, Compression::none, Compression::ext,
                                                  Compression::khr, Compression::draco, Compression::draco_edgebreaker);
  pipeline.output.turns_corners = *rc::gen::arbitrary<bool>();
  pipeline.output.levels = *rc::gen::element(LevelsAs::extension, LevelsAs::lod_nodes);
  pipeline.output.has_products = *rc::gen::arbitrary<bool>();
  pipeline.seed = *rc::gen::arbitrary<std::int64_t>();
  return pipeline;
}

TEST(Print, EveryPipelineReadsBackFromAFile) {
  EXPECT_TRUE(rc::check([] {
    const Pipeline pipeline = any_pipeline();
    const std::string text = print_file(pipeline);
    RC_LOG() << text;
    Diagnostics diagnostics;
    const auto back = parse_file(text, "printed.toml", diagnostics);
    RC_LOG() << to_text(diagnostics);
    RC_ASSERT(back.has_value());
    RC_ASSERT(same_pipeline(*back, pipeline));
    RC_ASSERT(back->about == pipeline.about);
    RC_ASSERT(print_file(*back) == text);
  }));
}

TEST(Print, EveryListOfStagesReadsBackFromALine) {
  EXPECT_TRUE(rc::check([] {
    Pipeline pipeline;
    pipeline.stages = any_stages();
    const auto text = print_line(pipeline);
    RC_ASSERT(text.has_value());
    RC_LOG() << *text;
    Diagnostics diagnostics;
    const auto back = parse_line(*text, diagnostics);
    RC_LOG() << to_text(diagnostics);
    RC_ASSERT(back.has_value());
    RC_ASSERT(same_pipeline(*back, pipeline));
    RC_ASSERT(print_line(*back) == text);
    RC_ASSERT(text->find('\n') == std::string::npos);
  }));
}

TEST(Print, ParsersStandWhateverTheyAreGiven) {
  EXPECT_TRUE(rc::check([] {
    const std::string text = *any_text() + *any_text();
    Diagnostics from_line, from_file, from_set;
    const bool line_read = parse_line(text, from_line).has_value();
    RC_ASSERT(line_read != from_line.has_errors());
    const bool file_read = parse_file("pipeline = 1\n" + text, "f", from_file).has_value();
    RC_ASSERT(file_read != from_file.has_errors());
    Pipeline pipeline;
    pipeline.stages = {Stage{.use = "a"}};
    const bool is_set = set_option(pipeline, "a.b=" + text, from_set);
    RC_ASSERT(is_set != from_set.has_errors());
  }));
}

TEST(Print, IsCanonical) {
  Diagnostics diagnostics;
  const auto pipeline =
      parse_file(R"(stages=["weld",{cache-size=0x10,use="tipsify",enabled=true},'a(only="x y",b=2.0)', { use = "q q" }]
measure=['vertex-cache']
services.overdraw="overdraw-raster"
views={size=512,views=42}
pipeline=1
seed=3)",
                 "f", diagnostics);
  ASSERT_TRUE(pipeline) << to_text(diagnostics);
  EXPECT_EQ(print_file(*pipeline), R"(pipeline = 1
seed = 3
stages = [
  "weld",
  { use = "tipsify", cache-size = 16 },
  { use = "a", b = 2.0, only = "x y" },
  { use = "q q" },
]
measure = [
  "vertex-cache",
]

[views]
views = "42"
size = 512

[services]
overdraw = "overdraw-raster"
)");
  EXPECT_EQ(print_stage(pipeline->stages[2]), "a(b=2.0, only=\"x y\")");
}

TEST(Print, ALineHoldsStagesAlone) {
  Pipeline plain;
  plain.stages = {Stage{.use = "weld"}};
  EXPECT_EQ(print_line(plain), "weld");
  EXPECT_EQ(print_line(Pipeline{}), "");
  const auto more = [&plain](auto change) {
    Pipeline pipeline = plain;
    change(pipeline);
    return print_line(pipeline);
  };
  EXPECT_EQ(more([](Pipeline& p) { p.about = "x"; }), std::nullopt);
  EXPECT_EQ(more([](Pipeline& p) { p.seed = 1; }), std::nullopt);
  EXPECT_EQ(more([](Pipeline& p) { p.measure = p.stages; }), std::nullopt);
  EXPECT_EQ(more([](Pipeline& p) { p.views.size = 64; }), std::nullopt);
  EXPECT_EQ(more([](Pipeline& p) { p.poses.rate = 30; }), std::nullopt);
  EXPECT_EQ(more([](Pipeline& p) { p.subjects.subject = SubjectUnit::scene; }), std::nullopt);
  EXPECT_EQ(more([](Pipeline& p) { p.frames.frames = 3; }), std::nullopt);
  EXPECT_EQ(more([](Pipeline& p) { p.output.turns_corners = true; }), std::nullopt);
  EXPECT_EQ(more([](Pipeline& p) { p.overdraw = Stage{.use = "x"}; }), std::nullopt);
}

TEST(SamePipeline, ComparesWhatDecidesWhatRuns) {
  Pipeline a;
  a.stages = {Stage{.use = "weld"}};
  a.overdraw = Stage{.use = "x"};
  const auto same_after = [&a](auto change) {
    Pipeline b = a;
    change(b);
    return same_pipeline(a, b);
  };
  EXPECT_TRUE(same_after([](Pipeline& p) { p.stages[0].where.line = 3; }));
  EXPECT_TRUE(same_after([](Pipeline& p) { p.about = "said otherwise"; }));
  EXPECT_FALSE(same_after([](Pipeline& p) { p.stages[0].use = "other"; }));
  EXPECT_FALSE(same_after([](Pipeline& p) { p.stages[0].only = "a"; }));
  EXPECT_FALSE(same_after([](Pipeline& p) { p.stages[0].required = true; }));
  EXPECT_FALSE(same_after([](Pipeline& p) { p.stages[0].enabled = false; }));
  EXPECT_FALSE(same_after([](Pipeline& p) { p.stages[0].blended = true; }));
  EXPECT_FALSE(same_after([](Pipeline& p) { p.stages[0].level = 1; }));
  EXPECT_FALSE(same_after([](Pipeline& p) { p.stages[0].settings["a"] = true; }));
  EXPECT_FALSE(same_after([](Pipeline& p) { p.stages.push_back(p.stages[0]); }));
  EXPECT_FALSE(same_after([](Pipeline& p) { p.measure = p.stages; }));
  EXPECT_FALSE(same_after([](Pipeline& p) { p.views.size = 64; }));
  EXPECT_FALSE(same_after([](Pipeline& p) { p.poses.clips = "Walk"; }));
  EXPECT_FALSE(same_after([](Pipeline& p) { p.subjects.subject = SubjectUnit::mesh; }));
  EXPECT_FALSE(same_after([](Pipeline& p) { p.frames.path = "around"; }));
  EXPECT_FALSE(same_after([](Pipeline& p) { p.output.compression = Compression::none; }));
  EXPECT_FALSE(same_after([](Pipeline& p) { p.seed = 1; }));
  EXPECT_FALSE(same_after([](Pipeline& p) { p.overdraw.reset(); }));
  EXPECT_FALSE(same_after([](Pipeline& p) { p.overdraw->use = "y"; }));
}

}  // namespace
}  // namespace foredraw::print_test
