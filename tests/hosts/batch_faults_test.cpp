// What may go wrong around a folder of many files: full disks, clocks, files that change, names, links, sheer numbers.
// One line for each, nothing lost, nothing torn.

#include "support/on_corpus.h"
#include "support/process_time.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <nlohmann/json.hpp>

#include <map>
#include <set>

namespace foredraw::batch_faults_test {
namespace {

namespace fs = std::filesystem;
using testing::content;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::ordered_json;

constexpr const char* quick = " -p 'tipsify, vertex-fetch' --with vertex-cache ";

class BatchFaults : public testing::OnCorpus {
 protected:
  BatchFaults() { fs::create_directories(folder_ / "in"); }

  /// A strip of quads of its own, as an OBJ: some 60 bytes each.
  void put_strip(const std::string& name, int number, int quads = 1) {
    std::string text;
    for (int i = 0; i <= quads; ++i) {
      for (const char* y : {" 0 ", " 1 "}) text += "v " + std::to_string(i) + y + std::to_string(number) + '\n';
    }
    for (int i = 0; i < quads; ++i) {
      const auto corner = [&](int j) { return ' ' + std::to_string(2 * i + j); };
      text += 'f' + corner(1) + corner(3) + corner(4) + "\nf" + corner(1) + corner(4) + corner(2) + '\n';
    }
    testing::put(folder_ / name, text);
  }
  void put_strips(int count, int quads = 1) {
    for (int i = 0; i < count; ++i) put_strip("in/strip" + std::to_string(1000 + i) + ".obj", i, quads);
  }
  std::map<std::string, std::string> contents(const std::string& folder) const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / folder)) {
      if (entry.is_regular_file()) all[entry.path().lexically_relative(folder_ / folder).string()] = content(entry);
    }
    return all;
  }
  static std::size_t lines_with(const std::string& text, const std::string& part) {
    std::istringstream lines(text);
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line);) count += line.find(part) != std::string::npos ? 1 : 0;
    return count;
  }
  /// Whether folders can be mounted, in a namespace of a command's own.
  static bool may_mount() {
    return std::system("unshare -m sh -c 'mount -t tmpfs none /mnt && touch /mnt/x' >/dev/null 2>&1") == 0;
  }
};

/// A disk of so few bytes stands in the place of the output folder, and what it held is copied to another one.
TEST_F(BatchFaults, OnAFullDiskWhatWasThereStaysWhole) {
  if (!may_mount()) GTEST_SKIP() << "mounting a small disk takes more rights";
  put_strips(40, 300);
  ASSERT_EQ(run("optimize in -o old --compression ext-meshopt" + std::string(quick)).code, 0);
  ASSERT_EQ(run("optimize in -o clean -p weld").code, 0);
  const auto old = contents("old"), clean = contents("clean");
  std::uint64_t bytes = 0;
  for (const auto& [name, text] : old) bytes += (text.size() + 4095) / 4096 * 4096;
  fs::create_directories(folder_ / "out");
  fs::create_directories(folder_ / "left");
  const std::string small_disk = "unshare -m sh -c 'mount -t tmpfs -o size=" + std::to_string(bytes + 12288) +
                                 " none out && cp old/* out && \"$@\"; code=$?; cp -r out/. left; exit $code' sh";
  const Ended ended = run("optimize in -o out -p weld --cache cache", small_disk);
  std::size_t kept = 0;
  for (const auto& [name, text] : contents("left")) {
    ASSERT_TRUE(old.contains(name)) << name << " was begun and not removed";
    EXPECT_TRUE(text == old.at(name) || text == clean.at(name)) << name;
    kept += text == old.at(name) ? 1 : 0;
  }
  EXPECT_EQ(contents("left").size(), old.size());
  EXPECT_GT(kept, 0u);
  EXPECT_LT(kept, old.size());
  EXPECT_EQ(ended.code, 2) << ended.err;
  EXPECT_EQ(lines_with(ended.err, ": error: "), kept) << ended.err;
}

/// Files that may not grow beyond a size, as an output that a disk has no room for.
TEST_F(BatchFaults, AnOutputThatDoesNotFitIsOneLineAndTheOthersAreThere) {
  put_strips(5);
  put_strip("in/large.obj", 7, 20'000);
  const Ended ended =
      run("optimize in -o out --report r.json" + std::string(quick), "trap '' XFSZ; ulimit -f 800;");  // of 512 bytes
  EXPECT_EQ(ended.code, 2);
  EXPECT_EQ(lines_with(ended.err, ": error: "), 1u) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("large.glb"));
  EXPECT_EQ(contents("out").size(), 5u);
  const Json report = Json::parse(content(folder_ / "r.json"));
  EXPECT_EQ(report["files"].size(), 6u);
  EXPECT_EQ(report["files"][0]["outcome"], "lost");
}

TEST_F(BatchFaults, WithNoRoomForReportsTheRunEndsInOneLine) {
  put_strips(60);
  testing::put(folder_ / "r.json", "an old report");
  const Ended ended = run("optimize in -o out --threads 1 --report r.json" + std::string(quick),
                          "trap '' XFSZ; ulimit -f 64;");  // less than all reports together
  EXPECT_EQ(ended.code, 2);
  EXPECT_EQ(lines_with(ended.err, "error: "), 1u) << ended.err;
  EXPECT_EQ(content(folder_ / "r.json"), "an old report");
  ASSERT_EQ(run("optimize in -o clean" + std::string(quick)).code, 0);
  const auto clean = contents("clean");
  for (const auto& [name, text] : contents("out")) EXPECT_EQ(text, clean.at(name));
}

TEST_F(BatchFaults, ACacheThatMayOnlyBeReadStillGives) {
  if (!may_mount()) GTEST_SKIP() << "mounting a folder read-only takes more rights";
  put_strips(3);
  ASSERT_EQ(run("optimize in -o out --cache cache" + std::string(quick)).code, 0);
  const auto before = contents("cache");
  put_strip("in/new.obj", 77);
  const Ended ended = run("optimize in -o out2 --report r.json --cache cache" + std::string(quick),
                          "unshare -m sh -c 'mount --bind cache cache && mount -o remount,bind,ro cache && \"$@\"' sh");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(lines_with(ended.err, "could not be put into the cache"), 1u) << ended.err;
  std::size_t cached = 0;
  const Json report = Json::parse(content(folder_ / "r.json"));
  for (const Json& file : report["files"]) cached += file.value("cached", false) ? 1 : 0;
  EXPECT_EQ(cached, 3u);
  EXPECT_EQ(contents("out2").size(), 4u);
  EXPECT_EQ(contents("cache"), before);
}

/// Times go back and forth, and the content changes without its size and time doing so.
TEST_F(BatchFaults, ClocksThatJumpMakeNoFileOld) {
  constexpr int quads = 8000;  // large enough that its stamp is remembered
  const std::string run_it = "optimize in -o out --report r.json --cache cache" + std::string(quick);
  const auto set_time = [&](std::time_t seconds) {
    const timespec times[2] = {{seconds, 0}, {seconds, 0}};
    ASSERT_EQ(::utimensat(AT_FDCWD, (folder_ / "in/strip.obj").c_str(), times, 0), 0);
  };
  for (const std::time_t time : {std::time_t{4'000'000'000}, std::time_t{1}, std::time_t{1'000'000'000}}) {
    for (const int number : {1, 2, 1}) {
      put_strip("in/strip.obj", number, quads);
      ASSERT_GT(fs::file_size(folder_ / "in/strip.obj"), 262'144u);
      set_time(time);
      for (int again = 0; again < 2; ++again) {
        ASSERT_EQ(run(run_it).code, 0);
        ASSERT_EQ(run("optimize in -o clean" + std::string(quick)).code, 0);
        EXPECT_EQ(contents("out") == contents("clean"), true) << time << ' ' << number;
      }
    }
  }
}

/// Each result in the cache is that of one content, whichever was there when.
TEST_F(BatchFaults, FilesThatChangeWhileTheyAreReadAreNotMixed) {
  std::map<int, std::string> wanted;
  for (const int number : {1, 2}) {
    put_strip("in/strip.obj", number, 2000);
    ASSERT_EQ(run("optimize in -o clean" + std::to_string(number) + quick).code, 0);
    wanted[number] = content(folder_ / ("clean" + std::to_string(number)) / "strip.glb");
    put_strip("state" + std::to_string(number), number, 2000);
  }
  // One writer puts whole files into the place, the other overwrites them there.
  testing::put(folder_ / "writers.sh",
               "(while [ ! -e stop ]; do for n in 1 2; do cp state$n next; mv next in/strip.obj; done; done) &\n"
               "(while [ ! -e stop ]; do for n in 1 2; do cat state$n >in/strip.obj; done; done) &\n"
               "wait\n"
               ": >stopped\n");
  ASSERT_EQ(std::system(("cd '" + folder_.string() + "' && sh writers.sh >/dev/null 2>&1 &").c_str()), 0);
  for (int i = 0; i < 40; ++i) {
    const Ended ended = run("optimize in -o out --cache cache" + std::string(quick));
    EXPECT_EQ(lines_with(ended.err, ": error: "), ended.code == 0 ? 0u : 1u) << ended.err;  // it was cut off
  }
  testing::put(folder_ / "stop", "");
  ASSERT_TRUE(testing::comes_true([&] { return fs::exists(folder_ / "stopped"); }));
  for (const int number : {1, 2, 1}) {
    put_strip("in/strip.obj", number, 2000);
    for (int again = 0; again < 2; ++again) {
      ASSERT_EQ(run("optimize in -o out --cache cache" + std::string(quick)).code, 0);
      EXPECT_EQ(content(folder_ / "out/strip.glb") == wanted[number], true) << number;
    }
  }
}

TEST_F(BatchFaults, OddNamesAndLinksAreOneLineEach) {
  put_strips(2);
  fs::create_directories(folder_ / "in/deep/er");
  put_strip("in/deep/er/strip.obj", 9);
  const std::set<std::string> odd{"in/\xFF.obj", "in/deep/\xC3.obj", "in/deep/a\xED\xA0\x80.obj"};
  std::size_t made = 0;
  for (const std::string& name : odd) {
    put_strip(name, 3);
    made += fs::exists(folder_ / name) ? 1 : 0;
  }
  fs::create_directory_symlink(folder_ / "in", folder_ / "in/deep/er/up");
  fs::create_directory_symlink("b", folder_ / "in/a");
  fs::create_directory_symlink("a", folder_ / "in/b");
  fs::create_symlink("two.obj", folder_ / "in/one.obj");
  fs::create_symlink("one.obj", folder_ / "in/two.obj");
  fs::create_symlink("nowhere.obj", folder_ / "in/gone.obj");
  const Ended ended = run("optimize in -o out --report r.json --cache cache" + std::string(quick));
  EXPECT_EQ(ended.code, 2);
  EXPECT_EQ(lines_with(ended.err, "its name is not UTF-8"), made) << ended.err;
  for (const char* link : {"in/one.obj: error: ", "in/two.obj: error: ", "in/gone.obj: error: "}) {
    EXPECT_EQ(lines_with(ended.err, link), 1u) << ended.err;
  }
  EXPECT_EQ(contents("out").size(), 3u);
  EXPECT_EQ(Json::parse(content(folder_ / "r.json"))["files"].size(), 6u);
}

/// Each part of a folder of very many files is worked on with little memory, and all parts together are all files.
TEST_F(BatchFaults, TwoHundredThousandFilesInOneFolderLong) {
  constexpr int files = 200'000, parts = 100;
  for (int i = 0; i < files; ++i) put_strip("in/strip" + std::to_string(i) + ".obj", i);
  const std::string limit = "ulimit -v 1500000;";  // kilobytes: of addresses, of which threads take most
  std::size_t done = 0;
  for (const int part : {1, 50, 100}) {
    const std::string number = std::to_string(part);
    const Ended ended = run("optimize in -o out --threads 2 --cache cache --report r" + number + ".json --shard " +
                                number + '/' + std::to_string(parts) + quick,
                            testing::is_sanitized ? "" : limit);
    ASSERT_EQ(ended.code, 0) << ended.err;
    const Json report = Json::parse(content(folder_ / ("r" + number + ".json")));
    EXPECT_GT(report["files"].size(), 1'700u);
    EXPECT_LT(report["files"].size(), 2'300u);
    done += report["files"].size();
  }
  EXPECT_EQ(contents("out").size(), done);
}

}  // namespace
}  // namespace foredraw::batch_faults_test
