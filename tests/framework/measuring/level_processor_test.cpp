#include <foredraw/measuring/level_processor.h>

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

namespace foredraw::level_processor_test {
namespace {

constexpr std::uint32_t side = 8;

/// A cloth of squares with one vertex, of those that coarser levels leave out, pulled up by 1.
Draw cloth(const std::string& name) {
  testing::TestMesh mesh = testing::grid(side, side);
  mesh.positions[3 * (side + 1) + 3].z = 1;
  return testing::draw_of(mesh, name);
}

/// Every `step`th row and column of the cloth, of the same vertices.
MadeLevel coarser(const DrawView& draw, std::uint32_t step, double claim, std::optional<double> rms = {}) {
  std::vector<std::uint32_t> indices;
  for (std::uint32_t row = 0; row < side; row += step) {
    for (std::uint32_t column = 0; column < side; column += step) {
      const std::uint32_t a = row * (side + 1) + column, b = a + step;
      const std::uint32_t c = a + step * (side + 1), d = c + step;
      indices.insert(indices.end(), {a, b, c, c, b, d});
    }
  }
  return {draw.draw().full().vertices, Shared<std::uint32_t>(std::move(indices)), claim, rms};
}

class Maker final : public LevelMaker {
 public:
  using Answer = std::function<std::vector<MadeLevel>(const DrawView&)>;
  explicit Maker(Answer answer) : answer_(std::move(answer)) {}

  SubjectLevels levels(const SubjectView& view, Run& run) const override {
    run.attach(Chart{view.subject.name, "", "level", "", "", {{"a", {1}}}, {}});
    SubjectLevels levels;
    for (const DrawId id : view.draws) levels.push_back(answer_({view.scene, id}));
    return levels;
  }

 private:
  Answer answer_;
};

class LevelProcessorTest : public ::testing::Test {
 protected:
  std::vector<DrawId> process(Maker::Answer answer) {
    return level_processor(std::make_unique<const Maker>(std::move(answer)))->process(scene_, {0, 1}, fixture_.run);
  }

  std::vector<std::string> notes(const std::string& code) const {
    std::vector<std::string> found;
    for (const Note& note : fixture_.findings.notes) {
      if (note.code == code) found.push_back(note.message);
    }
    return found;
  }

  testing::RunFixture fixture_;
  Scene scene_ = testing::scene_of({cloth("Flag"), cloth("Sail")});
};

TEST_F(LevelProcessorTest, PutsLevelsBehindFullDetailAndMeasuresThem) {
  const auto changed = process([](const DrawView& draw) {
    return std::vector{coarser(draw, 2, 1), coarser(draw, 4, 1, 0.3)};
  });
  EXPECT_EQ(changed, (std::vector<DrawId>{0, 1}));
  for (const Draw& draw : scene_.draws) {
    ASSERT_EQ(draw.levels.size(), 3u);
    EXPECT_EQ(draw.levels[1].vertices, draw.full().vertices);
    EXPECT_EQ(draw.levels[2].stream().triangle_count(), 8u);
    EXPECT_GE(draw.levels[2].error, 1);
    EXPECT_LT(draw.levels[2].error, 1.03f);
  }
  EXPECT_TRUE(notes("error-claim").empty());
  ASSERT_EQ(fixture_.findings.measured.size(), 12u);
  EXPECT_EQ(fixture_.findings.measured[0].metric, "error.largest");
  EXPECT_GE(fixture_.findings.measured[0].numerator, 1);
  EXPECT_LT(fixture_.findings.measured[0].numerator, 1.03);
  EXPECT_EQ(fixture_.findings.measured[1].metric, "error.found");
  EXPECT_EQ(fixture_.findings.measured[1].numerator, 1);
  EXPECT_EQ(fixture_.findings.measured[3].about, (About{.draw = 0, .level = 2}));
  EXPECT_GT(fixture_.findings.measured[2].numerator, 0);
}

TEST_F(LevelProcessorTest, SaysWhereAClaimDoesNotHold) {
  process([](const DrawView& draw) { return std::vector{coarser(draw, 2, 0.25, 0.001)}; });
  ASSERT_EQ(notes("error-claim").size(), 4u);
  EXPECT_EQ(notes("error-claim")[0], "its claimed distance from full detail is 0.25, but the measured one is 1");
  EXPECT_GE(scene_.draws[0].levels[1].error, 1) << "what is proved stands";
  EXPECT_LT(scene_.draws[0].levels[1].error, 1.03f);
}

TEST_F(LevelProcessorTest, AnAnswerThatIsNoneIsRefused) {
  const auto refused = [&](const std::function<void(MadeLevel&)>& damage) {
    try {
      process([&](const DrawView& draw) {
        MadeLevel level = coarser(draw, 2, 1);
        damage(level);
        return std::vector{level};
      });
    } catch (const std::runtime_error& mistake) {
      return std::string(mistake.what());
    }
    return std::string("taken");
  };
  const auto indices = [](std::vector<std::uint32_t> list) { return Shared<std::uint32_t>(std::move(list)); };
  EXPECT_NE(refused([](MadeLevel& l) { l.vertices = nullptr; }).find("draws nothing"), std::string::npos);
  EXPECT_NE(refused([](MadeLevel& l) { l.indices = {}; }).find("draws nothing"), std::string::npos);
  EXPECT_NE(refused([&](MadeLevel& l) { l.indices = indices({0, 1}); }).find("triangles"), std::string::npos);
  EXPECT_NE(refused([&](MadeLevel& l) { l.indices = indices({0, 1, 99}); }).find("does not exist"), std::string::npos);
  EXPECT_NE(refused([](MadeLevel& l) { l.largest = -1; }).find("not a distance"), std::string::npos);
  EXPECT_NE(refused([](MadeLevel& l) {
              VertexStreams streams = *l.vertices;
              streams.base.push_back({"_MORE", Format{}, streams.base[0].bytes});
              l.vertices = std::make_shared<const VertexStreams>(streams);
            }).find("different attributes"),
            std::string::npos);
}

TEST_F(LevelProcessorTest, WhatHasLevelsKeepsThem) {
  scene_.draws[0].levels.push_back(scene_.draws[0].full());
  const auto changed = process([](const DrawView& draw) { return std::vector{coarser(draw, 2, 1)}; });
  EXPECT_EQ(changed, std::vector<DrawId>{1});
  EXPECT_EQ(scene_.draws[0].levels.size(), 2u);
  EXPECT_EQ(scene_.draws[0].levels[1].stream().triangle_count(), 2u * side * side);
  EXPECT_EQ(notes("has-levels").size(), 1u);
}

TEST_F(LevelProcessorTest, NoLevelsLeaveTheSceneAsItIs) {
  EXPECT_TRUE(process([](const DrawView&) { return std::vector<MadeLevel>{}; }).empty());
  EXPECT_TRUE(fixture_.run.keeps());
}

TEST_F(LevelProcessorTest, WhatMakersAttachIsOfTheirSubjects) {
  process([](const DrawView& draw) { return std::vector{coarser(draw, 2, 1)}; });
  const std::vector<Attached>& attached = fixture_.findings.attached;
  ASSERT_EQ(attached.size(), 2u);
  for (std::uint32_t i = 0; i < 2; ++i) {
    EXPECT_EQ(attached[i].about.subject, i);
    EXPECT_EQ(name_of(*attached[i].content), subjects_of(scene_)[i].name);
  }
}

}  // namespace
}  // namespace foredraw::level_processor_test
