// Where cameras are: around a room and in it, above, and beside what moves.

#include "hidden_in_scene.h"
#include "plugins/processors/hidden/seen_by_rays.h"

#include <gtest/gtest.h>

namespace foredraw::hidden_cameras_test {
namespace {

using processors::hidden::SeenFrom;
using namespace testing;

/// A box within walls: the room's inside faces who is in it.
Scene room() { return one_mesh({box(1), testing::turned(box(0.9f)), box(0.2f, {0.5f, 0, 0})}); }

HiddenSearchOptions from(SeenFrom seen_from, std::vector<std::pair<glm::dvec3, glm::dvec3>> boxes = {}) {
  HiddenSearchOptions options = searched();
  options.cameras.seen_from = seen_from;
  for (const auto& [low, high] : boxes) {
    glm::dmat4 box(0);
    for (int axis = 0; axis < 3; ++axis) box[axis][axis] = high[axis] - low[axis];
    box[3] = glm::dvec4(low, 1);
    options.cameras.boxes.push_back(box);
  }
  return options;
}

TEST(HiddenCameras, InsideARoomKeepItsInside) {
  const glm::dvec3 there(-0.4, 0.1, 0.2);
  EXPECT_EQ(hidden_of(room(), from(SeenFrom::outside)), (Counts{0, 12, 12}));
  EXPECT_EQ(hidden_of(room(), from(SeenFrom::points, {{there, there}})), (Counts{12, 0, 0}));
  EXPECT_EQ(hidden_of(room(), from(SeenFrom::box, {{there, {0, 0.5, 0.5}}})), (Counts{12, 0, 0}));
  const glm::dvec3 outside(3, 3, 3);
  EXPECT_EQ(hidden_of(room(), from(SeenFrom::points, {{outside, outside}})), (Counts{0, 12, 12}));
}

/// What is behind the box from there goes; where a camera looks behind it, it stays.
TEST(HiddenCameras, SeeWhatTheyMayComeTo) {
  const Scene scene = one_mesh({box(0.5f), box(0.1f, {2, 0, 0})});
  const glm::dvec3 before(-9, 0, 0), beside(-9, 9, 0);
  EXPECT_EQ(hidden_of(scene, from(SeenFrom::points, {{before, before}})), inner_goes);
  EXPECT_EQ(hidden_of(scene, from(SeenFrom::points, {{before, before}, {beside, beside}})), all_stay);
  EXPECT_EQ(hidden_of(scene, from(SeenFrom::box, {{before, beside}})), all_stay);
}

TEST(HiddenCameras, RaysEndAtWhatIsNearest) {
  processors::hidden::Sight sight;
  const TestMesh near = grid(1, 1);
  TestMesh far = near;
  for (glm::vec3& p : far.positions) p.z = -0.1f;
  sight.parts = {{near.positions, near.indices}, {far.positions, far.indices}};
  sight.hides = {1, 1};
  sight.triangles = {0, 1, 2, 3};
  glm::dmat4 camera(0);
  camera[3] = {0.5, 0.5, 1000, 1};
  sight.cameras.boxes = {camera};
  processors::hidden::Flags seen(4, 0);
  processors::hidden::Rays(sight).add_seen({0, 16, 1}, processors::hidden::Flags(4, 1), seen, Executor(1));
  EXPECT_EQ(seen, (processors::hidden::Flags{1, 1, 0, 0})) << "what lies behind does not hide";
}

TEST(HiddenCameras, PicturesShowAllSidesOfWhoIsInside) {
  const TestMesh walls = testing::turned(sphere(16, 9));
  const std::size_t count = walls.indices.size() / 3;
  processors::hidden::Sight sight;
  sight.parts = {{walls.positions, walls.indices}};
  sight.hides = {1};
  for (std::uint32_t t = 0; t < count; ++t) sight.triangles.push_back(t);
  glm::dmat4 camera(0);
  camera[3].w = 1;
  sight.cameras.boxes = {camera};
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    processors::hidden::Flags seen(count, 0);
    processors::hidden::Rays(sight).add_seen_around(1, 64, seed, processors::hidden::Flags(count, 1), seen,
                                                    Executor(1));
    EXPECT_EQ(std::ranges::count(seen, 1), 2 * 16 * (9 - 1)) << "at the poles half of them cover nothing; " << seed;
  }
}

TEST(HiddenCameras, AreInTheSpaceOfTheScene) {
  Scene scene = room();
  scene.nodes[0].transform.translation = {100, 0, 0};
  scene.nodes[0].transform.scale = glm::vec3(10);
  const glm::dvec3 there(96, 1, 2), elsewhere(0);
  EXPECT_EQ(hidden_of(scene, from(SeenFrom::points, {{there, there}})), (Counts{12, 0, 0}));
  EXPECT_EQ(hidden_of(scene, as_scene(from(SeenFrom::points, {{there, there}}))), (Counts{12, 0, 0}));
  EXPECT_EQ(hidden_of(scene, from(SeenFrom::points, {{elsewhere, elsewhere}})), (Counts{0, 12, 12}));
  // A second node shows the mesh where a camera is outside.
  scene.nodes.push_back(scene.nodes[0]);
  scene.nodes[1].transform.translation = {0, 100, 0};
  EXPECT_EQ(hidden_of(scene, from(SeenFrom::points, {{there, there}})), (Counts{0, 0, 0}));
  add_clip(scene, 1, {1, 0, 0});  // nobody knows where it is
  EXPECT_EQ(hidden_of(scene, from(SeenFrom::points, {{elsewhere, elsewhere}})), (Counts{0, 0, 0}));
}

TEST(HiddenCameras, FromAboveNobodyLooksUnder) {
  // A table with something stuck to the underside of its top: up is +Y.
  testing::TestMesh top = box();
  for (glm::vec3& p : top.positions) p = {4 * p.x, 0.1f * p.y + 1, 4 * p.z};
  Scene table = one_mesh({top, box(0.1f, {0, 0.75f, 0}), box(0.1f, {0, -1, 0})});
  EXPECT_EQ(hidden_of(table, from(SeenFrom::outside)), (Counts{0, 0, 0}));
  EXPECT_EQ(hidden_of(table, from(SeenFrom::above)), (Counts{0, 0, 0}));  // level with it one sees it
  // A lid turned over it leaves only what is below.
  testing::TestMesh cap = box();
  for (glm::vec3& p : cap.positions) p = {4 * p.x, p.y < 0 ? -2 : 1, 4 * p.z};
  cap.indices.erase(cap.indices.begin() + 6, cap.indices.begin() + 12);  // open at its lower side
  Scene hood = one_mesh({cap, box(0.1f, {0, 0.5f, 0})});
  hood.materials[0].double_sided = true;
  EXPECT_EQ(hidden_of(hood, from(SeenFrom::outside)), all_stay);
  EXPECT_EQ(hidden_of(hood, from(SeenFrom::above)), inner_goes);
  hood.nodes[0].transform.rotation = glm::quat(0, 1, 0, 0);  // half around: the opening looks up
  EXPECT_EQ(hidden_of(hood, from(SeenFrom::above)), all_stay);
  hood.nodes[0].transform.rotation = glm::quat(1, 0, 0, 0);
  add_clip(hood, 0, {0, 1, 0});
  EXPECT_EQ(hidden_of(hood, from(SeenFrom::above)), all_stay);
}

}  // namespace
}  // namespace foredraw::hidden_cameras_test
