#include <foredraw/frames/frame_moment.h>

#include "support/levelled_field.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace foredraw::frame_moment_test {
namespace {

constexpr FrameSize size{200, 100};

struct Seen {
  Analyses analyses;
  Executor executor{1};
  Scene scene;
  FrameScene frames;
  FrameMoment moment;

  explicit Seen(Scene from, double seconds = 0)
      : scene(std::move(from)), frames(scene, analyses, executor), moment(frame_moment(frames, seconds)) {}

  std::vector<std::uint32_t> from(const FrameCamera& camera) const {
    std::vector<std::uint32_t> objects;
    for (const SeenObject& object : seen_objects(frames, moment, camera, size)) objects.push_back(object.object);
    return objects;
  }
};

/// One sphere of radius 1 at each place.
Scene spheres(const std::vector<glm::vec3>& places) {
  Scene scene = testing::scene_of(testing::sphere(32, 16));
  scene.nodes.clear();
  for (const glm::vec3& place : places) {
    Node node;
    node.mesh = 0;
    node.transform.translation = place;
    scene.nodes.push_back(node);
  }
  return scene;
}

TEST(SeenObjects, AreThoseInTheFrustumNearestFirst) {
  const Seen seen(spheres({{0, 0, -20}, {0, 0, -5}, {0, 0, 5}, {100, 0, -5}, {0, 40, -20}}));
  EXPECT_EQ(seen.from({}), (std::vector<std::uint32_t>{1, 0}));
}

TEST(SeenObjects, ReachInByTheirBoxes) {
  // The picture is 60 degrees high and twice as wide: at distance 10 it ends at y = 5.77 and x = 11.5.
  EXPECT_EQ(Seen(spheres({{0, 6.5f, -10}})).from({}).size(), 1u);
  EXPECT_EQ(Seen(spheres({{0, 8.5f, -10}})).from({}).size(), 0u);
  EXPECT_EQ(Seen(spheres({{12.3f, 0, -10}})).from({}).size(), 1u);
  EXPECT_EQ(Seen(spheres({{14.5f, 0, -10}})).from({}).size(), 0u);
  EXPECT_EQ(Seen(spheres({{0, 0, 0.5f}})).from({}).size(), 1u);  // the eye is in it
  EXPECT_EQ(Seen(spheres({{0, 0, 1.2f}})).from({}).size(), 0u);
  // A thin box leaves the frustum where its sphere would still be in it.
  Scene plank = testing::scene_of(testing::grid(4, 4));
  plank.nodes.front().transform.scale = {40, 0.01f, 1};
  plank.nodes.front().transform.translation = {-20, 7, -10};
  EXPECT_EQ(Seen(std::move(plank)).from({}).size(), 0u);
}

TEST(SeenObjects, KnowTheirSizeOnTheScreen) {
  const Seen seen(spheres({{0, 0, -10}}));
  const SeenObject object = seen_objects(seen.frames, seen.moment, {}, size).front();
  const double pixels_a_unit = 100 / (2 * 0.57735 * 10);
  EXPECT_NEAR(object.across, 2 * pixels_a_unit, 0.01);
  EXPECT_NEAR(object.pixels, 3.14159 * pixels_a_unit * pixels_a_unit, 3);
  EXPECT_NEAR(object.pixels_a_unit, pixels_a_unit * 10 / 9, 0.01);  // of its nearest point
  EXPECT_NEAR(object.distance, 9, 1e-4);
  EXPECT_EQ(object.from_middle, 0);
}

TEST(SeenObjects, OfPlacesThatAreNoNumbersAreNone) {
  EXPECT_TRUE(Seen(spheres({{std::nanf(""), 0, -10}, {0, 0, -INFINITY}})).from({}).empty());
}

TEST(SeenObjects, AreFoundByBruteForce) {
  Random random(5);
  std::vector<glm::vec3> places;
  const auto place = [&] { return static_cast<float>(60 * random.unit() - 30); };
  for (int i = 0; i < 400; ++i) places.emplace_back(place(), place(), place());
  const Seen seen(spheres(places));
  const FrameCamera camera = looking_at({1, 2, 3}, {-4, 1, 20});
  std::vector<std::uint32_t> objects = seen.from(camera);
  std::ranges::sort(objects);
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    bool has_vertex_inside = false;
    for (const glm::vec3& p : testing::sphere(32, 16).positions) {
      const glm::dvec3 to = glm::dvec3(p + places[i]) - camera.eye;
      const double ahead = glm::dot(to, camera.ahead);
      has_vertex_inside |= ahead > camera.near && std::abs(glm::dot(to, camera.up)) < camera.half_height * ahead &&
                           std::abs(glm::dot(to, camera.right)) < 2 * camera.half_height * ahead;
    }
    EXPECT_TRUE(!has_vertex_inside || std::ranges::binary_search(objects, i)) << i;
  }
  EXPECT_LT(objects.size(), 120u);
}

TEST(FrameMoment, PlacesInstances) {
  Scene scene = spheres({{10, 0, 0}});
  Transform one, two;
  one.translation = {0, 1, 0};
  two.scale = glm::vec3(3);
  scene.nodes[0].instances = Shared<Transform>({one, two});
  const Seen seen(std::move(scene));
  ASSERT_EQ(seen.frames.objects().size(), 2u);
  EXPECT_NEAR(glm::length(seen.moment.bounds[0].sphere.centre - glm::dvec3(10, 1, 0)), 0, 1e-6);
  EXPECT_NEAR(seen.moment.bounds[1].sphere.radius, 3, 1e-5);
}

TEST(FrameMoment, LeavesOutWhatIsNotShown) {
  Scene scene = spheres({{0, 0, 0}, {1, 0, 0}});
  scene.nodes[0].is_shown = false;
  scene.draws.front().topology = Topology::triangles;
  EXPECT_EQ(Seen(scene).frames.objects().size(), 1u);
  scene.draws.front().topology = Topology::lines;
  EXPECT_EQ(Seen(scene).frames.objects().size(), 0u);
}

TEST(FrameMoment, PlaysAllClipsAtOnceAndAgainFromTheBeginning) {
  Scene scene = spheres({{0, 0, 0}, {0, 0, 0}});
  const auto moving = [](NodeId node, float end) {
    return Animation{"move",
                     {{node, AnimatedPath::translation, Interpolation::linear, Shared<float>({0, end}),
                       Shared<float>({0, 0, 0, end, 0, 0})}}};
  };
  scene.animations = {moving(0, 8), moving(1, 2)};
  const Seen seen(std::move(scene), 5);
  EXPECT_NEAR(seen.moment.bounds[0].sphere.centre.x, 5, 1e-5);
  EXPECT_NEAR(seen.moment.bounds[1].sphere.centre.x, 1, 1e-5);
}

/// A bar from y = 0 to 2 that two joints hold, each a half; the upper one is carried off.
TEST(FrameMoment, BoundsFollowJoints) {
  Scene scene = testing::scene_of(testing::grid(2, 2));
  auto vertices = std::make_shared<VertexStreams>(*scene.draws[0].full().vertices);
  std::vector<std::uint8_t> joints;
  std::vector<float> weights;
  const auto positions = decode_vec3(*vertices->find("POSITION"));
  for (const glm::vec3& p : positions) {
    joints.insert(joints.end(), {static_cast<std::uint8_t>(p.y > positions.front().y ? 1 : 0), 0, 0, 0});
    weights.insert(weights.end(), {1, 0, 0, 0});
  }
  const auto bytes = [](const auto& values) {
    const auto raw = std::as_bytes(std::span(values));
    return Shared<std::byte>({raw.begin(), raw.end()});
  };
  vertices->base.push_back({"JOINTS_0", {Component::uint8, 4, false, 4}, bytes(joints)});
  vertices->base.push_back({"WEIGHTS_0", {Component::float32, 4, false, 16}, bytes(weights)});
  scene.draws[0].full().vertices = vertices;
  scene.nodes.resize(3);
  scene.nodes[0].skin = 0;
  scene.nodes[2].transform.translation = {0, 50, 0};
  scene.skins.push_back({"skin", {1, 2}, {glm::mat4(1), glm::mat4(1)}});
  const Seen seen(std::move(scene));
  const PlacedBounds& bounds = seen.moment.bounds[0];
  for (const glm::vec3& p : positions) {
    const glm::dvec3 posed = glm::dvec3(p) + (p.y > positions.front().y ? glm::dvec3(0, 50, 0) : glm::dvec3(0));
    EXPECT_LE(glm::length(posed - bounds.sphere.centre), bounds.sphere.radius + 1e-6);
    EXPECT_LE(std::abs(posed.y - bounds.sphere.centre.y), bounds.half_box[1].y + 1e-6);
  }
  EXPECT_LT(bounds.sphere.radius, 30);
}

TEST(FrameMoment, NodesMirrorWhateverTheirJointsDo) {
  for (const bool is_mirrored_node : {false, true}) {
    Scene scene = testing::scene_of(testing::sphere(8, 4));
    scene.nodes.resize(2);
    scene.nodes[0].skin = 0;
    scene.nodes[0].transform.scale.y = is_mirrored_node ? -1 : 1;
    scene.nodes[1].transform.scale.x = is_mirrored_node ? 1 : -1;
    scene.skins.push_back({"skin", {1}, {glm::mat4(1)}});
    const Seen seen(std::move(scene));
    EXPECT_EQ(is_mirrored(seen.frames, seen.moment, 0), is_mirrored_node);
  }
}

}  // namespace
}  // namespace foredraw::frame_moment_test
