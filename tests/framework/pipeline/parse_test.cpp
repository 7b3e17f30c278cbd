#include <foredraw/pipeline/parse.h>

#include <gtest/gtest.h>

#include <fstream>

#include "support/meshes.h"

namespace foredraw::parse_test {
namespace {

constexpr std::string_view props = R"toml(pipeline = 1
about    = "Static props, desktop"
seed     = 7
stages = [
  "weld",
  { use = "tipsify", cache-size = 16 },
  { use = "linear-clusters", growth = 1.05, enabled = false },
  "dot-rule(only='Rock_*', required=true)",
  { use = "vertex-fetch", blended = true, note = "by \"hand\"" },
]
measure = ["vertex-cache", { use = "overdraw-raster", views = "random", count = 300, seed = 7, distance = 3 }]
[views]
views = 42
size = 512
[services]
overdraw = { use = "overdraw-raster", faces = "front" }
)toml";

Pipeline parsed(std::string_view text) {
  Diagnostics diagnostics;
  auto pipeline = parse_file(text, "props.toml", diagnostics);
  EXPECT_TRUE(pipeline) << to_text(diagnostics);
  EXPECT_TRUE(diagnostics.empty());
  return pipeline.value_or(Pipeline{});
}

Pipeline parsed_line(std::string_view text) {
  Diagnostics diagnostics;
  auto pipeline = parse_line(text, diagnostics);
  EXPECT_TRUE(pipeline) << to_text(diagnostics);
  EXPECT_TRUE(diagnostics.empty());
  return pipeline.value_or(Pipeline{});
}

std::string refused(std::string_view text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_file(text, "p.toml", diagnostics));
  EXPECT_TRUE(diagnostics.has_errors());
  return to_text(diagnostics);
}

std::string refused_line(std::string_view text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_line(text, diagnostics)) << text;
  EXPECT_TRUE(diagnostics.has_errors());
  return to_text(diagnostics);
}

TEST(ParseFile, ReadsAllThereIs) {
  const Pipeline pipeline = parsed(props);
  EXPECT_EQ(pipeline.about, "Static props, desktop");
  EXPECT_EQ(pipeline.seed, 7);
  ASSERT_EQ(pipeline.stages.size(), 5u);
  EXPECT_EQ(pipeline.stages[0].use, "weld");
  EXPECT_TRUE(pipeline.stages[0].settings.empty());
  EXPECT_EQ(pipeline.stages[1].settings, (Settings{{"cache-size", std::int64_t{16}}}));
  EXPECT_EQ(pipeline.stages[2].settings, (Settings{{"growth", 1.05}}));
  EXPECT_FALSE(pipeline.stages[2].enabled);
  EXPECT_EQ(pipeline.stages[3].use, "dot-rule");
  EXPECT_EQ(pipeline.stages[3].only, "Rock_*");
  EXPECT_TRUE(pipeline.stages[3].required);
  EXPECT_TRUE(pipeline.stages[4].blended);
  EXPECT_EQ(pipeline.stages[4].settings, (Settings{{"note", std::string("by \"hand\"")}}));
  ASSERT_EQ(pipeline.measure.size(), 2u);
  EXPECT_EQ(pipeline.measure[1].settings.size(), 4u);
  EXPECT_EQ(pipeline.views.views, "42");
  EXPECT_EQ(pipeline.views.size, 512);
  ASSERT_TRUE(pipeline.overdraw);
  EXPECT_EQ(pipeline.overdraw->settings, (Settings{{"faces", std::string("front")}}));
}

TEST(ParseFile, ReadsPoses) {
  const Pipeline pipeline = parsed("pipeline = 1\n[poses]\nposes = 'all'\nclips = 'Walk*'\nrate = 30\n");
  EXPECT_EQ(pipeline.poses, (PoseSet{.poses = "all", .clips = "Walk*", .rate = 30}));
  EXPECT_EQ(parsed("pipeline = 1\n[poses]\nposes = 64\n").poses, PoseSet{.poses = "64"});
  EXPECT_EQ(refused("pipeline = 1\n[poses]\nrate = 30\nmoments = '1'\n"),
            "p.toml:2:1: error: poses: rate and moments both choose the poses; leave one of them out\n");
}

TEST(ParseFile, ReadsWhatIsSeenAsOne) {
  EXPECT_EQ(parsed("pipeline = 1\n").subjects.subject, SubjectUnit::character);
  EXPECT_EQ(parsed("pipeline = 1\n[subjects]\nsubject = 'scene'\n").subjects.subject, SubjectUnit::scene);
  EXPECT_EQ(refused("pipeline = 1\n[subjects]\nsubject = 'helmet'\n"),
            "p.toml:3:11: error: subjects: 'subject' is helmet, but must be one of mesh, character, scene\n");
}

TEST(ParseFile, ReadsHowGltfIsWritten) {
  EXPECT_EQ(parsed("pipeline = 1\n").output, OutputSettings{});
  EXPECT_EQ(parsed("pipeline = 1\n[output]\ncompression = 'khr-meshopt'\ncorners = 'turn'\nlevels = 'msft-lod'\n"
                   "products = 'none'\n")
                .output,
            (OutputSettings{Compression::khr, true, LevelsAs::lod_nodes, false}));
  EXPECT_EQ(refused("pipeline = 1\n[output]\ncorners = 'cut'\n"),
            "p.toml:3:11: error: output: 'corners' is cut, but must be one of keep, turn\n");
  EXPECT_EQ(refused("pipeline = 1\n[output]\ncorner = 'turn'\n"),
            "p.toml:3:1: error: output: there is no 'corner' here\n    hint: did you mean 'corners'?\n");
}

TEST(ParseFile, RemembersWhereThingsStand) {
  const Pipeline pipeline = parsed(props);
  const Stage& tipsify = pipeline.stages[1];
  EXPECT_EQ(tipsify.where.file, "props.toml");
  EXPECT_EQ(tipsify.where.line, 6);
  EXPECT_EQ(tipsify.where.column, 3);
  EXPECT_EQ(tipsify.where.inside, "stages[1]");
  EXPECT_EQ(tipsify.option_where.at("cache-size").line, 6);
  EXPECT_EQ(tipsify.option_where.at("cache-size").column, 35);
  EXPECT_EQ(pipeline.stages[3].where.line, 8);
  EXPECT_EQ(pipeline.stages[3].where.column, 4);  // within the quotes
  EXPECT_EQ(pipeline.measure[1].where.inside, "measure[1]");
  EXPECT_EQ(pipeline.overdraw->where.inside, "services.overdraw");
}

TEST(ParseFile, ListsCanBeWrittenAsTables) {
  const Pipeline pipeline =
      parsed("pipeline = 1\n[[stages]]\nuse = 'weld'\n[[stages]]\nuse = 'tipsify'\ncache-size = 24\n");
  EXPECT_EQ(print_line(pipeline), "weld, tipsify(cache-size=24)");
}

TEST(ParseFile, TellsEveryMistakeAtOnceFromTheTop) {
  EXPECT_EQ(refused(R"(abuot = "x"
seed = "seven"
stages = ["weld", 3, { cache-size = 16 }, { use = "dot-rule", required = 1, list = [1] }, "a, b", "a(b"]
measure = "vertex-cache"
[views]
veiws = "axes"
size = 1
[services]
overdraw = 2024-01-01
overdrew = "x"
)"),
            R"(p.toml:1:1: error: 'pipeline' is missing
    hint: add pipeline = 1 as its first line
p.toml:1:1: error: there is no 'abuot' here
    hint: did you mean 'about'?
p.toml:2:8: error: 'seed' must be a whole number, not "seven"
p.toml:3:19: error: stages[1]: a stage must be a string or a table, not a whole number
    hint: such as "weld" or { use = "tipsify", cache-size = 16 }
p.toml:3:22: error: stages[2]: the stage names no plugin
    hint: add use = "NAME"
p.toml:3:74: error: stages[3]: 'required' must be true or false, not 1
p.toml:3:84: error: stages[3]: 'list' must be a string, a number, true or false, not a list
p.toml:3:91: error: stages[4]: expected one stage, found 2
    hint: write each stage as a string of its own
p.toml:3:103: error: stages[5]: expected '=' after 'b', found the end
    hint: options are given as name=value
p.toml:4:11: error: 'measure' must be a list, not a string
    hint: write measure = [ ... ]
p.toml:6:1: error: views: there is no 'veiws' here
    hint: did you mean 'views'?
p.toml:7:8: error: views: 'size' is 1, but must be 16 to 4096 pixels
p.toml:9:12: error: services.overdraw: a stage must be a string or a table, not a date or time
    hint: such as "weld" or { use = "tipsify", cache-size = 16 }
p.toml:10:1: error: services: there is no 'overdrew' here
    hint: did you mean 'overdraw'?
)");
}

TEST(ParseFile, ChecksTheVersion) {
  EXPECT_NE(refused("pipeline = 2").find("p.toml:1:12: error: 'pipeline' is 2, but"), std::string::npos);
  EXPECT_NE(refused("pipeline = '1'").find("'pipeline' must be the format's version, 1, not a string"),
            std::string::npos);
}

TEST(ParseFile, ChecksTheViewsTogether) {
  EXPECT_EQ(refused("pipeline = 1\n[views]\ncount = 100\n"),
            "p.toml:2:1: error: views: an icosphere has 12, 42, 162, 642 or 2562 views, not 100\n");
}

TEST(ParseFile, TellsWhereItIsNoToml) {
  EXPECT_TRUE(refused("pipeline = 1\nstages = [\"weld\"").starts_with("p.toml:2:"));
  EXPECT_NE(refused("pipeline = 1\npipeline = 1").find("p.toml:2:"), std::string::npos);
  EXPECT_NE(refused("about = \"\xff\"").find("p.toml:1:"), std::string::npos);
}

TEST(ParseFile, ReadsEveryExampleOfTheDocuments) {
  std::ifstream page(testing::project_file("docs/reference/pipelines.md"));
  const std::string text((std::istreambuf_iterator<char>(page)), {});
  constexpr std::string_view begin = "```toml\n";
  int examples = 0;
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1)) {
    const std::size_t from = at + begin.size();
    Diagnostics diagnostics;
    EXPECT_TRUE(parse_branches(std::string_view(text).substr(from, text.find("```", from) - from), "page", diagnostics))
        << to_text(diagnostics);
    ++examples;
  }
  EXPECT_EQ(examples, 9);
}

TEST(ParseFile, StandsDeepNesting) {
  const auto repeated = [](std::string_view piece, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += piece;
    return text;
  };
  EXPECT_NE(refused("pipeline = 1\na" + repeated(".a", 4000) + " = 1").find("there is no 'a' here"), std::string::npos);
  EXPECT_NE(refused("pipeline = 1\na" + repeated(".a", 300000) + " = 1").find("dots"), std::string::npos);
  EXPECT_NE(refused("pipeline = 1\na = " + repeated("[", 300000)).find("p.toml:2:"), std::string::npos);
  EXPECT_NE(refused("pipeline = 1\na = " + repeated("{a=", 300000)).find("p.toml:2:"), std::string::npos);
}

TEST(ParseLine, ReadsStagesAndValues) {
  const Pipeline pipeline = parsed_line(
      " weld , tipsify( cache-size = 16, a=true, b=-1.5e3, c=Rock_*, d=\"x, \\\"y\\\"\\\\\\n\", e='\\', f=1e+20)"
      ",dot-rule(),x.y(only=inf?, blended=true)");
  ASSERT_EQ(pipeline.stages.size(), 4u);
  EXPECT_EQ(pipeline.stages[1].settings, (Settings{{"cache-size", std::int64_t{16}},
                                                   {"a", true},
                                                   {"b", -1500.0},
                                                   {"c", std::string("Rock_*")},
                                                   {"d", std::string("x, \"y\"\\\n")},
                                                   {"e", std::string("\\")},
                                                   {"f", 1e20}}));
  EXPECT_EQ(pipeline.stages[3].use, "x.y");
  EXPECT_EQ(pipeline.stages[3].only, "inf?");
  EXPECT_TRUE(pipeline.stages[3].blended);
  EXPECT_TRUE(parsed_line("").stages.empty());
  EXPECT_TRUE(parsed_line(" \t").stages.empty());
}

TEST(ParseLine, RemembersColumnsInCharacters) {
  const Pipeline pipeline = parsed_line("weld(only=\"Größe\"), tipsify(cache-size=16)");
  const Where where = pipeline.stages[1].option_where.at("cache-size");
  EXPECT_EQ(where.file, "pipeline");
  EXPECT_EQ(where.line, 1);
  EXPECT_EQ(where.column, 40);
  EXPECT_EQ(pipeline.stages[1].where.column, 21);
}

TEST(ParseLine, SaysWhatItExpected) {
  EXPECT_EQ(refused_line("weld, "), "pipeline:1:7: error: expected a stage, found the end\n");
  EXPECT_EQ(refused_line("weld tipsify"),
            "pipeline:1:6: error: expected ',' or the end, found 't'\n"
            "    hint: separate stages with commas, and put options in parentheses: name(option=value)\n");
  EXPECT_EQ(refused_line("tipsify(16)"),
            "pipeline:1:11: error: expected '=' after '16', found ')'\n    hint: options are given as name=value\n");
  EXPECT_EQ(refused_line("tipsify(cache-size=16"),
            "pipeline:1:22: error: expected ',' or ')', found the end\n    hint: close the options with )\n");
  EXPECT_EQ(refused_line("a(only=Gr\xc3\xb6\xc3\x9f"
                         "e)"),
            "pipeline:1:10: error: expected ',' or ')', found 'ö'\n    hint: put text with spaces or special "
            "characters in quotes\n");
  EXPECT_EQ(refused_line("a(b=1, b=2)"), "pipeline:1:8: error: 'b' is given twice\n    hint: leave one of them out\n");
  EXPECT_EQ(refused_line("a(b=\"c)"),
            "pipeline:1:5: error: the quoted text that begins here has no end\n    hint: close it with \"\n");
  EXPECT_NE(refused_line("a(b=\"\\q\")").find("pipeline:1:5: error: the quoted text that begins here cannot be read"),
            std::string::npos);
  EXPECT_NE(refused_line("a(b=\"\xff\")").find("cannot be read"), std::string::npos);
  EXPECT_NE(refused_line("a(b=\"c\\").find("has no end"), std::string::npos);
  EXPECT_NE(refused_line("\xff").find("expected a stage"), std::string::npos);
}

TEST(ParseLine, TellsEveryWrongReservedWord) {
  EXPECT_EQ(refused_line("a(only=42), b(required=yes)"),
            "pipeline:1:8: error: 'only' must be a string, not 42\n    hint: put it in quotes\n"
            "pipeline:1:24: error: 'required' must be true or false, not \"yes\"\n");
}

TEST(ParseStages, GoesByTheNameItIsGiven) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_stages("a,,b", "--with", diagnostics));
  EXPECT_EQ(to_text(diagnostics), "--with:1:3: error: expected a stage, found ','\n");
}

}  // namespace
}  // namespace foredraw::parse_test
