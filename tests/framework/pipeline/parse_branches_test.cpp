#include <foredraw/pipeline/parse.h>

#include <gtest/gtest.h>

namespace foredraw::parse_branches_test {
namespace {

std::string refused_branches(std::string_view text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_file(text, "p.toml", diagnostics));
  return to_text(diagnostics);
}

std::vector<NamedPipeline> branches(std::string_view text) {
  Diagnostics diagnostics;
  auto branches = parse_branches(text, "p.toml", diagnostics);
  EXPECT_TRUE(branches) << to_text(diagnostics);
  return branches.value_or(std::vector<NamedPipeline>{});
}

std::vector<std::string> stages_of(const NamedPipeline& named) {
  std::vector<std::string> uses;
  for (const Stage& stage : named.pipeline.stages) uses.push_back(stage.use);
  return uses;
}

TEST(ParseBranches, EachRowGoesOnFromTheStagesInTheSequenceOfTheFile) {
  const auto made = branches(R"toml(pipeline = 1
stages = ["weld", "tipsify"]
measure = ["vertex-cache"]
[compare]
sorted = ["linear-clusters", "dot-rule(only='A')"]
as-it-is = []
by-layers = [{ use = "occlusion-order", k = 1 }]
)toml");
  ASSERT_EQ(made.size(), 3u);
  EXPECT_EQ(made[0].name, "p.toml: sorted");
  EXPECT_EQ(stages_of(made[0]), (std::vector<std::string>{"weld", "tipsify", "linear-clusters", "dot-rule"}));
  EXPECT_EQ(made[0].pipeline.stages[3].where.line, 5);
  EXPECT_EQ(made[0].pipeline.stages[3].where.inside, "compare.sorted[1]");
  EXPECT_EQ(made[1].name, "p.toml: as-it-is");
  EXPECT_EQ(stages_of(made[1]), (std::vector<std::string>{"weld", "tipsify"}));
  EXPECT_EQ(made[2].name, "p.toml: by-layers");
  EXPECT_EQ(stages_of(made[2]), (std::vector<std::string>{"weld", "tipsify", "occlusion-order"}));
  for (const NamedPipeline& branch : made) EXPECT_EQ(branch.pipeline.measure.size(), 1u);
}

TEST(ParseBranches, AFileWithoutThemIsOne) {
  const auto made = branches("pipeline = 1\nstages = [\"weld\"]\n");
  ASSERT_EQ(made.size(), 1u);
  EXPECT_EQ(made[0].name, "p.toml");
  // On one line too.
  EXPECT_EQ(branches("pipeline = 1\ncompare = { b = ['weld'], a = [] }\n")[0].name, "p.toml: b");
}

TEST(ParseBranches, WhatIsWrongInThemIsTold) {
  EXPECT_EQ(refused_branches("pipeline = 1\ncompare = {}\n"),
            "p.toml:2:11: error: compare: 'compare' has no pipelines\n"
            "    hint: add rows such as sorted = [\"linear-clusters\", \"dot-rule\"]\n");
  EXPECT_EQ(refused_branches("pipeline = 1\ncompare = 3\n"),
            "p.toml:2:11: error: 'compare' must be a table, not a whole number\n    hint: begin it with [compare]\n");
  EXPECT_EQ(refused_branches("pipeline = 1\n[compare]\na = 3\n"),
            "p.toml:3:5: error: 'compare.a' must be a list, not a whole number\n    hint: write a = [ ... ]\n");
  EXPECT_EQ(refused_branches("pipeline = 1\n[compare]\na = []\nb = []\n"),
            "p.toml: error: compare: the file has 2 pipelines, but this command runs one\n"
            "    hint: foredraw compare runs them side by side\n");
}

}  // namespace
}  // namespace foredraw::parse_branches_test
