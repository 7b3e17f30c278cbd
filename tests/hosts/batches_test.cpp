// Folders worked on again and again, by several processes, and with a cache: nothing is done twice, and nothing is
// lost.

#include "support/on_corpus.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <map>
#include <thread>
#include <tuple>

namespace foredraw::batches_test {
namespace {

namespace fs = std::filesystem;
using testing::content;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::ordered_json;

constexpr const char* quick = " -p 'tipsify, vertex-fetch' --with vertex-cache ";

class Batches : public testing::OnCorpus {
 protected:
  Batches() { fs::create_directories(folder_ / "in/props"); }

  void put_quads(int count) {
    for (int i = 0; i < count; ++i) put_quad("in/props/quad" + std::to_string(i) + ".obj", i);
  }
  void put_scenes() {
    copy("static/spot.glb", "in/spot.glb");
    copy("scenes/kaykit_city/bench.gltf", "in/props/bench.gltf");
    copy("scenes/kaykit_city/bench.bin", "in/props/bench.bin");
  }
  std::string optimize(const std::string& rest = "", int code = 0) {
    const Ended ended = run("optimize in -o out --report r.json --cache cache" + std::string(quick) + rest);
    EXPECT_EQ(ended.code, code) << ended.err;
    return ended.err;
  }
  Json report(const std::string& name = "r.json") { return Json::parse(content(folder_ / name)); }
  std::size_t cached() {
    std::size_t count = 0;
    const Json whole = report();
    for (const Json& file : whole["files"]) count += file.value("cached", false) ? 1 : 0;
    return count;
  }

  using Facts = std::map<std::string, std::tuple<ino_t, time_t, long, std::string>>;
  /// Of every file in the folder: its inode, time and content.
  Facts facts(const std::string& folder) const {
    Facts all;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / folder)) {
      struct stat facts {};
      if (!entry.is_regular_file() || ::stat(entry.path().c_str(), &facts) != 0) continue;
      all[entry.path().lexically_relative(folder_ / folder).string()] = {facts.st_ino, facts.st_mtim.tv_sec,
                                                                         facts.st_mtim.tv_nsec, content(entry.path())};
    }
    return all;
  }
  std::map<std::string, std::string> contents(const std::string& folder) const {
    std::map<std::string, std::string> all;
    for (const auto& [name, facts] : facts(folder)) all[name] = std::get<3>(facts);
    return all;
  }
  /// Without what differs from run to run.
  static Json without_times(Json json) {
    if (json.is_object()) {
      for (const char* key : {"seconds", "peak-memory", "cached", "shard"}) json.erase(key);
    }
    for (Json& held : json) {
      if (held.is_structured()) held = without_times(std::move(held));
    }
    return json;
  }
};

TEST_F(Batches, ASecondRunTakesAllFromTheCacheAndTouchesNothing) {
  put_scenes();
  EXPECT_THAT(optimize(), Not(HasSubstr("from the cache")));
  const Facts before = facts("out");
  const Json first = report();
  EXPECT_THAT(optimize(), HasSubstr("2 files in"));
  EXPECT_EQ(cached(), 2u);
  EXPECT_EQ(facts("out"), before);
  EXPECT_EQ(without_times(report()), without_times(first));

  fs::remove_all(folder_ / "out");
  optimize("--threads 1");
  EXPECT_EQ(cached(), 2u) << "threads decide nothing";
  for (const auto& [name, facts] : facts("out")) EXPECT_EQ(std::get<3>(facts), std::get<3>(before.at(name))) << name;
}

TEST_F(Batches, WhatCountsIsEveryFileThatWasRead) {
  put_scenes();
  copy("scenes/kaykit_city/bench.gltf", "in/props/other.gltf");  // the same bench.bin
  optimize();
  std::string bin = content(folder_ / "in/props/bench.bin");
  bin[bin.size() / 2] = static_cast<char>(bin[bin.size() / 2] ^ 1);
  const std::string old = content(folder_ / "in/props/bench.bin");
  testing::put(folder_ / "in/props/bench.bin", bin);
  optimize();
  EXPECT_EQ(cached(), 1u) << "its two users again, and nobody else";
  testing::put(folder_ / "in/props/bench.bin", old);
  optimize();
  EXPECT_EQ(cached(), 3u) << "both states are kept";
}

TEST_F(Batches, LibrariesOfMaterialsCountAndThoseThatAreMissing) {
  put_quad("in/quad.obj", 1);
  testing::put(folder_ / "in/quad.obj", "mtllib quad.mtl\nusemtl paint\n" + content(folder_ / "in/quad.obj"));
  optimize();
  optimize();
  EXPECT_EQ(cached(), 1u);
  for (const char* colour : {"1 0 0", "0 1 0"}) {
    testing::put(folder_ / "in/quad.mtl", std::string("newmtl paint\nKd ") + colour + '\n');
    optimize();
    EXPECT_EQ(cached(), 0u) << colour;
    const auto made = contents("out");
    optimize();
    EXPECT_EQ(cached(), 1u);
    EXPECT_EQ(contents("out"), made);
  }
}

TEST_F(Batches, WhatCountsIsWhatIsDone) {
  put_quads(1);
  optimize();
  for (const char* other : {"--set tipsify.cache-size=24", "--set seed=5", "--with 'vertex-cache, scene-cost'",
                            "--compression ext-meshopt", "--products none", "--strict"}) {
    run("optimize in -o out --report r.json --cache cache" +
        std::string(other[2] == 'w' ? " -p 'tipsify, vertex-fetch' " : quick) + other);
    EXPECT_EQ(cached(), 0u) << other;
    run("optimize in -o out --report r.json --cache cache" +
        std::string(other[2] == 'w' ? " -p 'tipsify, vertex-fetch' " : quick) + other);
    EXPECT_EQ(cached(), 1u) << other;
  }
  testing::put(folder_ / "p.toml",
               "# a comment\npipeline = 1\nstages = [{ use = \"tipsify\", cache-size = 16 }, \"vertex-fetch\"]\n");
  run("optimize in -o out --report r.json --cache cache -p p.toml --with vertex-cache");
  EXPECT_EQ(cached(), 1u) << "the same in other words";
  EXPECT_THAT(report()["files"][0]["report"]["pipeline"].get<std::string>(), HasSubstr("cache-size"));
}

TEST_F(Batches, AFileThatMovesIsFoundAgain) {
  copy("static/spot.glb", "in/spot.glb");
  optimize();
  fs::create_directories(folder_ / "in/deep/down");
  fs::rename(folder_ / "in/spot.glb", folder_ / "in/deep/down/cow.glb");
  const std::string before = content(folder_ / "out/spot.glb");
  optimize();
  EXPECT_EQ(cached(), 1u);
  EXPECT_EQ(content(folder_ / "out/deep/down/cow.glb"), before);
  EXPECT_EQ(report()["files"][0]["report"]["input"]["path"], "in/deep/down/cow.glb");
  EXPECT_EQ(report()["files"][0]["report"]["output"]["path"], "out/deep/down/cow.glb");
}

/// The images of a .gltf lie where its folder is: from elsewhere they have other names.
TEST_F(Batches, NamesOfFilesCountWhereTheyAreWritten) {
  copy("scenes/kaykit_city/bench.gltf", "in/props/bench.gltf");
  copy("scenes/kaykit_city/bench.bin", "in/props/bench.bin");
  optimize();
  run("optimize in -o else/where --report r.json --cache cache" + std::string(quick));
  EXPECT_EQ(run("measure else/where/props/bench.gltf --with vertex-cache").code, 0);
  run("optimize in -o clean --report r.json" + std::string(quick));
  EXPECT_EQ(contents("clean"), contents("out"));
  run("optimize in -o clean2/deep " + std::string(quick));
  EXPECT_EQ(contents("clean2/deep"), contents("else/where"));
}

TEST_F(Batches, OneFileAloneIsTakenFromTheCacheToo) {
  copy("static/spot.glb", "spot.glb");
  const std::string command =
      "optimize spot.glb -o a.glb -o remap:a.json --report r.json --cache cache" + std::string(quick);
  const Ended first = run(command);
  ASSERT_EQ(first.code, 0) << first.err;
  const std::string scene = content(folder_ / "a.glb"), remap = content(folder_ / "a.json");
  const Json before = report();
  fs::remove(folder_ / "a.json");
  const Ended second = run(command + " --json");
  ASSERT_EQ(second.code, 0) << second.err;
  EXPECT_THAT(second.err, HasSubstr("from the cache"));
  EXPECT_THAT(second.err, HasSubstr(first.err.substr(first.err.find('\n'), 200)));
  EXPECT_EQ(content(folder_ / "a.glb"), scene);
  EXPECT_EQ(content(folder_ / "a.json"), remap);
  EXPECT_EQ(report(), before);
  EXPECT_EQ(Json::parse(second.out), before);
}

TEST_F(Batches, WhatFailedIsNotKept) {
  put_quads(2);
  testing::put(folder_ / "in/bad.glb", "no scene");
  EXPECT_THAT(optimize("", 2), HasSubstr("bad.glb"));
  EXPECT_THAT(optimize("", 2), HasSubstr("bad.glb"));
  EXPECT_EQ(cached(), 2u);
}

TEST_F(Batches, ADamagedEntryIsToldAndMadeAnew) {
  put_scenes();
  optimize();
  const auto clean = contents("out");
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / "cache/entries")) {
    if (!entry.is_regular_file() || entry.file_size() < 2000) continue;
    std::string bytes = content(entry.path());
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    testing::put(entry.path(), bytes);
  }
  fs::remove_all(folder_ / "out");
  EXPECT_THAT(optimize(), HasSubstr("this entry of the cache is damaged"));
  EXPECT_EQ(cached(), 0u);
  EXPECT_EQ(contents("out"), clean);
  EXPECT_THAT(optimize(), Not(HasSubstr("damaged")));
  EXPECT_EQ(cached(), 2u);
}

TEST_F(Batches, ACacheThatCanNotBeWrittenIsToldOnce) {
  if (::geteuid() == 0) {
    put_quads(3);
    fs::create_directories(folder_ / "cache");
    testing::put(folder_ / "cache/foredraw-cache", "");
    testing::put(folder_ / "cache/entries", "a file in the way");
    const std::string told = optimize();
    EXPECT_THAT(told, HasSubstr("could not be put into the cache"));
    EXPECT_EQ(told.find("could not be put"), told.rfind("could not be put"));
    EXPECT_EQ(contents("out").size(), 3u);
    return;
  }
  put_quads(3);
  optimize();
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / "cache"))
    fs::permissions(entry.path(), fs::perms::owner_write, fs::perm_options::remove);
  put_quad("in/new.obj", 77);
  EXPECT_THAT(optimize(), HasSubstr("could not be put into the cache"));
  EXPECT_EQ(cached(), 3u);
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / "cache"))
    fs::permissions(entry.path(), fs::perms::owner_write, fs::perm_options::add);
}

/// A file that may not grow is as good as a disk that is full.
TEST_F(Batches, AFullDiskForTheCacheIsToldAndTheOutputIsRight) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no such device";
  copy("static/spot.glb", "in/spot.glb");
  ASSERT_EQ(run("optimize in -o clean" + std::string(quick)).code, 0);
  const auto size = fs::file_size(folder_ / "clean/spot.glb");
  // The entry holds the output and more, so that between the two sizes only the entry is too long. Blocks of 512 bytes.
  const std::string limit = "trap '' XFSZ; ulimit -f " + std::to_string(size / 512 + 2) + ";";
  const Ended ended = run("optimize in -o out --cache cache" + std::string(quick), limit);
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("could not be put into the cache"));
  EXPECT_EQ(contents("out"), contents("clean"));
  optimize();
  EXPECT_EQ(cached(), 0u);
}

TEST_F(Batches, ACacheIsLookedAfter) {
  put_quads(5);
  optimize();
  EXPECT_EQ(run("cache cache --verify").code, 0);
  const Json stats = Json::parse(run("cache cache --json").out);
  EXPECT_EQ(stats["entries"], 5) << "nothing else is read for them";
  EXPECT_EQ(run("cache cache --trim 1").code, 0);
  EXPECT_EQ(Json::parse(run("cache cache --json").out)["entries"], 0);
  EXPECT_EQ(run("cache in --trim 1").code, 1) << "which is none";
  EXPECT_EQ(contents("in").size(), 5u);
  EXPECT_EQ(run("cache cache --trim much").code, 1);
  optimize();
  EXPECT_EQ(cached(), 0u);
}

TEST_F(Batches, OptionsThatDoNotFitAreRefused) {
  put_quads(1);
  EXPECT_EQ(run("optimize in/props/quad0.obj -o a.glb --shard 1/2").code, 1);
  EXPECT_EQ(run("optimize in -o out --shard 3/2").code, 1);
  EXPECT_EQ(run("optimize in/props/quad0.obj -o - --cache c").code, 1);
  EXPECT_EQ(run("optimize in/props/quad0.obj -o a.glb --html a.html --cache c").code, 1);
  EXPECT_EQ(run("optimize in -o out --cache in").code, 1) << "a folder with other things";
}

TEST_F(Batches, AMistakeInThePipelineIsToldOnceAndNothingIsDone) {
  put_quads(20);
  for (const char* pipeline : {"tipsfy", "tipsify(cache-sise=4)", "tipsify(cache-size=-1)"}) {
    const Ended ended = run("optimize in -o out -p '" + std::string(pipeline) + "'");
    EXPECT_EQ(ended.code, 1) << pipeline;
    EXPECT_EQ(ended.err.find("error"), ended.err.rfind("error")) << ended.err;
    EXPECT_FALSE(fs::exists(folder_ / "out"));
  }
}

TEST_F(Batches, ShardsTogetherDoWhatOneRunDoes) {
  put_scenes();
  put_quads(9);
  ASSERT_EQ(run("optimize in -o whole --report whole.json" + std::string(quick)).code, 0);
  for (const int of : {1, 2, 3, 16}) {
    std::string reports;
    for (int number = 1; number <= of; ++number) {
      const std::string shard = std::to_string(number) + '/' + std::to_string(of);
      const std::string name = "r" + std::to_string(number) + ".json";
      const Ended ended = run("optimize in -o whole2 --report " + name + " --shard " + shard + quick);
      ASSERT_EQ(ended.code, 0) << ended.err;
      reports += ' ' + name;
    }
    const Ended joined = run("join-reports" + reports + " -o all.json");
    ASSERT_EQ(joined.code, 0) << joined.err;
    EXPECT_THAT(joined.out, HasSubstr("11 files"));
    std::string all = content(folder_ / "all.json");
    for (std::size_t at = 0; (at = all.find("whole2/", at)) != std::string::npos;) all.replace(at, 7, "whole/");
    EXPECT_EQ(without_times(Json::parse(all)), without_times(report("whole.json"))) << of;
    EXPECT_EQ(contents("whole2"), contents("whole"));
    fs::remove_all(folder_ / "whole2");
  }
  EXPECT_EQ(run("join-reports r1.json r2.json r4.json -o all.json").code, 2);
  EXPECT_EQ(run("join-reports r1.json r1.json").code, 1);
  EXPECT_EQ(run("join-reports in/spot.glb").code, 1);
  EXPECT_EQ(run("join-reports r1.json -o r1.json").code, 1);
}

/// Make itself says whether it reads the rules as they are meant.
TEST_F(Batches, MakeReadsTheRules) {
  if (std::system("make --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "make is not installed";
  const std::string odd = "in/odd #1 $x";
  fs::create_directories(folder_ / odd);
  copy("scenes/kaykit_city/bench.gltf", odd + "/bench.gltf");
  copy("scenes/kaykit_city/bench.bin", odd + "/bench.bin");
  testing::put(folder_ / "p.toml", "pipeline = 1\nstages = [\"tipsify\"]\n");
  ASSERT_EQ(run("optimize '" + odd + "/bench.gltf' -o 'o u#t.glb' -p p.toml --with vertex-cache --depfile d.mk").code,
            0);
  testing::put(folder_ / "Makefile", "include d.mk\no\\ u\\#t.glb:\n\t@echo '$(words $^)'; touch 'o u#t.glb'\n");
  const auto make = [&] {
    EXPECT_EQ(std::system(("cd '" + folder_.string() + "' && make -s 'o u#t.glb' >made 2>&1").c_str()), 0)
        << content(folder_ / "made");
    return content(folder_ / "made");
  };
  const auto set_age = [&](const std::string& file, int hours) {
    fs::last_write_time(folder_ / file, fs::file_time_type::clock::now() - std::chrono::hours(hours));
  };
  for (const std::string& file : {odd + "/bench.gltf", odd + "/bench.bin", std::string("p.toml")}) set_age(file, 3);
  const auto touch = [&](const std::string& file) {
    set_age("o u#t.glb", 2);
    set_age(file, 1);
    const bool made = !make().empty();
    set_age(file, 3);
    return made;
  };
  EXPECT_EQ(make(), "");
  EXPECT_TRUE(touch(odd + "/bench.gltf"));
  EXPECT_TRUE(touch(odd + "/bench.bin"));
  EXPECT_TRUE(touch("p.toml"));
  EXPECT_EQ(make(), "");
  fs::remove(folder_ / odd / "bench.bin");
  EXPECT_NE(make(), "") << "what is gone does not stop it";
}

TEST_F(Batches, RulesComeFromTheCacheToo) {
  put_scenes();
  ASSERT_EQ(run("optimize in -o out --depfile a.mk --cache cache" + std::string(quick)).code, 0);
  ASSERT_EQ(run("optimize in -o out --depfile b.mk --cache cache" + std::string(quick)).code, 0);
  EXPECT_EQ(content(folder_ / "a.mk"), content(folder_ / "b.mk"));
  EXPECT_THAT(
      content(folder_ / "a.mk"),
      HasSubstr("out/props/bench.gltf: \\\n in/props/bench.gltf \\\n in/props/bench.bin\nin/props/bench.bin:\n"));
  EXPECT_THAT(content(folder_ / "a.mk"), HasSubstr("out/spot.glb: \\\n in/spot.glb\n"));
}

TEST_F(Batches, NamesThatAreNotUtf8ArePassedBy) {
  put_quads(2);
  const std::string odd = "in/\xFF.obj";
  testing::put(folder_ / odd, content(folder_ / "in/props/quad0.obj"));
  if (!fs::exists(folder_ / odd)) GTEST_SKIP() << "this file system takes no such names";
  EXPECT_THAT(optimize(), HasSubstr("its name is not UTF-8"));
  EXPECT_EQ(report()["files"].size(), 2u);
}

TEST_F(Batches, CyclesOfLinksEnd) {
  put_quads(2);
  fs::create_directory_symlink(folder_ / "in", folder_ / "in/props/up");
  fs::create_symlink("loop.obj", folder_ / "in/loop.obj");
  const std::string told = optimize("", 2);
  EXPECT_THAT(told, HasSubstr("loop.obj"));
  EXPECT_EQ(report()["files"].size(), 3u);
}

/// Many small files: what memory holds does not grow with them as their reports do.
TEST_F(Batches, ReportsDoNotStandInMemory) {
  put_quads(300);
  optimize();
  const Json whole = report();
  EXPECT_EQ(whole["files"].size(), 300u);
  std::uint64_t peak = 0;
  for (const Json& file : whole["files"]) peak = std::max(peak, file["report"]["peak-memory"].get<std::uint64_t>());
  EXPECT_GT(peak, 0u);
  optimize();
  EXPECT_EQ(cached(), 300u);
}

/// Killed at random moments, with another process on the same cache: what comes in the end is what a clean run makes.
TEST_F(Batches, AKillAtAnyMomentLosesNothingLong) {
  put_scenes();
  put_quads(60);
  ASSERT_EQ(run("optimize in -o clean" + std::string(quick)).code, 0);
  const std::string program = std::string("'" FOREDRAW_PROGRAM "' optimize in --cache cache") + quick;
  constexpr int kills = 200;
  std::uint32_t random = 12345;
  for (int i = 0; i < kills; ++i) {
    random = random * 1664525u + 1013904223u;
    const double first = 0.001 * static_cast<double>(random >> 16 & 0x3ff),
                 second = 0.001 * static_cast<double>(random >> 6 & 0x3ff);
    if (i % 20 == 0) fs::remove_all(folder_ / "cache");
    testing::put(folder_ / "kill.sh", "(" + program + " -o a & p=$!; " + program + " -o b & q=$!; sleep " +
                                          std::to_string(first) + "; kill -9 $p; sleep " + std::to_string(second) +
                                          "; kill -9 $q; wait) >/dev/null 2>&1\n");
    EXPECT_GE(std::system(("cd '" + folder_.string() + "' && bash kill.sh >/dev/null 2>&1").c_str()), 0);
  }
  EXPECT_EQ(run("cache cache --verify").code, 0) << "what is renamed into its place is whole";
  for (const char* out : {"a", "b"}) {
    const Ended ended = run("optimize in --cache cache -o " + std::string(out) + quick);
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(contents(out), contents("clean")) << out;
  }
}

}  // namespace
}  // namespace foredraw::batches_test
