// What decides when changed files are taken, and which scenes they concern.

#include <dependants.h>
#include <settling.h>

#include <gmock/gmock.h>

namespace foredraw::cli {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class Settled : public ::testing::Test {
 protected:
  static Settling::Clock::time_point at(std::chrono::milliseconds time) {
    return Settling::Clock::time_point(1h + time);
  }
  std::vector<std::string> settled(std::chrono::milliseconds time) {
    std::vector<std::string> names;
    for (const auto& file : settling_.settled(at(time), [this](const auto&) { return is_open_; }))
      names.push_back(file.string());
    return names;
  }

  std::optional<bool> is_open_;
  Settling settling_{100ms};
};

TEST_F(Settled, FilesAreTakenOnceAllIsQuiet) {
  settling_.changed("b", true, at(0ms));
  settling_.changed("a", true, at(50ms));
  settling_.changed("b", true, at(90ms));
  EXPECT_TRUE(settling_.waits_for("a"));
  EXPECT_EQ(settling_.next(at(100ms)), at(190ms));
  EXPECT_THAT(settled(189ms), IsEmpty()) << "a belongs to b, it may be";
  EXPECT_THAT(settled(190ms), ElementsAre("a", "b"));
  EXPECT_FALSE(settling_.waits_for("a"));
  EXPECT_FALSE(settling_.next(at(200ms)));
  EXPECT_THAT(settled(500ms), IsEmpty());
}

TEST_F(Settled, WhatIsNotClosedIsNotTaken) {
  settling_.changed("a", false, at(0ms));
  EXPECT_THAT(settled(500ms), IsEmpty());
  EXPECT_EQ(settling_.next(at(500ms)), at(600ms));
  settling_.changed("a", true, at(600ms));
  settling_.changed("a", false, at(650ms));  // somebody opened it again
  EXPECT_THAT(settled(900ms), IsEmpty());
  settling_.changed("a", true, at(1000ms));
  EXPECT_THAT(settled(1100ms), ElementsAre("a"));
}

TEST_F(Settled, TheSystemKnowsBetterWhetherAFileIsOpen) {
  settling_.changed("a", true, at(0ms));
  is_open_ = true;
  EXPECT_THAT(settled(500ms), IsEmpty()) << "by a second writer";
  settling_.changed("a", false, at(500ms));
  is_open_ = false;
  EXPECT_THAT(settled(1000ms), ElementsAre("a")) << "written to and closed before anybody watched";
}

TEST_F(Settled, WhoAlwaysWritesDoesNotHoldUpTheOthers) {
  settling_.changed("a", true, at(0ms));
  for (int i = 1; i <= 20; ++i) settling_.changed("log", true, at(i * 50ms));
  EXPECT_THAT(settled(999ms), IsEmpty());
  EXPECT_THAT(settled(1010ms), ElementsAre("a"));
}

TEST(DependantsOf, FilesAreTheScenesThatReadThem) {
  Dependants dependants;
  dependants.set("/in/a.gltf", {"/in/shared.bin", "/in/tex/a.png", "/in/shared.bin"});
  dependants.set("/in/b.gltf", {"/in/shared.bin"});
  EXPECT_THAT(dependants.of("/in/shared.bin"), ElementsAre("/in/a.gltf", "/in/b.gltf"));
  EXPECT_THAT(dependants.of("/in/a.gltf"), ElementsAre("/in/a.gltf"));
  EXPECT_THAT(dependants.of("/in/none"), IsEmpty());
  EXPECT_THAT(dependants.below("/in/tex"), ElementsAre("/in/tex/a.png"));
  dependants.set("/in/a.gltf", {"/in/a.bin"});
  EXPECT_THAT(dependants.of("/in/shared.bin"), ElementsAre("/in/b.gltf"));
  EXPECT_THAT(dependants.below("/in/tex"), IsEmpty());
  dependants.forget("/in/b.gltf");
  EXPECT_FALSE(dependants.knows("/in/b.gltf"));
  EXPECT_THAT(dependants.of("/in/shared.bin"), IsEmpty());
}

TEST(OneNameOf, AFileIsAbsoluteAndStraight) {
  const std::string here = std::filesystem::current_path();
  EXPECT_EQ(one_name("a/../b//c/"), here + "/b/c");
  EXPECT_EQ(one_name("."), here);
  EXPECT_EQ(one_name("/"), "/");
}

}  // namespace
}  // namespace foredraw::cli
