// A folder as input: every scene in it by itself, a line for each, and one bad file does not end the run.

#include "support/on_corpus.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <nlohmann/json.hpp>

#include <map>
#include <tuple>

namespace foredraw::folder_test {
namespace {

namespace fs = std::filesystem;
using testing::content;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

class Folder : public testing::OnCorpus {
 protected:
  Folder() {
    fs::create_directories(folder_ / "in/props");
    copy("static/spot.glb", "in/spot.glb");
    copy("scenes/kaykit_city/bench.gltf", "in/props/bench.gltf");
    copy("scenes/kaykit_city/bench.bin", "in/props/bench.bin");
    testing::put(folder_ / "in/notes.txt", "no scene");
  }
};

TEST_F(Folder, IsWorkedOnFileByFile) {
  const Ended ended = run("optimize in -o out/made --report r.json");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("2 files"));
  EXPECT_TRUE(fs::exists(folder_ / "out/made/spot.glb"));
  EXPECT_TRUE(fs::exists(folder_ / "out/made/props/bench.gltf"));
  EXPECT_FALSE(fs::exists(folder_ / "out/made/notes.txt"));
  ASSERT_EQ(run("optimize in/spot.glb -o alone.glb").code, 0);
  EXPECT_EQ(content(folder_ / "alone.glb"), content(folder_ / "out/made/spot.glb"));

  const Json batch = Json::parse(content(folder_ / "r.json"));
  ASSERT_EQ(batch["files"].size(), 2u);
  EXPECT_EQ(batch["files"][0]["report"]["input"]["path"], "in/props/bench.gltf");  // sorted
  EXPECT_EQ(batch["files"][1]["outcome"], "done");
  std::uint64_t triangles = 0;
  for (const Json& file : batch["files"]) triangles += file["report"]["totals"]["triangles"].get<std::uint64_t>();
  EXPECT_EQ(batch["totals"]["triangles"], triangles);
}

/// An engine that watches the folder imports nothing again.
TEST_F(Folder, ASecondRunTouchesNoFile) {
  const auto facts_of = [](const fs::path& path) {
    struct stat facts {};
    EXPECT_EQ(::stat(path.c_str(), &facts), 0) << path;
    return std::tuple(facts.st_ino, facts.st_mtim.tv_sec, facts.st_mtim.tv_nsec);
  };
  ASSERT_EQ(run("optimize in -o out -p tipsify").code, 0);
  std::map<fs::path, decltype(facts_of({}))> before;
  for (const char* name : {"spot.glb", "props/bench.gltf", "props/bench.bin"})
    before[folder_ / "out" / name] = facts_of(folder_ / "out" / name);
  ASSERT_EQ(run("optimize in -o out -p tipsify").code, 0);
  for (const auto& [path, facts] : before) EXPECT_EQ(facts_of(path), facts) << path;
  ASSERT_EQ(run("optimize in -o out -p forsyth").code, 0);
  EXPECT_NE(facts_of(folder_ / "out/spot.glb"), before[folder_ / "out/spot.glb"]);
}

/// Who is left alone keeps its bytes under a name of its own: the other's are new.
TEST_F(Folder, ScenesMayShareABuffer) {
  std::string text = content(folder_ / "in/props/bench.gltf");
  testing::put(folder_ / "in/props/other.gltf", text);  // the same bench.bin
  ASSERT_EQ(run("optimize in/props -o out").code, 0);
  for (const char* name : {"bench", "other"}) {
    const std::string gltf = std::string("out/") + name + ".gltf";
    EXPECT_EQ(run("measure " + gltf + " --with vertex-cache").code, 0) << name;
    EXPECT_TRUE(fs::exists(folder_ / "out" / (std::string(name) + ".bin"))) << name;
  }
  ASSERT_EQ(run("optimize in/props -o plain -p ''").code, 0);
  EXPECT_EQ(content(folder_ / "plain/bench.bin"), content(folder_ / "in/props/bench.bin"));
  EXPECT_TRUE(fs::exists(folder_ / "plain/other.bin"));
}

/// A .glb and a .gltf of one name, each compressed and with a plain copy beside it for those who can not decompress.
TEST_F(Folder, ScenesOfOneNameHavePlainCopiesOfTheirOwn) {
  const std::string model = testing::project_file("tests/compressed/spot_fallback.gltf").string();
  fs::create_directories(folder_ / "both");
  ASSERT_EQ(run("optimize '" + model + "' -o both/spot.gltf -p tipsify").code, 0);
  ASSERT_EQ(run("optimize '" + model + "' -o both/spot.glb -p forsyth").code, 0);
  const Ended ended = run("optimize both -o out");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(fs::exists(folder_ / "out/spot.fallback.bin"));
  EXPECT_TRUE(fs::exists(folder_ / "out/spot.glb.fallback.bin"));
  for (const char* name : {"both/spot.gltf", "both/spot.glb", "out/spot.gltf", "out/spot.glb"}) {
    EXPECT_THAT(run(std::string("measure ") + name + " --with vertex-cache").err, Not(HasSubstr("uncompressed copy")))
        << name;
  }
}

TEST_F(Folder, ExtensionsMayBeInCapitals) {
  fs::copy_file(folder_ / "in/spot.glb", folder_ / "in/props/bench.GLB");
  const Ended ended = run("optimize in -o out");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(fs::exists(folder_ / "out/props/bench.GLB"));
  EXPECT_TRUE(fs::exists(folder_ / "out/props/bench.bin"));
}

TEST_F(Folder, ABadFileDoesNotEndTheRun) {
  testing::put(folder_ / "in/broken.glb", "glTF and then nothing");
  const Ended ended = run("optimize in -o out");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("in/broken.glb: error: "));
  EXPECT_THAT(ended.err, HasSubstr("failed: see above"));
  EXPECT_TRUE(fs::exists(folder_ / "out/spot.glb"));
  EXPECT_FALSE(fs::exists(folder_ / "out/broken.glb"));
}

TEST_F(Folder, IsTheSameAtAnyThreadCount) {
  ASSERT_EQ(run("optimize in -o one --threads 1").code, 0);
  ASSERT_EQ(run("optimize in -o many --threads 4").code, 0);
  for (const char* file : {"spot.glb", "props/bench.gltf", "props/bench.bin"}) {
    EXPECT_EQ(content(folder_ / "one" / file), content(folder_ / "many" / file)) << file;
  }
}

TEST_F(Folder, ResultsInsideItAreNoInputs) {
  ASSERT_EQ(run("optimize in -o in/out").code, 0);
  const Ended again = run("optimize in -o in/out");
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_THAT(again.err, HasSubstr("2 files"));
}

TEST_F(Folder, IsMeasuredAndComparedToo) {
  const Ended measured = run("measure in --with vertex-cache");
  EXPECT_EQ(measured.code, 0) << measured.err;
  EXPECT_THAT(measured.out, HasSubstr("in/spot.glb"));
  EXPECT_THAT(measured.out, Not(HasSubstr("->")));
  const Ended compared = run("compare in -p tipsify -p weld,tipsify --with vertex-cache --json");
  EXPECT_EQ(compared.code, 0) << compared.err;
  EXPECT_EQ(Json::parse(compared.out)["files"].size(), 2u);
}

TEST_F(Folder, MistakesAreToldBeforeAnythingIsDone) {
  const auto refused = [&](const std::string& arguments, const std::string& what) {
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 1) << arguments;
    EXPECT_THAT(ended.err, HasSubstr(what)) << arguments;
    EXPECT_EQ(ended.err.find("hint:"), ended.err.rfind("hint:")) << "one error: " << ended.err;
    EXPECT_FALSE(fs::exists(folder_ / "out")) << arguments;
  };
  refused("optimize in -o in/spot.glb", "is not a folder");
  refused("optimize in -o -", "is not a folder");
  refused("optimize in -o out -o remap:remap.json", "remap");
  refused("optimize in -o out -o draw-orders:orders.json", "draw-orders");
  fs::create_directories(folder_ / "empty");
  refused("optimize empty -o out", "holds no scene");
  testing::put(folder_ / "in/spot.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  refused("optimize in -o out", "the outputs of spot.glb and spot.obj would both have this name\n    hint: give one");
  refused("optimize in -o in", "is the input folder itself");
  refused("optimize in -o out --report out/spot.glb", "has the extension of a scene");
  fs::create_directories(folder_ / "named");
  for (const char* name : {"named/bench.gltf", "named/bench.fallback.gltf"})
    copy("scenes/kaykit_city/bench.gltf", name);
  refused("optimize named -o out",
          "would both have this name");  // bench.fallback.bin: a buffer of one, a plain copy of the other
  fs::create_directories(folder_ / "up/up");
  fs::copy_file(folder_ / "in/spot.glb", folder_ / "up/up/spot.glb");
  fs::copy_file(folder_ / "in/spot.glb", folder_ / "up/spot.glb");
  refused("optimize up -o .", "would both have this name");
  // What one scene becomes would take the place of a buffer that another is read from.
  fs::create_directories(folder_ / "deep/deep");
  copy("scenes/kaykit_city/bench.gltf", "deep/deep/bench.gltf");
  copy("scenes/kaykit_city/bench.bin", "deep/deep/bench.bin");
  testing::put(folder_ / "deep/other.gltf",
               R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "bench.bin", "byteLength": 8}]})");
  fs::copy_file(folder_ / "deep/deep/bench.bin", folder_ / "deep/bench.bin");
  refused("optimize deep -o .", "bench.bin");
}

}  // namespace
}  // namespace foredraw::folder_test
