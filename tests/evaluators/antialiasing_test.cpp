#include "evaluators/antialiasing/antialiasing.h"

#include "support/meshes.h"
#include "support/thin_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace foredraw::antialiasing_test {
namespace {

using evaluators::antialiasing::Way;
using testing::ThinMesh;

constexpr FrameSize size{160, 160};

/// What ways come to over a few frames of one colour, or lit.
struct Contested {
  Antialiasing found;
  const Antialiasing::OfWay& operator[](Way way) const {
    return *std::ranges::find(found.ways, way, &Antialiasing::OfWay::way);
  }
};

Contested contested(const ThinMesh& mesh, std::vector<Way> ways, bool has_wires, int samples = 64,
                    const std::vector<FrameCamera>& cameras = {testing::pixel_camera(size)}, double step = 1) {
  const Scene scene = testing::scene_of(mesh, {0.05f, 0.04f, 0.03f}, has_wires);
  Analyses analyses;
  const Executor executor(2);
  const FrameScene frames(scene, analyses, executor);
  std::vector<std::uint32_t> closed{has_wires ? 0u : static_cast<std::uint32_t>(mesh.indices.size() / 3)};
  const AntialiasingOptions options{.size = size,
                                    .truth_samples = samples,
                                    .ways = std::move(ways),
                                    .rendering = has_wires ? Rendering::unlit : Rendering::full,
                                    .closed = &closed};
  SlidingViews views;
  for (const FrameCamera& camera : cameras) views.push_back(testing::sliding(camera, 3, step * glm::dvec2(0.37, 0.23)));
  return {*antialiasing(frames, frame_moment(frames, 0), views, options, executor)};
}

/// Persson's claim: no gaps at any distance, and far less flicker, with as much ink as there is.
TEST(Antialiasing, ThinWiresAreWholeAndFlickerLess) {
  const Contested of = contested(testing::lines_at_all_angles(0.05f, size),
                                 {Way::msaa_4, Way::wire_clamp_msaa_4, Way::wire_coverage}, true, 256);
  EXPECT_GT(of[Way::msaa_4].broken.value, 0.1);
  // None is, but where a wire runs along the border of two pixels, both get half of it: the most that still counts.
  EXPECT_LE(of[Way::wire_clamp_msaa_4].broken.value, 0.02);
  EXPECT_LE(of[Way::wire_coverage].broken.value, 0.001);
  // The fewer pixels a picture slides, the less: .18 at .16 pixels. Here it is .43.
  EXPECT_LT(of[Way::wire_clamp_msaa_4].flicker.value, 0.28 * of[Way::msaa_4].flicker.value);
  EXPECT_NEAR(of[Way::wire_clamp_msaa_4].ink.value, 0, 0.02);
  EXPECT_LT(of[Way::wire_coverage].rmse.value, of[Way::wire_clamp_msaa_4].rmse.value / 3);
  EXPECT_NEAR(of[Way::wire_coverage].ink.value, 0, 0.02);
}

/// From the front to nearly edge-on: what is seen of a ribbon, not what it is broad, and widened on the screen.
TEST(Antialiasing, FlatWiresHaveTheirInkFromEverySide) {
  const Contested of = contested(testing::ribbons_at_all_angles(0.08f, size),
                                 {Way::msaa_4, Way::wire_clamp, Way::wire_clamp_msaa_4, Way::wire_coverage}, true, 256);
  EXPECT_NEAR(of[Way::wire_clamp].ink.value, 0, 0.04);
  EXPECT_NEAR(of[Way::wire_clamp_msaa_4].ink.value, 0, 0.03);
  EXPECT_NEAR(of[Way::wire_coverage].ink.value, 0, 0.02);
  EXPECT_LE(of[Way::wire_clamp_msaa_4].broken.value, 0.03);
  EXPECT_LE(of[Way::wire_coverage].broken.value, 0.001);
  EXPECT_LT(of[Way::wire_clamp_msaa_4].flicker.value, 0.4 * of[Way::msaa_4].flicker.value);
  EXPECT_LT(of[Way::wire_coverage].rmse.value, of[Way::wire_clamp_msaa_4].rmse.value / 3);
}

TEST(Antialiasing, WideWiresAreDrawnAsTheyAreToTheBit) {
  const Scene scene = testing::scene_of(testing::lines_at_all_angles(0.51f, size), {0, 0, 0}, true);
  Analyses analyses;
  const Executor executor(1);
  const FrameScene frames(scene, analyses, executor);
  const FrameMoment moment = frame_moment(frames, 0);
  const FrameCamera camera = testing::pixel_camera(size);
  const std::vector<DrawnObject> objects{{0}};
  const evaluators::antialiasing::Frame frame{frames, moment, camera, size, objects};
  EXPECT_EQ(evaluators::antialiasing::picture_of(frame, Way::msaa_4).picture.colours,
            evaluators::antialiasing::picture_of(frame, Way::wire_clamp_msaa_4).picture.colours);
  EXPECT_EQ(evaluators::antialiasing::picture_of(frame, Way::none).picture.colours,
            evaluators::antialiasing::picture_of(frame, Way::wire_clamp).picture.colours);
}

/// One segment that reaches from a few metres to hundreds: a fade that is interpolated draws more than twice the ink.
/// Coverage knows the mean width of a section from all sides, which is that of a round one from every side; eight sides
/// may show up to a twentieth more or less.
TEST(Antialiasing, LongSegmentsKeepTheirInk) {
  for (const int sides : {8, 32}) {
    ThinMesh mesh;
    mesh.add_tube({{0.37f, -1, -3}, {0.37f, -1, -300}}, 0.002f, sides);
    const double metres_a_pixel = 3 * 2 * FrameCamera().half_height / size.height;  // at the near end
    const Contested of =
        contested(mesh, {Way::wire_clamp_msaa_4, Way::wire_coverage}, true, 4096,
                  {looking_at({0, 0, 0}, {0.1, -0.3, -30}), looking_at({0.1, 0, 0}, {-2, 3, -30})}, metres_a_pixel);
    EXPECT_NEAR(of[Way::wire_clamp_msaa_4].ink.value, 0, 0.01) << sides;
    EXPECT_NEAR(of[Way::wire_coverage].ink.value, 0, sides == 8 ? 0.02 : 0.01) << sides;
  }
}

/// Radii are in the mesh's space: nodes that scale it, evenly or not, or mirror it, show as much ink as there is.
TEST(Antialiasing, ScaledNodesKeepTheInkOfTheirWires) {
  for (const glm::vec3& scale : {glm::vec3(0.1f), glm::vec3(10), glm::vec3(1, 1, 5), glm::vec3(-1, 2, 1)}) {
    for (const bool is_flat : {false, true}) {
      ThinMesh mesh = is_flat ? testing::ribbons_at_all_angles(0.08f, size) : testing::lines_at_all_angles(0.05f, size);
      // Made smaller along the axes by as much: the picture is about the same one.
      const float most = std::max({std::abs(scale.x), scale.y, scale.z});
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        mesh.positions[v] /= most;
        mesh.wires[v] /= most;
      }
      Scene scene = testing::scene_of(mesh, {0.05f, 0.04f, 0.03f}, true);
      scene.nodes[0].transform.scale = scale;
      Analyses analyses;
      const Executor executor(2);
      const FrameScene frames(scene, analyses, executor);
      const AntialiasingOptions options{.size = size,
                                        .truth_samples = 256,
                                        .ways = {Way::wire_clamp_msaa_4, Way::wire_coverage},
                                        .rendering = Rendering::unlit};
      const Contested of{*antialiasing(frames, frame_moment(frames, 0),
                                       {testing::sliding(testing::pixel_camera(size), 3, {0.37, 0.23})}, options,
                                       executor)};
      EXPECT_NEAR(of[Way::wire_clamp_msaa_4].ink.value, 0, 0.05) << scale.x << ' ' << scale.z << is_flat;
      EXPECT_NEAR(of[Way::wire_coverage].ink.value, 0, 0.05) << scale.x << ' ' << scale.z << is_flat;
    }
  }
}

TEST(Antialiasing, WiresThatCrossHideNothingOfEachOther) {
  for (const double side : {1.0, -1.0}) {
    FrameCamera camera = testing::pixel_camera(size);
    camera.eye.z *= side;
    camera.ahead.z *= side;
    camera.right.x *= side;
    const Contested of =
        contested(testing::crossing_wires(0.05f, 60), {Way::wire_clamp_msaa_4, Way::wire_coverage}, true, 64, {camera});
    EXPECT_LE(of[Way::wire_clamp_msaa_4].broken.value, 0.01) << side;
    EXPECT_LE(of[Way::wire_coverage].broken.value, 0.01) << side;
    EXPECT_NEAR(of[Way::wire_coverage].ink.value, 0, 0.02) << side;
  }
}

/// From these places; one that sees a face nearly edge-on, a few pixels wide, is beyond what depths can tell.
TEST(Antialiasing, LargeFlatFacesByTheirSecondDepth) {
  const Contested of = contested(testing::turned_box(70), {Way::none, Way::post, Way::msaa_4, Way::second_depth}, false,
                                 64, testing::pixel_cameras_around(size, 6));
  EXPECT_LE(of[Way::second_depth].rmse.value, 1.05 * of[Way::msaa_4].rmse.value);
  EXPECT_LT(of[Way::post].rmse.value, 0.7 * of[Way::none].rmse.value);
}

/// More samples are nearer to the truth, and two truths are nearer to each other than any way is to them.
TEST(Antialiasing, MoreSamplesAreNearerToTheTruth) {
  const Contested of =
      contested(testing::turned_box(40), {Way::none, Way::msaa_2, Way::msaa_4, Way::msaa_8}, false, 256);
  EXPECT_LT(of[Way::msaa_2].rmse.value, of[Way::none].rmse.value);
  EXPECT_LT(of[Way::msaa_4].rmse.value, of[Way::msaa_2].rmse.value);
  EXPECT_LT(of[Way::msaa_8].rmse.value, of[Way::msaa_4].rmse.value);
  EXPECT_LT(of.found.floor.value, 0.3 * of[Way::msaa_8].rmse.value);
  EXPECT_GT(of.found.floor.value, 0);
}

TEST(Antialiasing, WithoutWiresNothingIsSaidOfThem) {
  const Contested of = contested(testing::turned_box(40), {Way::none, Way::wire_coverage}, false);
  EXPECT_EQ(of.found.ways.size(), 1u);
  EXPECT_FALSE(of.found.has_wires);
}

}  // namespace
}  // namespace foredraw::antialiasing_test
