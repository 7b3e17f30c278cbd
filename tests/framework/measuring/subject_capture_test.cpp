#include <foredraw/measuring/subject_capture.h>

#include "support/overdraw.h"

#include <gtest/gtest.h>

namespace foredraw::subject_capture_test {
namespace {

using Numbers = std::vector<std::uint32_t>;

/// Answers with what is there, or not at all.
class Captures final : public OverdrawService {
 public:
  explicit Captures(bool can_capture) : can_capture_(can_capture) {}
  OverdrawCounts draw(std::span<const RasterPart>, const Views&, Run&) const override { return {}; }
  std::optional<FragmentLayers> capture(std::span<const RasterPart> parts, const Views& views, Run& run,
                                        std::size_t) const override {
    if (!can_capture_) return std::nullopt;
    return fragment_layers(parts, views, run.executor);
  }

 private:
  bool can_capture_;
};

/// A hat above a head, each a draw of two squares one above the other. In the second clip the hat lies lower.
struct Character {
  Scene scene;
  Subject subject;
  Poses poses{{{0, 0, 1}, {0, 1, 1}, {1, 0, 2}, {0, 0.5, 1}}};

  Character() {
    std::vector<Draw> draws;
    for (const float z : {2.0f, 0.0f}) {
      draws.push_back(testing::draw_of(testing::joined(testing::quad(z), testing::quad(z + 1))));
    }
    scene = testing::scene_of(std::move(draws));
    scene.nodes.resize(2);
    scene.nodes[0].mesh = 0;
    scene.nodes[1].mesh = 1;
    scene.animations.resize(2);
    AnimationChannel channel;
    channel.node = 0;
    channel.times = Shared<float>({0});
    channel.values = Shared<float>({0, 0, -0.25f});
    scene.animations[1].channels.push_back(channel);
    subject = {"character", {{0, 0}, {1, 1}}};
  }
};

Clusters squares(const Draw&) { return {{0, 2, 4}}; }

class CapturedSubjects : public ::testing::Test {
 protected:
  SubjectCapture captured(const std::vector<DrawId>& draws, bool can_capture = true) {
    Captures service(can_capture);
    foredraw::Run run{fixture_.analyses, fixture_.executor, fixture_.findings, views_, character_.poses, &service};
    run.cancel = &cancel_;
    return capture_subject({character_.scene, character_.subject, draws}, character_.poses, squares, run,
                           [&](const SubjectLayers& seen, const SubjectGeometry& drawn) {
                             nodes_at_looks_.push_back(seen.layers.views.size());
                             heights_.push_back(drawn.positions[0][0].z);
                           });
  }

  Character character_;
  testing::RunFixture fixture_;
  Views views_ = testing::views_of({{0, 0, 1}, {0, 0, -1}, {1, 0, 0}});
  std::atomic<bool> cancel_{false};
  std::vector<std::size_t> nodes_at_looks_;
  std::vector<float> heights_;
};

TEST_F(CapturedSubjects, poses_that_look_alike_share_their_nodes) {
  const SubjectCapture both = captured({0, 1});
  EXPECT_EQ(both.look, (std::vector<std::vector<std::size_t>>{{0, 1, 2}, {0, 1, 2}, {3, 4, 5}, {0, 1, 2}}));
  EXPECT_EQ(both.seen.weights, (std::vector<double>{3, 3, 3, 2, 2, 2}));
  EXPECT_EQ(both.seen.directions[4], (glm::dvec3{0, 0, -1}));
  EXPECT_EQ(nodes_at_looks_, (std::vector<std::size_t>{3, 6})) << "once for each, when its nodes are there";
  EXPECT_EQ(heights_, (std::vector<float>{2, 1.75f}));
  EXPECT_EQ(both.by_pose(std::vector<std::uint8_t>{0, 1, 2, 3, 4, 5}),
            (std::vector<std::uint8_t>{0, 1, 2, 0, 1, 2, 3, 4, 5, 0, 1, 2}));
  EXPECT_EQ(fixture_.findings.notes.front().message, "made for 4 poses (2 different), in 6 pictures");
}

TEST_F(CapturedSubjects, layers_judge_orders_of_atoms) {
  const SubjectCapture both = captured({0, 1});
  ASSERT_EQ(both.seen.owners.size(), 4u);
  const auto counts = counts_of(both.seen, as_it_came(both.seen));
  ASSERT_GT(counts[0].visible, 0u);
  EXPECT_EQ(counts[0].shaded, 2 * counts[0].visible) << "both squares of the hat, which hide the head";
  EXPECT_EQ(counts[1].shaded, 0u) << "they turn their backs";
  EXPECT_EQ(tally_of(both.seen, counts).visible, static_cast<double>(3 * counts[0].visible + 2 * counts[3].visible));
  const std::vector<Numbers> from_above = {{1, 0}, {1, 0}};
  EXPECT_EQ(counts_of(both.seen, from_above)[0].shaded, counts[0].visible);
}

TEST_F(CapturedSubjects, draws_that_are_not_ordered_are_one_atom) {
  const SubjectCapture hat = captured({0});
  EXPECT_EQ(hat.seen.draws[hat.number_of(0)].atoms.offsets, (Numbers{0, 2, 4}));
  EXPECT_EQ(hat.seen.draws[hat.number_of(1)].atoms.offsets, (Numbers{0, 4}));
  EXPECT_EQ(as_it_came(hat.seen), (std::vector<Numbers>{{0, 1}, {0}}));
}

TEST_F(CapturedSubjects, what_can_not_be_captured_is_told) {
  EXPECT_THROW(captured({0, 1}, false), std::runtime_error);
  cancel_ = true;
  EXPECT_THROW(captured({0, 1}), std::runtime_error);
}

/// Whether an order is worth looking for, and what is told where it is not.
std::optional<std::string> left_alone(const testing::TestMesh& mesh) {
  const Scene scene = testing::scene_of(mesh);
  testing::RunFixture fixture;
  Captures service(false);  // nothing may be drawn
  foredraw::Run run{fixture.analyses, fixture.executor, fixture.findings, fixture.views, rest_pose, &service};
  const bool may = may_overdraw({scene, {"mesh", {{0, {}}}}, {0}}, run);
  EXPECT_NE(may, run.keeps());
  return fixture.findings.nothing_to_gain;
}

TEST(MayOverdraw, IsNotSoOfWhatIsConvexOrNearlySo) {
  EXPECT_EQ(left_alone(testing::sphere(32, 16)),
            "it is convex or nearly convex: no order has a higher overdraw ratio than 1.0000");
  const auto marble = testing::sphere(16, 8, 0.02f);  // inside of a ball
  EXPECT_EQ(left_alone(testing::joined(marble, testing::sphere(32, 16))),
            "it is convex or nearly convex: no order has a higher overdraw ratio than 1.0004");
  EXPECT_EQ(left_alone(testing::torus(32, 16)), std::nullopt);
}

}  // namespace
}  // namespace foredraw::subject_capture_test
