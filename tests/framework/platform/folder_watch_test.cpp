// What happens in a folder is told, none of it twice, and nothing of what is left out.

#include "support/program.h"

#include <foredraw/platform/folder_watch.h>
#include <foredraw/platform/interruption.h>

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <set>
#include <system_error>
#include <thread>

namespace foredraw {
namespace {

namespace fs = std::filesystem;
using What = FolderWatch::What;

class Watched : public testing::InFolder {
 protected:
  Watched() { fs::create_directories(folder_ / "old/deep"); }

  /// All that comes within a while: "closed old/a", each once.
  static std::set<std::string> told(FolderWatch& watch, const fs::path& folder) {
    std::set<std::string> words;
    for (int quiet = 0; quiet < 3; ++quiet) {
      for (const auto& change : watch.next(std::chrono::milliseconds(30), -1)) {
        quiet = 0;
        const char* what = change.what == What::begun    ? "begun "
                           : change.what == What::closed ? "closed "
                           : change.what == What::gone   ? "gone "
                                                         : "missed";
        words.insert(what + change.path.lexically_relative(folder).string());
      }
    }
    return words;
  }
  std::set<std::string> told(FolderWatch& watch) const { return told(watch, folder_); }
  using Words = std::set<std::string>;
};

TEST_F(Watched, FilesAreToldAsTheyComeAndGo) {
  FolderWatch watch(folder_, {});
  EXPECT_EQ(watch.folders(), 3u);
  std::ofstream file(folder_ / "old/deep/a");
  file << "half" << std::flush;
  EXPECT_EQ(told(watch), Words{"begun old/deep/a"});
  file << " and half" << std::flush;
  EXPECT_EQ(told(watch), Words{"begun old/deep/a"});
  file.close();
  EXPECT_EQ(told(watch), Words{"closed old/deep/a"});
  fs::rename(folder_ / "old/deep/a", folder_ / "b");
  EXPECT_EQ(told(watch), (Words{"gone old/deep/a", "closed b"}));
  fs::create_hard_link(folder_ / "b", folder_ / "c");
  fs::create_symlink("b", folder_ / "d");
  EXPECT_EQ(told(watch), (Words{"closed c", "closed d"})) << "nobody will close these";
  fs::remove(folder_ / "b");
  EXPECT_EQ(told(watch), Words{"gone b"});
}

TEST_F(Watched, FoldersAreWatchedAsTheyCome) {
  FolderWatch watch(folder_, {});
  fs::create_directories(folder_ / "new/deep");
  testing::put(folder_ / "new/deep/a", "a");
  EXPECT_TRUE(told(watch).contains("begun new/deep/a"));
  testing::put(folder_ / "new/deep/a", "b");
  EXPECT_TRUE(told(watch).contains("closed new/deep/a"));
  fs::rename(folder_ / "new", folder_ / "moved");
  EXPECT_EQ(told(watch), (Words{"gone new", "begun moved/deep/a"}));
  testing::put(folder_ / "moved/deep/a", "c");
  EXPECT_TRUE(told(watch).contains("closed moved/deep/a")) << "by its new path";
  fs::remove_all(folder_ / "moved");
  EXPECT_TRUE(told(watch).contains("gone moved"));
  EXPECT_EQ(watch.folders(), 3u);
}

TEST_F(Watched, WhatIsLeftOutIsNotTold) {
  fs::create_directories(folder_ / "out/deep");
  fs::create_directory_symlink(folder_ / "out", folder_ / "link");
  FolderWatch watch(folder_, {folder_ / "link"});  // whatever it is called
  testing::put(folder_ / "out/a", "a");
  testing::put(folder_ / "out/deep/a", "a");
  watch.watch_beside(folder_ / "out/a");
  testing::put(folder_ / "out/a", "b");
  EXPECT_EQ(told(watch), Words{});
}

TEST_F(Watched, FilesElsewhereAreToldForTheirOwnSake) {
  FolderWatch watch(folder_ / "old", {});
  fs::create_directories(folder_ / "shared/deep");
  watch.watch_beside(folder_ / "shared/a");
  watch.watch_beside(folder_ / "old/a");
  watch.watch_beside(folder_ / "not there/a");
  testing::put(folder_ / "shared/a", "a");
  testing::put(folder_ / "shared/deep/a", "a");
  testing::put(folder_ / "old/a", "a");
  EXPECT_EQ(told(watch), (Words{"begun shared/a", "closed shared/a", "begun old/a", "closed old/a"}));
  EXPECT_TRUE(watch.problems().empty());
}

TEST_F(Watched, MoreThanTheSystemRemembersIsTold) {
  FolderWatch watch(folder_, {});
  std::ifstream limit("/proc/sys/fs/inotify/max_queued_events");
  int most = 0;
  if (!(limit >> most) || most > 100'000) GTEST_SKIP() << "this system remembers a lot";
  const std::string a = folder_ / "a", b = folder_ / "b";
  testing::put(a, "a");
  for (int i = 0; i < most; ++i) fs::rename(i % 2 == 0 ? a : b, i % 2 == 0 ? b : a);
  EXPECT_TRUE(told(watch).contains("missed"));
  testing::put(folder_ / "old/c", "c");
  EXPECT_TRUE(told(watch).contains("closed old/c")) << "and it goes on";
}

TEST_F(Watched, AFolderThatIsGoneIsOver) {
  FolderWatch watch(folder_ / "old", {});
  EXPECT_FALSE(watch.is_over());
  fs::rename(folder_ / "old", folder_ / "other");
  told(watch);
  EXPECT_TRUE(watch.is_over());
  EXPECT_THROW(FolderWatch(folder_ / "old", {}), std::system_error);
}

TEST_F(Watched, FilesThatAreOpenForWritingAreKnown) {
  const fs::path path = folder_ / "a";
  EXPECT_FALSE(is_open_for_writing(path)) << "there is none";
  std::ofstream writing(path);
  const auto open = is_open_for_writing(path);
  if (!open) GTEST_SKIP() << "this file system does not tell";
  EXPECT_TRUE(*open);
  writing.close();
  EXPECT_EQ(is_open_for_writing(path), std::optional(false));
  const std::ifstream reading(path);
  EXPECT_EQ(is_open_for_writing(path), std::optional(false));
}

/// In a process of its own, whose first signal it takes as told, and by whose second it ends.
TEST(Interrupted, TheFirstTimeIsToldAndTheSecondEnds) {
  const auto live = [] {
    ::signal(SIGINT, SIG_DFL);  // a background of shells ignores it
    ::signal(SIGHUP, SIG_IGN);
    Interruption::hold();
    std::thread other([] {
      for (;;) ::pause();
    });
    const Interruption interruption;
    ::kill(::getpid(), SIGHUP);
    ::usleep(50'000);
    if (interruption.came()) ::_exit(1);
    ::kill(::getpid(), SIGINT);
    for (int i = 0; i < 1000 && !interruption.came(); ++i) ::usleep(10'000);
    if (!interruption.came()) ::_exit(2);
    ::kill(::getpid(), SIGINT);
    other.join();
  };
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(live(), ::testing::KilledBySignal(SIGINT), "");
}

TEST(Interrupted, NobodyNeedsToInterrupt) {
  sigset_t before;
  ::pthread_sigmask(SIG_SETMASK, nullptr, &before);
  { const Interruption interruption; }
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

}  // namespace
}  // namespace foredraw
