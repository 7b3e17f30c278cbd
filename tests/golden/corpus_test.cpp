// The corpus through @default: the bytes that come out are the ones that are written down here, at any thread count and
// from either compiler, and every model is cheaper to draw or as it was.

#include "corpus_run.h"
#include "rows.h"
#include "support/meshes.h"

#include <fmt/format.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace foredraw::golden_corpus_test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> corpus() {
  const fs::path root = testing::project_file("benchmarks/corpus");
  std::vector<std::string> models;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const std::string kind = entry.path().extension().string();
    if (kind == ".glb" || kind == ".gltf") models.push_back(fs::relative(entry.path(), root).generic_string());
  }
  std::ranges::sort(models);
  return models;
}

testing::GoldenRows golden_rows() {
  return {"corpus.tsv",
          "# model\tcontent hash of the output\tbefore and after: ACMR (FIFO 16), OVR (overdraw-raster, 100 views, "
          "16 poses of animations)\n"};
}

Stamp output_stamp(const Scene& scene, const std::string& model) {
  Diagnostics diagnostics;
  // Nothing is written. In the model's own folder the names of files beside it stay the same on every machine.
  const auto files = encode_gltf(scene, testing::project_file("benchmarks/corpus/" + model), diagnostics);
  if (!files) throw std::runtime_error(to_text(diagnostics));
  std::vector<Stamp> stamps;
  for (const OutputFile& file : *files) stamps.push_back(content_hash(file.bytes));
  return combine(stamps);
}

double value(const StateRecord& state, const char* plugin, const char* metric) {
  const Figure* figure = state.metrics.find(plugin, metric);
  return figure == nullptr ? 0 : figure->value();
}

class Corpus : public ::testing::TestWithParam<std::string> {};

TEST_P(Corpus, IsCheaperToDrawAndTheSameBytesAsEver) {
  const Scene scene = testing::read_model(testing::project_file("benchmarks/corpus/" + GetParam()));
  const Result result = testing::run_pipeline("@default", scene, 2);
  ASSERT_FALSE(result.failed);
  const Report& report = result.report;
  const double acmr[] = {value(report.before, "vertex-cache", "acmr"), value(report.after, "vertex-cache", "acmr")};
  const double ovr[] = {value(report.before, "overdraw-raster", "ratio"),
                        value(report.after, "overdraw-raster", "ratio")};
  EXPECT_LE(acmr[1], acmr[0]);
  EXPECT_LE(ovr[1], ovr[0]);

  const std::string row =
      fmt::format("{}\t{:.4f} {:.4f}\t{:.4f} {:.4f}", to_text(output_stamp(result.scene, GetParam())), acmr[0], acmr[1],
                  ovr[0], ovr[1]);
  golden_rows().expect(GetParam(), row);
}

TEST_P(Corpus, GivesTheSameBytesAtAnyThreadCount) {
  const Scene scene = testing::read_model(testing::project_file("benchmarks/corpus/" + GetParam()));
  const std::string stages = "weld, tipsify, linear-clusters, dot-rule, vertex-fetch";
  const Stamp one = output_stamp(testing::run_pipeline(stages, scene, 1).scene, GetParam());
  EXPECT_EQ(one, output_stamp(testing::run_pipeline(stages, scene, 5).scene, GetParam()));
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = fs::path(info.param).stem().string();
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Models, Corpus, ::testing::ValuesIn(corpus()), test_name);

}  // namespace
}  // namespace foredraw::golden_corpus_test
