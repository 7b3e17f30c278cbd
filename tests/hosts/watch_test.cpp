// A folder that people work in while the program watches: what they change comes out, once and whole, and nothing else.

#include "support/fbx_builder.h"
#include "support/image_builder.h"
#include "watching.h"

#include <gmock/gmock.h>

namespace foredraw::watch_test {
namespace {

namespace fs = std::filesystem;
using testing::content;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::Running;

class Watch : public testing::Watching {};

TEST_F(Watch, WhatIsThereIsBroughtUpToDateAndCtrlCEnds) {
  put_bench();
  copy("static/spot.glb", "in/spot.glb");
  {
    Running program = watching();
    program.tells("2 files up to date; waiting for changes, until Ctrl-C");
    EXPECT_EQ(program.end(), 0);
    EXPECT_THAT(program.told(), HasSubstr("spot.glb: written, "));
    EXPECT_THAT(program.told(), HasSubstr("s; vertex-cache acmr 1.2925 -> 0.6788\n"));
    EXPECT_THAT(program.told(), HasSubstr(" ended\n"));
  }
  EXPECT_TRUE(output("spot.glb") == clean("spot.glb"));
  EXPECT_TRUE(output("props/bench.gltf") == clean("props/bench.gltf"));
  Running again = watching();
  again.tells("2 files up to date");
  EXPECT_THAT(again.told(), Not(HasSubstr("spot.glb"))) << "nothing to tell of it";
  again.interrupt(SIGTERM);
  EXPECT_EQ(again.ended(), 0);
}

TEST_F(Watch, AFileThatChangesIsMadeAnewAndNoOtherOne) {
  put_quad("in/a.obj", 1);
  put_quad("in/b.obj", 2);
  Running program = watching();
  program.tells("2 files up to date");
  put_quad("in/a.obj", 3);
  program.tells("a.obj: written", 2);
  rest(program);
  EXPECT_EQ(program.count("b.obj"), 1);
  EXPECT_EQ(program.count("a.obj"), 2) << "a line each time";
  EXPECT_TRUE(output("a.glb") == clean("a.glb"));
  EXPECT_EQ(program.end(), 0);
}

TEST_F(Watch, AFileThatIsImportedIsAFileAsOthers) {
  if (!fs::exists(fs::path(FOREDRAW_PROGRAM).parent_path() / "foredraw-import")) GTEST_SKIP() << "no foredraw-import";
  put_quad("in/a.obj", 1);
  testing::FbxBuilder file = testing::bending_bar();
  file.texture(260, 250, "steel.png");
  testing::put(folder_ / "in/bar.fbx", file.text());
  Running program = watching();
  program.tells("2 files up to date");
  testing::put(folder_ / "in/bar.fbx", testing::bending_bar("post").text());
  program.tells("bar.fbx: written", 2);
  testing::put(folder_ / "in/bar.fbx", file.text());
  program.tells("bar.fbx: written", 3);
  testing::put(folder_ / "in/steel.png", "no picture");
  program.tells("bar.fbx (steel.png changed): ");  // which was looked for, and was not there
  EXPECT_EQ(program.end(), 0);
  EXPECT_TRUE(output("bar.glb") == clean("bar.glb"));
}

TEST_F(Watch, AFileThatIsSavedAgainAndAgainIsTakenAsItIsAtLast) {
  Running program = watching();
  program.tells("waiting for changes");
  {
    const std::ofstream open(folder_ / "in/a.obj", std::ios::app);
    for (int i = 0; i < 6; ++i) put_quad("in/a.obj", i);
    rest(program);
    EXPECT_THAT(program.told(), Not(HasSubstr("a.obj")));
  }
  program.tells("a.obj: written");
  // As editors save: to another name, then in its place; or removed first.
  put_quad("in/a.obj.tmp", 7);
  fs::rename(folder_ / "in/a.obj.tmp", folder_ / "in/a.obj");
  program.tells("a.obj: written", 2);
  fs::remove(folder_ / "in/a.obj");
  put_quad("in/a.obj", 8);
  program.tells("a.obj: written", 3);
  EXPECT_TRUE(output("a.glb") == clean("a.glb"));
}

TEST_F(Watch, AFileThatIsHalfWrittenIsNotTaken) {
  Running program = watching();
  program.tells("waiting for changes");
  {
    std::ofstream file(folder_ / "in/a.obj");
    file << quad(1).substr(0, 20) << std::flush;
    rest(program);
    EXPECT_THAT(program.told(), Not(HasSubstr("a.obj")));
    file << quad(1).substr(20);
  }
  program.tells("a.obj: written");
  fs::create_directories(folder_ / "in/new/deep");
  std::ofstream file(folder_ / "in/new/deep/b.obj");
  file << quad(1).substr(0, 20) << std::flush;
  rest(program);
  EXPECT_THAT(program.told(), Not(HasSubstr("b.obj"))) << "in a folder that was not there a moment before";
  file << quad(1).substr(20);
  file.close();
  program.tells("new/deep/b.obj: written");
  EXPECT_THAT(program.told(), Not(HasSubstr("failed")));
}

TEST_F(Watch, WhatDependsOnAChangedFileIsMadeAnew) {
  put_bench();
  put_quad("in/quad.obj", 1);
  testing::put(folder_ / "in/quad.obj", "mtllib quad.mtl\nusemtl paint\n" + quad(1));
  for (const char* cache : {"", " --cache cache", " --cache cache"}) {  // none, an empty one, one that knows it all
    put_bench();
    fs::remove(folder_ / "in/quad.mtl");
    Running program = watching(std::string(testing::quick_stages) + cache);
    program.tells("2 files up to date");
    std::string bin = content(folder_ / "in/props/bench.bin");
    bin[bin.size() / 2] = static_cast<char>(bin[bin.size() / 2] ^ 1);
    testing::put(folder_ / "in/props/bench.bin", bin);
    program.tells("props/bench.gltf (props/bench.bin changed): written");
    testing::put(folder_ / "in/quad.mtl", "newmtl paint\nKd 1 0 0\n");
    program.tells("quad.obj (quad.mtl changed): written");  // which was looked for, and was not there
    fs::remove(folder_ / "in/props/bench.bin");
    program.tells("props/bench.gltf (props/bench.bin changed): failed; its output stays as it was");
    testing::put(folder_ / "in/props/bench.bin", bin);
    program.tells("props/bench.gltf (props/bench.bin changed): its output was right already");
    EXPECT_EQ(program.end(), 0);
    EXPECT_TRUE(output("props/bench.bin") == clean("props/bench.bin"));
  }
}

/// Both come to be written at once; the scene is whole first.
TEST_F(Watch, ASceneWaitsForItsOtherFiles) {
  put_bench();
  Running program = watching(testing::quick_stages + std::string(" --settle .05"));
  program.tells("1 file up to date");
  const std::string bin = content(folder_ / "in/props/bench.bin");
  std::ofstream file(folder_ / "in/props/bench.bin", std::ios::binary);
  file << bin.substr(0, 100) << std::flush;
  copy("scenes/kaykit_city/bench.gltf", "in/props/bench.gltf");
  for (int i = 0; i < 12; ++i) rest(program);  // more than ten times as long as files take to settle
  EXPECT_EQ(program.count("props/bench.gltf"), 1) << program.told();
  file << bin.substr(100);
  file.close();
  program.tells("props/bench.gltf", 2);
  EXPECT_THAT(program.told(), Not(HasSubstr("failed")));
}

TEST_F(Watch, WhatIsGoneLeavesItsOutput) {
  put_quad("in/a.obj", 1);
  put_quad("in/props/b.obj", 2);
  Running program = watching();
  program.tells("2 files up to date");
  fs::remove(folder_ / "in/a.obj");
  program.tells("a.obj: is gone; its output stays");
  fs::rename(folder_ / "in/props", folder_ / "in/things");
  program.tells("props/b.obj: is gone");
  program.tells("things/b.obj: written");
  put_quad("in/things/b.obj", 3);
  program.tells("things/b.obj: written", 2);
  fs::remove_all(folder_ / "in/things");
  program.tells("things/b.obj: is gone");
  EXPECT_THAT(all_files("out"), ::testing::ElementsAre("a.glb", "props/b.glb", "things/b.glb"));
  EXPECT_EQ(program.end(), 0);
}

TEST_F(Watch, OutputsInTheFolderDoNotCountAsChanges) {
  put_bench();
  copy("static/spot.glb", "in/spot.glb");
  Running program(folder_, "watch in -o in/built --cache in/cache" + std::string(testing::quick_stages));
  program.tells("2 files up to date");
  testing::put(folder_ / "in/built/other.glb", "nobody asks for this one");
  copy("static/spot.glb", "in/new.glb");
  program.tells("new.glb: written");
  rest(program);
  EXPECT_EQ(program.count("written"), 4) << program.told();
  EXPECT_EQ(program.count("failed"), 0) << program.told();
  EXPECT_EQ(program.end(), 0);
}

TEST_F(Watch, ThePipelineMayChangeMeanwhile) {
  put_quad("in/a.obj", 1);
  copy("static/spot.glb", "in/spot.glb");
  testing::put(folder_ / "p.toml", "pipeline = 1\nstages = [\"vertex-fetch\"]\n");
  Running program = watching("-p p.toml --with vertex-cache");
  program.tells("2 files up to date");
  testing::put(folder_ / "p.toml", "pipeline = 1\nstages = [\"tipsfy\"]\n");
  program.tells("the pipeline is used as it was before");
  EXPECT_THAT(program.told(), HasSubstr("p.toml:2"));
  testing::put(folder_ / "p.toml", "pipeline = 1\nstages = [\"tipsify\", \"vertex-fetch\"]\n");
  program.tells("the pipeline has changed: all files are looked at again");
  program.tells("2 files up to date", 2);
  EXPECT_EQ(program.count("spot.glb: written"), 2);
  EXPECT_TRUE(output("spot.glb") == clean("spot.glb"));
}

TEST_F(Watch, ImagesThatAListNamesAreNoSprites) {
  const auto put_image = [&](const std::string& name) {
    const auto bytes = testing::png_of({4, 4, 4, 8}, std::vector<std::uint16_t>(64, 255));
    testing::put(folder_ / name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  };
  Running program = watching("-p @sprites");
  program.tells("waiting for changes");
  put_image("in/alone.png");
  put_image("in/atlas.png");
  testing::put(folder_ / "in/frames.json",
               R"({"frames": {"a": {"frame": {"x": 0, "y": 0, "w": 4, "h": 4}}}, "meta": {"image": "atlas.png",
                   "size": {"w": 4, "h": 4}}})");
  program.tells("alone.png: written");
  program.tells("frames.json: written");
  put_image("in/atlas.png");
  program.tells("frames.json (atlas.png changed)");
  EXPECT_THAT(all_files("out"), ::testing::Contains("frames.json"));
  EXPECT_THAT(all_files("out"), Not(::testing::Contains("atlas.json")));
}

}  // namespace
}  // namespace foredraw::watch_test
