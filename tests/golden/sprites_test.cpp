// The particle textures of the corpus, trimmed: the frame lists that come out are the ones that are written down here,
// at any thread count and from either compiler, and no pixel that shows is lost.

#include "corpus_run.h"
#include "rows.h"
#include "support/meshes.h"

#include <benchmarks/particle_trim/particle_textures.h>
#include <foredraw/io/scene_file.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <gtest/gtest.h>

#include <array>
#include <filesystem>

namespace foredraw::sprites_test {
namespace {

namespace fs = std::filesystem;

/// How sprites are trimmed, and how it is measured whether they still show what they did.
struct Trimming {
  const char* stage;
  const char* measure;
};

constexpr std::array trimmings = {
    Trimming{"particle-trim(vertices=3, mip-levels=0)", "sprite-fill(mipmaps=false)"},
    Trimming{"particle-trim(vertices=4, mip-levels=0)", "sprite-fill(mipmaps=false)"},
    Trimming{"particle-trim(vertices=8, mip-levels=0)", "sprite-fill(mipmaps=false)"},
    Trimming{"particle-trim(vertices=8, mip-levels=2)", "sprite-fill"},  // down to a quarter of their size
};

testing::GoldenRows golden_rows() {
  std::string heading =
      "# texture\tfor each trimming: content hash of the frame list; sprite-fill: pixels that show, filled before and "
      "after\n# ";
  for (const Trimming& trimming : trimmings) heading += fmt::format("\t{}; {}", trimming.stage, trimming.measure);
  return {"sprites.tsv", heading + '\n'};
}

Result trimmed(const fs::path& sprites, const Trimming& trimming, int threads) {
  Diagnostics diagnostics;
  const auto file = read_scene(sprites.string(), diagnostics);
  if (!file) throw std::runtime_error(to_text(diagnostics));
  return testing::run_pipeline(trimming.stage, file->scene, threads, trimming.measure);
}

Stamp list_stamp(const Scene& scene, const fs::path& sprites) {
  Diagnostics diagnostics;
  // Nothing is written. Beside the image its name is the same on every machine.
  const fs::path list = sprites.parent_path() / "trimmed.json";
  const auto files = encode_scene(scene, list.string(), diagnostics);
  if (!files) throw std::runtime_error(to_text(diagnostics));
  return content_hash(files->front().bytes);
}

double count(const StateRecord& state, const char* metric) {
  const Figure* figure = state.metrics.find("sprite-fill", metric);
  return figure == nullptr ? -1 : figure->value();
}

class Sprites : public ::testing::TestWithParam<fs::path> {};

TEST_P(Sprites, ShowWhatTheyDidAndAreTheSamePolygonsAsEver) {
  std::vector<std::string> figures;
  for (const Trimming& trimming : trimmings) {
    const Result result = trimmed(GetParam(), trimming, 2);
    ASSERT_FALSE(result.failed);
    const StateRecord &before = result.report.before, &after = result.report.after;
    EXPECT_GT(count(before, "needed"), 0) << trimming.stage;
    // Where a sprite shows up to its frame's edge, a polygon's edge along it ends elsewhere than the quad's, and where
    // it is turned its ends are rounded elsewhere: single pixels there are another's.
    EXPECT_NEAR(count(after, "needed"), count(before, "needed"), 1e-5 * count(before, "needed")) << trimming.stage;
    EXPECT_LE(count(after, "filled"), count(before, "filled")) << trimming.stage;
    figures.push_back(fmt::format("{} {:.0f} {:.0f} {:.0f}", to_text(list_stamp(result.scene, GetParam())),
                                  count(before, "needed"), count(before, "filled"), count(after, "filled")));
  }
  golden_rows().expect(GetParam().stem().string(), fmt::format("{}", fmt::join(figures, "\t")));
}

TEST_P(Sprites, ShowExactlyWhatTheyDidWhileTheyAreUpright) {
  for (const Trimming& trimming : trimmings) {
    std::string measure = trimming.measure;
    measure = measure.ends_with(')') ? measure.substr(0, measure.size() - 1) + ", turns=1)" : measure + "(turns=1)";
    const Report report = trimmed(GetParam(), {trimming.stage, measure.c_str()}, 2).report;
    EXPECT_GT(count(report.before, "needed"), 0) << trimming.stage;
    EXPECT_EQ(count(report.after, "needed"), count(report.before, "needed")) << trimming.stage;
  }
}

TEST_P(Sprites, AreTheSamePolygonsAtAnyThreadCount) {
  EXPECT_EQ(list_stamp(trimmed(GetParam(), trimmings.back(), 1).scene, GetParam()),
            list_stamp(trimmed(GetParam(), trimmings.back(), 5).scene, GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Textures, Sprites, ::testing::ValuesIn(bench::particle_files()),
                         [](const ::testing::TestParamInfo<fs::path>& info) { return info.param.stem().string(); });

}  // namespace
}  // namespace foredraw::sprites_test
