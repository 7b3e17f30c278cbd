// Scenes and images that options name, from the pipeline's text to the technique.

#include "likeness.h"
#include "support/image_builder.h"
#include "support/meshes.h"
#include "support/program.h"

#include <foredraw/io/file_lender.h>
#include <foredraw/io/image/images.h>
#include <foredraw/io/scene_file.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/platform/files.h>
#include <foredraw/technique/registry.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <atomic>
#include <thread>

namespace foredraw::lending_test {
namespace {

namespace fs = std::filesystem;

const Registry& registry() {
  static const Registry all = [] {
    Registry made;
    made.add(testing::likeness_plugin());
    return made;
  }();
  return all;
}

Pipeline measuring(const std::string& evaluator) {
  Diagnostics diagnostics;
  Pipeline pipeline;
  pipeline.measure = parse_stages(evaluator, "test", diagnostics).value();
  return pipeline;
}

double figure(const Result& result, const std::string& metric) {
  return result.report.after.metrics.all().at("likeness").at(metric).numerator;
}

/// A host that has its scenes in memory, and counts how often it is asked.
class InMemory final : public Lender {
 public:
  std::optional<Loan<Scene>> scene(const std::string& path, Diagnostics& diagnostics) const override {
    ++asked;
    if (path == "high")
      return Loan<Scene>{std::make_shared<const Scene>(testing::scene_of(testing::grid(1, 1))), 7, {}};
    diagnostics.error({.file = path}, "unknown", "is not in memory");
    return std::nullopt;
  }
  std::optional<Loan<Image>> image(const std::string&, Diagnostics&) const override { return std::nullopt; }

  mutable std::atomic<int> asked = 0;
};

TEST(Lending, AHostMayLendWhatItHasInMemory) {
  const InMemory host;
  const Scene scene = testing::scene_of(testing::grid(4, 4));
  Diagnostics diagnostics;
  const auto planned =
      plan(measuring("likeness(reference=high), likeness(reference=high)"), registry(), scene, diagnostics, &host);
  ASSERT_TRUE(planned) << to_text(diagnostics);
  EXPECT_EQ(host.asked, 1);
  const Executor executor(2);
  const auto figure_of_a_run = [&] {
    Analyses analyses;
    return figure(measure(*planned, scene, {executor, analyses}), "triangles-more");
  };
  double at_once = 0;
  std::thread other([&] { at_once = figure_of_a_run(); });
  EXPECT_EQ(figure_of_a_run(), 30);
  other.join();
  EXPECT_EQ(at_once, 30);
}

TEST(Lending, APlanRefusesWhatCanNotBeLent) {
  const Scene scene = testing::scene_of(testing::grid(1, 1));
  const auto complaint = [&](const std::string& evaluator, const Lender* lender) {
    Diagnostics diagnostics;
    EXPECT_FALSE(plan(measuring(evaluator), registry(), scene, diagnostics, lender));
    return to_text(diagnostics);
  };
  const InMemory host;
  const std::string unread = complaint("likeness(reference=low)", &host);
  EXPECT_NE(unread.find("test:1:20: error: 'reference' of 'likeness': low cannot be read"), std::string::npos)
      << unread;
  EXPECT_NE(unread.find("low: error: is not in memory"), std::string::npos) << unread;
  EXPECT_NE(complaint("likeness(reference=high)", nullptr).find("cannot read files that options name"),
            std::string::npos);
  EXPECT_NE(complaint("likeness(reference=3)", &host).find("must be the path of a scene, not 3"), std::string::npos);
  EXPECT_NE(complaint("likeness(picture=\"\")", &host).find("must be the path of an image, not \"\""),
            std::string::npos);
}

TEST(Lending, ARunLendsNothingThatNoPlanBorrowed) {
  testing::RunFixture fixture;
  EXPECT_THROW(fixture.run.scene({"high"}), std::invalid_argument);
  EXPECT_THROW(fixture.run.image({}), std::invalid_argument);
}

class LendingFiles : public testing::InFolder {
 protected:
  void put_scene(const std::string& name, const Scene& scene) const {
    Diagnostics diagnostics;
    const auto files = encode_scene(scene, (folder_ / name).string(), diagnostics);
    ASSERT_TRUE(files && write_scene(*files, diagnostics)) << to_text(diagnostics);
  }
  void put_bytes(const std::string& name, const std::vector<std::byte>& bytes) const {
    testing::put(folder_ / name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
};

TEST_F(LendingFiles, AFileIsReadOnceAndTheSameStampIsTheSameContent) {
  put_scene("a.glb", testing::scene_of(testing::grid(2, 2)));
  fs::copy_file(folder_ / "a.glb", folder_ / "b.glb");
  put_bytes("p.png", testing::png_of({2, 1, 1, 8}, {7, 9}));
  const FileLender lender;
  Diagnostics diagnostics;
  const auto a = lender.scene((folder_ / "a.glb").string(), diagnostics);
  const auto b = lender.scene((folder_ / "b.glb").string(), diagnostics);
  const auto again = lender.scene((folder_ / "a.glb").string(), diagnostics);
  const auto image = lender.image((folder_ / "p.png").string(), diagnostics);
  ASSERT_TRUE(a && b && again && image) << to_text(diagnostics);
  EXPECT_EQ(a->content, again->content);
  EXPECT_EQ(a->stamp, b->stamp);
  EXPECT_EQ(a->bytes, fs::file_size(folder_ / "a.glb"));
  EXPECT_EQ(image->content->facts->width, 2u);
}

TEST_F(LendingFiles, TheStampIsOfFilesBesideToo) {
  put_scene("a.gltf", testing::scene_of(testing::grid(2, 2)));
  Diagnostics diagnostics;
  const auto before = FileLender().scene((folder_ / "a.gltf").string(), diagnostics);
  std::string buffer = testing::content(folder_ / "a.bin");
  buffer[4] ^= 1;  // of a position
  testing::put(folder_ / "a.bin", buffer);
  const auto after = FileLender().scene((folder_ / "a.gltf").string(), diagnostics);
  ASSERT_TRUE(before && after) << to_text(diagnostics);
  EXPECT_NE(before->stamp, after->stamp);
}

TEST_F(LendingFiles, TheProgramReadsThemFromTheFolderOfThePipelineAndSaysWhatItRead) {
  fs::create_directories(folder_ / "tools");
  put_scene("in.glb", testing::scene_of(testing::grid(4, 4)));
  put_scene("tools/high.glb", testing::scene_of(testing::grid(1, 1)));
  put_bytes("tools/p.png", testing::png_of({2, 1, 1, 8}, {7, 9}));
  testing::put(folder_ / "tools/views.txt", "direction 0 0 1\n");
  testing::put(folder_ / "tools/p.toml",
               "pipeline = 1\nstages = []\n"
               "measure = [{ use = \"likeness\", reference = \"high.glb\", picture = \"p.png\" },\n"
               "           \"overdraw-raster(views='views.txt')\"]\n[views]\nviews = \"views.txt\"\n");
  const auto made = testing::run_program(folder_, "optimize in.glb -o out.glb -p tools/p.toml --json");
  ASSERT_EQ(made.code, 0) << made.err;
  const auto report = nlohmann::json::parse(made.out);
  EXPECT_EQ(report["totals"]["metrics"]["likeness"]["triangles-more"]["value"], 30);
  EXPECT_EQ(report["totals"]["metrics"]["likeness"]["texels"]["value"], 2);
  ASSERT_EQ(report["named"].size(), 2u);
  EXPECT_EQ(report["named"][0]["path"], "tools/high.glb");
  EXPECT_EQ(report["named"][0]["hash"].get<std::string>().size(), 32u);
  EXPECT_EQ(report["named"][1]["path"], "tools/p.png");

  // What the record says can be run again from here.
  testing::put(folder_ / "again.toml", report["pipeline"]);
  EXPECT_EQ(testing::run_program(folder_, "plan in.glb -p again.toml").code, 0);
  // A path of the command line counts from here.
  const std::string set = "optimize in.glb -o out.glb -p weld --with likeness --set likeness.reference=";
  EXPECT_EQ(testing::run_program(folder_, set + "tools/high.glb").code, 0);
  const auto missing = testing::run_program(folder_, set + "high.glb");
  EXPECT_EQ(missing.code, 1);
  EXPECT_NE(missing.err.find("high.glb: error: there is no such file"), std::string::npos) << missing.err;
  EXPECT_EQ(testing::run_program(folder_, "measure in.glb --with 'likeness(picture=in.glb)'").code, 1);
  EXPECT_EQ(testing::run_program(folder_, "measure in.glb --with 'likeness(reference=-)'").code, 1);
}

}  // namespace
}  // namespace foredraw::lending_test
