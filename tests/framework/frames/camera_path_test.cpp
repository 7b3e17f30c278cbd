#include <foredraw/frames/camera_path.h>

#include "support/levelled_field.h"
#include "support/program.h"

#include <gtest/gtest.h>

namespace foredraw::camera_path_test {
namespace {

struct Stage {
  Scene scene;
  Analyses analyses;
  Executor executor{1};

  std::variant<CameraPath, std::string> path(const FrameSet& set) {
    return camera_path(FrameScene(scene, analyses, executor), set);
  }
};

CameraPath path_of(Scene scene, const FrameSet& set) {
  Stage stage{std::move(scene)};
  return std::get<CameraPath>(stage.path(set));
}

std::string why_not(Scene scene, const FrameSet& set) {
  Stage stage{std::move(scene)};
  const auto path = stage.path(set);
  const std::string* why = std::get_if<std::string>(&path);
  return why == nullptr ? std::string() : *why;
}

/// Keys are read from files.
class CameraKeys : public testing::InFolder {
 protected:
  std::string file_of(const std::string& text) const {
    testing::put(folder_ / "keys.walk", text);
    return (folder_ / "keys.walk").string();
  }

  std::string mistake_in(const std::string& text) const {
    const auto keys = read_camera_keys(file_of(text));
    const std::string* why = std::get_if<std::string>(&keys);
    return why == nullptr ? std::string() : why->substr(why->find("keys.walk"));
  }
};

TEST(CameraPath, AroundTheSceneLooksAtItsMiddleFromOutsideAndComesBack) {
  const CameraPath path = path_of(testing::levelled_field(5), {.path = "around", .frames = 50});
  ASSERT_EQ(path.size(), 50u);
  const glm::dvec3 middle(8, 0, 8);
  for (const PathFrame& frame : path) {
    const glm::dvec3 to = middle - frame.camera.eye;
    EXPECT_NEAR(glm::dot(frame.camera.ahead, to), glm::length(to), 1e-9);
    EXPECT_NEAR(glm::length(frame.camera.up), 1, 1e-12);
    EXPECT_NEAR(glm::dot(frame.camera.up, frame.camera.ahead), 0, 1e-12);
    EXPECT_GT(frame.camera.up.y, 0);
    EXPECT_GT(frame.camera.near, 0);
  }
  const double step = glm::length(path[1].camera.eye - path[0].camera.eye);
  EXPECT_LT(glm::length(path.back().camera.eye - path.front().camera.eye), 3 * step);
}

TEST(CameraPath, HangsOnTheSeed) {
  const auto eye = [](std::int64_t seed) {
    return path_of(testing::levelled_field(3), {.path = "around", .frames = 3, .seed = seed})[1].camera.eye;
  };
  EXPECT_EQ(eye(1), eye(1));
  EXPECT_NE(eye(1), eye(2));
}

/// A camera that an animation moves, with an angle of its own.
Scene with_camera() {
  Scene scene = testing::levelled_field(2);
  Node camera;
  camera.has_camera = true;
  camera.camera_angle = 1.5707964f;
  const auto id = static_cast<NodeId>(scene.nodes.size());
  scene.nodes.push_back(camera);
  AnimationChannel channel{id, AnimatedPath::translation, Interpolation::linear, Shared<float>({0, 10}),
                           Shared<float>({0, 1, 0, 20, 1, 0})};
  scene.animations.push_back({"walk", {channel}});
  return scene;
}

TEST(CameraPath, OfACameraOfTheSceneIsTheWholeClip) {
  for (const char* word : {"auto", "camera"}) {
    const CameraPath path = path_of(with_camera(), {.path = word, .frames = 11});
    ASSERT_EQ(path.size(), 11u);
    EXPECT_EQ(path[5].seconds, 5);
    EXPECT_EQ(path[5].camera.eye, glm::dvec3(10, 1, 0));
    EXPECT_EQ(path[5].camera.ahead, glm::dvec3(0, 0, -1));
    EXPECT_EQ(path[10].camera.eye, glm::dvec3(20, 1, 0));
    EXPECT_NEAR(path[5].camera.half_height, 1, 1e-6);
  }
}

TEST(CameraPath, WithoutACameraThatMovesSaysSo) {
  EXPECT_NE(why_not(testing::levelled_field(2), {.path = "camera"}).find("has no perspective camera"),
            std::string::npos);
  Scene still = with_camera();
  still.animations.clear();
  EXPECT_NE(why_not(still, {.path = "camera"}).find("has no perspective camera"), std::string::npos);
}

TEST_F(CameraKeys, AreMovedBetweenEvenly) {
  const std::string file = file_of("# out and back\n0  0 0 0  0 0 -1\n1  4 0 0  4 0 -1\n\n3  4 2 0  4 2 -1 # up\n");
  const CameraPath path = path_of(testing::levelled_field(1), {.path = file, .frames = 7});
  EXPECT_EQ(path[1].camera.eye, glm::dvec3(2, 0, 0));
  EXPECT_EQ(path[2].camera.eye, glm::dvec3(4, 0, 0));
  EXPECT_EQ(path[4].camera.eye, glm::dvec3(4, 1, 0));
  EXPECT_EQ(path[6].camera.eye, glm::dvec3(4, 2, 0));
  EXPECT_EQ(path[4].seconds, 2);
}

TEST_F(CameraKeys, AreToldByTheirLineWhereWrong) {
  EXPECT_EQ(mistake_in("0 0 0 0 0 0 -1\n1 2 3\n").substr(0, 12), "keys.walk:2:");
  EXPECT_NE(mistake_in("0 0 0 0 0 0 -1 8\n").find("expected seven numbers"), std::string::npos);
  EXPECT_LT(mistake_in("0 " + std::string(100'000, '3') + " 0 0 0 0 -1\n").size(), 250u);
  EXPECT_NE(mistake_in("0 1 1 1 1 1 1\n").find("somewhere else than the eye"), std::string::npos);
  EXPECT_NE(mistake_in("0 nan 0 0 0 0 -1\n"), "");
  EXPECT_NE(mistake_in("0 0 0 0 1e400 0 -1\n"), "");
  EXPECT_NE(mistake_in("1 0 0 0 0 0 -1\n1 0 0 0 0 0 -1\n").find("times must rise"), std::string::npos);
  EXPECT_NE(mistake_in("# nothing\n").find("it has no keys"), std::string::npos);
  EXPECT_NE(why_not(testing::levelled_field(1), {.path = "./nowhere.walk"}).find("there is no such file"),
            std::string::npos);
}

TEST(CameraPath, WrongWordsAreTold) {
  EXPECT_NE(why_not(testing::levelled_field(1), {.path = "camra"}).find("did you mean 'camera'?"), std::string::npos);
}

TEST(CameraPath, OfASceneWithoutTrianglesIsThere) { EXPECT_EQ(path_of(Scene{}, {.frames = 4}).size(), 4u); }

}  // namespace
}  // namespace foredraw::camera_path_test
