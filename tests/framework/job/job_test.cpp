#include "support/meshes.h"
#include "support/program.h"

#include <foredraw/io/file_lender.h>
#include <foredraw/job/job.h>
#include <foredraw/job/pipelines.h>
#include <foredraw/technique/built_in_plugins.h>

namespace foredraw::job_test {
namespace {

class Jobs : public testing::InFolder {
 protected:
  Jobs() {
    add_built_in_plugins(registry_);
    testing::put(folder_ / "quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  Pipeline pipeline(const std::string& stages, const PipelineChanges& changes = {}) {
    auto line = parse_line(stages, diagnostics_);
    return changed(std::vector<NamedPipeline>{{stages, std::move(*line)}}, stages, changes, registry_, diagnostics_)
        .value();
  }

  Diagnostics diagnostics_;
  Registry registry_;
  const Executor executor_{1};
  const FileLender lender_;
  JobSetup setup_{.registry = registry_, .executor = executor_, .lender = &lender_};
};

TEST_F(Jobs, GoFromAFileToTheFilesOfItsOutputs) {
  Job job(setup_, JobKind::optimize, path("quad.obj"));
  ASSERT_TRUE(job.read() && job.plan(pipeline("weld, tipsify, vertex-fetch")) && job.run());
  ASSERT_TRUE(job.encode({{{}, path("out.glb")}, {"remap", path("remap.json")}}));
  EXPECT_EQ(job.status(), JobStatus::done);
  ASSERT_EQ(job.files().size(), 2u);
  EXPECT_EQ(job.report().command, "optimize");
  EXPECT_EQ(job.report().input.path, path("quad.obj"));
  EXPECT_EQ(job.report().output.path, path("out.glb"));
  EXPECT_EQ(job.report().output.bytes, job.files()[0].front().bytes.size());
  EXPECT_EQ(files(), std::vector<std::string>{"quad.obj"}) << "nothing is written";
}

TEST_F(Jobs, EncodeByTheOutputOfThePipelineAndWhatTheCallerChangesOfIt) {
  const auto made = [&](const PipelineChanges& changes) {
    Job job(setup_, JobKind::optimize, testing::project_file("benchmarks/corpus/static/spot.glb").string());
    EXPECT_TRUE(job.read() && job.plan(pipeline("tipsify", changes)) && job.run());
    EXPECT_TRUE(job.encode({{{}, path("out.glb")}}));
    const auto& bytes = job.files()[0].front().bytes;
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  };
  const std::string usual = made({}), draco = made({.output = {{"compression", "draco"}}});
  EXPECT_EQ(usual.find("KHR_draco"), std::string::npos);
  EXPECT_NE(draco.find("KHR_draco"), std::string::npos);
  EXPECT_EQ(made({.set = {"output.compression=draco"}}), draco);
}

TEST_F(Jobs, EndAtTheStepThatFailsAndSayWhy) {
  Job missing(setup_, JobKind::optimize, path("none.obj"));
  EXPECT_FALSE(missing.read());
  EXPECT_EQ(missing.status(), JobStatus::unreadable);
  EXPECT_EQ(missing.report().diagnostics.at(0).code, "no-such-file");

  Job wrong(setup_, JobKind::optimize, path("quad.obj"));
  EXPECT_TRUE(wrong.read());
  EXPECT_FALSE(wrong.plan(pipeline("tipsfy")));
  EXPECT_EQ(wrong.status(), JobStatus::mistake);
  EXPECT_TRUE(wrong.is_lost());

  Job unwritable(setup_, JobKind::optimize, path("quad.obj"));
  EXPECT_TRUE(unwritable.read() && unwritable.plan(pipeline("tipsify")) && unwritable.run());
  EXPECT_FALSE(unwritable.encode({{{}, path("out.fbx")}}));
  EXPECT_EQ(unwritable.status(), JobStatus::unwritable);
  EXPECT_TRUE(unwritable.report().stages.empty()) << "the report is that of a job without a result";

  std::atomic<bool> cancel = true;
  setup_.cancel = &cancel;
  Job cancelled(setup_, JobKind::optimize, path("quad.obj"));
  EXPECT_FALSE(cancelled.read());
  EXPECT_EQ(cancelled.status(), JobStatus::cancelled);
}

TEST_F(Jobs, AreRecalledFromTheCacheWithTheirFiles) {
  const Pipeline stages = pipeline("tipsify");
  setup_.input.files = std::make_shared<FilesRead>();
  const auto cache = ResultCache::opened(
      folder_ / "cache", stages, registry_, setup_.input, path("quad.obj"), [](const Diagnostics&) {}, diagnostics_);
  ASSERT_TRUE(cache);
  setup_.cache = cache.get();
  const std::vector<JobOutput> outputs{{{}, path("out.glb")}};
  Job first(setup_, JobKind::optimize, path("quad.obj"));
  EXPECT_FALSE(first.recall(outputs));
  ASSERT_TRUE(first.read() && first.plan(stages) && first.run() && first.encode(outputs));
  Job second(setup_, JobKind::optimize, path("quad.obj"));
  ASSERT_TRUE(second.recall(outputs));
  EXPECT_EQ(second.files().at(0).front().bytes, first.files().at(0).front().bytes);
  EXPECT_EQ(second.report_json(), first.report_json());
  EXPECT_EQ(second.files_read(), std::vector<std::filesystem::path>{path("quad.obj")});
}

TEST_F(Jobs, KnowHowTheirEvaluatorOfOverdrawLooks) {
  Job job(setup_, JobKind::measure, path("quad.obj"));
  ASSERT_TRUE(job.read());
  ASSERT_TRUE(job.plan(pipeline("", {.with = "vertex-cache, overdraw-raster(views=axes, faces=front)"})));
  EXPECT_EQ(job.overdraw_options().views, "axes");
  EXPECT_EQ(job.overdraw_options().faces, Faces::front);
  ASSERT_TRUE(job.plan(pipeline("", {.with = "vertex-cache"})));
  EXPECT_EQ(job.overdraw_options().views, OverdrawOptions().views);
}

}  // namespace
}  // namespace foredraw::job_test
