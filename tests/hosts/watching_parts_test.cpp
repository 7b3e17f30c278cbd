// Parts of the decision when changed files are taken.

#include <settling.h>

#include <gmock/gmock.h>

namespace foredraw::cli::watching_parts_test {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class Settled : public ::testing::Test {
 protected:
  static Settling::Clock::time_point at(std::chrono::milliseconds time) {
    return Settling::Clock::time_point(1h + time);
  }
  void write(const std::string& file) { ++files_[file].written; }
  void look(std::chrono::milliseconds time) { settling_.look(files_, at(time)); }
  std::vector<std::string> settled(std::chrono::milliseconds time) {
    return settling_.settled(at(time), [this](const auto&) { return is_open_; });
  }

  bool is_open_ = false;
  Settling::Seen files_{{"old", {}}};
  Settling settling_{100ms, files_};
};

TEST_F(Settled, FilesAreTakenOnceAllIsQuiet) {
  write("b");
  look(0ms);
  write("a");
  look(50ms);
  write("b");
  look(90ms);
  EXPECT_TRUE(settling_.waits_for("a"));
  EXPECT_THAT(settled(189ms), IsEmpty()) << "a belongs to b, it may be";
  look(190ms);
  EXPECT_THAT(settled(190ms), ElementsAre("a", "b"));
  EXPECT_FALSE(settling_.waits_for("a"));
  look(500ms);
  EXPECT_THAT(settled(500ms), IsEmpty());
}

TEST_F(Settled, FilesThatWentHaveChanged) {
  files_.erase("old");
  look(0ms);
  EXPECT_THAT(settled(100ms), ElementsAre("old"));
}

TEST_F(Settled, AFileThatIsAddedLaterHasNotChanged) {
  write("a");
  settling_.add("a", files_.at("a"));
  look(0ms);
  EXPECT_THAT(settled(500ms), IsEmpty());
  write("a");
  look(500ms);
  EXPECT_THAT(settled(600ms), ElementsAre("a"));
}

TEST_F(Settled, AFileThatAProgramHasOpenIsNotTaken) {
  write("a");
  look(0ms);
  is_open_ = true;
  EXPECT_THAT(settled(500ms), IsEmpty());
  is_open_ = false;
  EXPECT_THAT(settled(600ms), ElementsAre("a"));
}

TEST_F(Settled, WhoAlwaysWritesDoesNotHoldUpTheOthers) {
  write("a");
  for (int i = 0; i <= 20; ++i) {
    write("log");
    look(i * 50ms);
  }
  EXPECT_THAT(settled(999ms), IsEmpty());
  EXPECT_THAT(settled(1010ms), ElementsAre("a"));
}

}  // namespace
}  // namespace foredraw::cli::watching_parts_test
