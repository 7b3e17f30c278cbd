// What techniques attach reaches the record: by stage, before and after, with the names of what it is about.
#include <foredraw/pipeline/runner.h>

#include "runs_stages.h"

namespace foredraw::runner_attachments_test {
namespace {

Film film_of(const std::string& name, std::size_t frames) {
  Film film{name, "", 1, 1, {}};
  for (std::size_t i = 0; i < frames; ++i) film.frames.push_back({static_cast<std::uint8_t>(i), 0, 0});
  return film;
}

/// Attaches a film with a frame for each draw of the scene.
struct Watch final : Evaluator {
  void evaluate(const Scene& scene, Run& run) const override { run.attach(film_of("draws", scene.draws.size())); }
};

/// Attaches a film with a frame for each triangle of the draw, but none to the draw "Bad", where it fails.
struct WatchDraws final : DrawEvaluator {
  void evaluate(const DrawView& draw, Run& run) const override {
    run.attach(film_of("triangles", draw.triangle_count()));
    if (draw.draw().name == "Bad") run.attach(film_of("triangles", 1));
  }
};

struct WatchSubject final : Evaluator {
  void evaluate(const Scene&, Run& run) const override {
    run.attach_at({.draw = {}, .subject = 1}, film_of("subject", 1));
    run.attach_at({.draw = {}, .subject = 77}, film_of("nobody", 1));
  }
};

/// A processor that attaches pictures of what it adds.
struct AddAndShow final : Processor {
  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    Draw copy = scene.draws[draws.front()];
    copy.name = "Copy";
    scene.meshes.front().draws.push_back(static_cast<DrawId>(scene.draws.size()));
    scene.draws.push_back(std::move(copy));
    run.attach_at({.draw = static_cast<DrawId>(scene.draws.size() - 1), .subject = {}}, film_of("added", 1));
    return draws;
  }
};

class RunnerAttachments : public testing::RunsStages {
 protected:
  RunnerAttachments() {
    registry_.add(testing::plugin_of<Watch>(Kind::evaluator, {.name = "watch"}));
    registry_.add(testing::plugin_of<WatchDraws>(Kind::evaluator, {.name = "watch-draws"}));
    registry_.add(testing::plugin_of<WatchSubject>(Kind::evaluator, {.name = "watch-subject"}));
    registry_.add(testing::plugin_of<AddAndShow>(Kind::processor, {.name = "add-and-show"}));
  }

  Plan plan(const std::string& stages, const std::string& measure) const { return planned(stages, scene_, measure); }
  Report optimized(const std::string& stages, const std::string& measure) const {
    return run(stages, scene_, measure).report;
  }

  Executor executor_{2};
  Scene scene_ = testing::scene_of({testing::draw_of(testing::grid(2, 1), "A"), testing::draw_of(testing::grid(1, 1))});
};

/// "place: name of so many frames"
std::vector<std::string> told(const std::vector<AttachmentRecord>& attachments) {
  std::vector<std::string> lines;
  for (const AttachmentRecord& attachment : attachments) {
    lines.push_back(attachment.about + ": " + name_of(*attachment.content) + " of " +
                    std::to_string(frames_of(*attachment.content)));
  }
  return lines;
}

using Lines = std::vector<std::string>;

TEST_F(RunnerAttachments, AreToldOfBeforeAndAfter) {
  const Report report = optimized("add-draw", "count-draws, watch");
  ASSERT_EQ(report.measures.size(), 2u);
  EXPECT_TRUE(report.measures[0].attachments.empty());
  EXPECT_EQ(told(report.measures[1].attachments_before), Lines{": draws of 2"});
  EXPECT_EQ(told(report.measures[1].attachments), Lines{": draws of 3"});
}

TEST_F(RunnerAttachments, WithoutStagesHaveNoBefore) {
  Analyses analyses;
  const Report report = foredraw::measure(plan("", "watch"), scene_, {executor_, analyses}).report;
  EXPECT_TRUE(report.measures[0].attachments_before.empty());
  EXPECT_EQ(told(report.measures[0].attachments), Lines{": draws of 2"});
}

TEST_F(RunnerAttachments, OfDrawsHaveTheirNamesInTheirSequence) {
  for (std::uint32_t i = 0; i < 20; ++i) {
    scene_.draws.push_back(testing::draw_of(testing::grid(i + 1, 1), "D" + std::to_string(i)));
    scene_.meshes.front().draws.push_back(static_cast<DrawId>(scene_.draws.size() - 1));
  }
  const Report report = optimized("reverse-draw", "watch-draws");
  Lines expected{"A: triangles of 4", "mesh: triangles of 2"};
  for (std::uint32_t i = 0; i < 20; ++i) {
    expected.push_back("D" + std::to_string(i) + ": triangles of " + std::to_string(2 * (i + 1)));
  }
  EXPECT_EQ(told(report.measures[0].attachments), expected);
}

TEST_F(RunnerAttachments, OfSubjectsHaveTheirNames) {
  const Report report = optimized("reverse-draw", "watch-subject");
  const std::vector<Subject> subjects = subjects_of(scene_);
  ASSERT_EQ(subjects.size(), 2u);
  EXPECT_EQ(told(report.measures[0].attachments), (Lines{subjects[1].name + ": subject of 1", ": nobody of 1"}));
}

TEST_F(RunnerAttachments, OfAStageAreItsOwn) {
  const Report report = optimized("add-and-show", "count-draws");
  EXPECT_EQ(told(report.stages[0].attachments), Lines{"Copy: added of 1"});
  EXPECT_TRUE(report.stages[0].attachments_before.empty());
}

TEST_F(RunnerAttachments, ThatAreWrongAreAFailureWithoutAttachments) {
  scene_.draws[0].name = "Bad";
  const Result result = run("reverse-draw", scene_, "watch-draws");
  EXPECT_TRUE(result.failed);
  EXPECT_EQ(told(result.report.measures[0].attachments), Lines{"mesh: triangles of 2"});
  ASSERT_FALSE(result.report.diagnostics.empty());
  EXPECT_NE(result.report.diagnostics[0].message.find("its attachment 'triangles' is attached twice"),
            std::string::npos);
}

/// Films are large: branches share those of the input, and those of the stages that they begin with alike.
TEST_F(RunnerAttachments, ThatBranchesHaveAlikeAreHeldOnce) {
  const std::vector<Plan> plans{plan("add-and-show, pairs", "watch"), plan("add-and-show, reverse-draw", "watch")};
  Analyses analyses;
  const std::vector<Result> results = foredraw::compare(plans, scene_, 1, {executor_, analyses});
  const Report &one = results[0].report, &other = results[1].report;
  ASSERT_EQ(one.measures[0].attachments_before.size(), 1u);
  EXPECT_EQ(one.measures[0].attachments_before[0].content, other.measures[0].attachments_before[0].content);
  EXPECT_EQ(one.stages[0].attachments[0].content, other.stages[0].attachments[0].content);
  EXPECT_NE(one.measures[0].attachments[0].content, other.measures[0].attachments[0].content);
  EXPECT_EQ(told(other.measures[0].attachments), Lines{": draws of 3"});
}

}  // namespace
}  // namespace foredraw::runner_attachments_test
