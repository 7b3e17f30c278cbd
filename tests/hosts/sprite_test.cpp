// Sprites through the program: several outputs of one run, and folders.

#include "support/program.h"
#include "support/sprites.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace foredraw::sprite_test {
namespace {

namespace fs = std::filesystem;
using testing::content;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

class Sprites : public testing::InFolder {
 protected:
  Sprites() {
    fs::create_directories(folder_ / "in/props");
    testing::put_bytes(folder_ / "in/atlas.png", testing::disc_png(64, 32));
    testing::put_bytes(folder_ / "in/props/one.png", testing::disc_png(16, 16));
    testing::put(
        folder_ / "in/list.json",
        R"({"frames":{"left":{"frame":{"x":0,"y":0,"w":32,"h":32}},"right":{"frame":{"x":32,"y":0,"w":32,"h":32}}},)"
        R"("meta":{"image":"atlas.png"}})");
    testing::put(folder_ / "in/package.json", R"({"name":"no list"})");
  }

  Ended run(const std::string& arguments) { return testing::run_program(folder_, arguments); }
  Json json(const std::string& name) { return Json::parse(content(folder_ / name)); }
  bool is_there(const std::string& name) { return fs::exists(folder_ / name); }
};

TEST_F(Sprites, OneRunWritesSeveralFiles) {
  const Ended ended = run("optimize in/list.json -p hexagons -o a.json -o a.glb -o a.h -o a.html --report r.json");
  ASSERT_EQ(ended.code, 0) << ended.err;
  for (const char* name : {"a.glb", "a.h", "a.html"}) EXPECT_TRUE(is_there(name)) << name;
  EXPECT_EQ(json("a.json")["frames"]["left"]["vertices"].size(), 6u);
  EXPECT_EQ(json("r.json")["output"]["path"], "a.json");  // the first one
  EXPECT_EQ(json("r.json")["output"]["bytes"], content(folder_ / "a.json").size());
}

TEST_F(Sprites, AllOutputsAreWrittenOrNone) {
  EXPECT_EQ(run("optimize in/list.json -p hexagons -o a.html -o no/a.json").code, 2);
  EXPECT_FALSE(is_there("a.html"));
  const Ended replaced = run("optimize in/list.json -p hexagons -o a.html -o in/list.json");
  EXPECT_NE(replaced.code, 0);
  EXPECT_THAT(replaced.err, HasSubstr("is an input of this run"));
  EXPECT_FALSE(is_there("a.html"));
}

TEST_F(Sprites, OutputsHaveFilesOfTheirOwn) {
  const auto refused = [&](const std::string& outputs) {
    const Ended ended = run("optimize in/list.json -p hexagons " + outputs);
    EXPECT_EQ(ended.code, 1) << outputs;
    return ended.err;
  };
  EXPECT_THAT(refused("-o a.html -o ./a.html"), HasSubstr("is named for two outputs"));
  EXPECT_THAT(refused("-o - -o -"), HasSubstr("is named for two outputs"));
  EXPECT_THAT(refused("-o in/list.json"), HasSubstr("in/list.json: error: is an input of this run"));
  EXPECT_THAT(refused("-o r.json --report r.json"), HasSubstr("is named for two outputs"));
  EXPECT_THAT(refused("-o a.obj"), HasSubstr("cannot hold sprites"));
  const std::string model = (fs::path(FOREDRAW_SOURCE_DIR) / "benchmarks/corpus/static/spot.glb").string();
  const Ended mesh = run("optimize '" + model + "' -o a.html");
  EXPECT_EQ(mesh.code, 1);
  EXPECT_THAT(mesh.err, HasSubstr("holds only sprites"));
}

TEST_F(Sprites, StandardOutputMayBeOneOfThem) {
  const Ended ended = run("optimize in/list.json -p hexagons -o - -o a.html");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out.substr(0, 4), "glTF");
  EXPECT_TRUE(is_there("a.html"));
}

TEST_F(Sprites, OtherCommandsReadThemToo) {
  EXPECT_THAT(run("inspect in/list.json").out, HasSubstr("sprite"));
  EXPECT_EQ(run("plan in/atlas.png -p hexagons").code, 0);
  EXPECT_EQ(run("measure in/atlas.png --with vertex-cache").code, 0);
  const Ended ended = run("inspect in/package.json");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("in/package.json: error: "));
}

TEST_F(Sprites, AFolderIsWorkedOnListByList) {
  const Ended ended = run("optimize in -p hexagons -o out");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(is_there("out/list.json"));
  EXPECT_TRUE(is_there("out/props/one.json"));
  EXPECT_FALSE(is_there("out/atlas.json"));  // the list's
  EXPECT_FALSE(is_there("out/package.json"));
  EXPECT_EQ(json("out/list.json")["meta"]["image"], "../in/atlas.png");
}

TEST_F(Sprites, AFoldersSpritesAreGathered) {
  const Ended ended = run("optimize in -p hexagons -o out -o all.json -o all.html --threads 2");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(is_there("out/list.json"));
  EXPECT_TRUE(is_there("all.html"));
  ASSERT_EQ(json("all.json")["textures"].size(), 2u);
  EXPECT_EQ(json("all.json")["textures"][0]["frames"].size(), 2u);
  EXPECT_EQ(json("all.json")["textures"][1]["frames"][0]["filename"], "one");
  fs::create_directories(folder_ / "again");
  ASSERT_EQ(run("optimize in -p hexagons -o again/all.html --threads 1").code, 0);
  EXPECT_TRUE(content(folder_ / "again/all.html") == content(folder_ / "all.html"));
  EXPECT_THAT(run("optimize in -p hexagons -o one -o two").err, HasSubstr("two: error: is a second folder"));
  EXPECT_THAT(run("optimize in -p hexagons -o out -o in/list.json").err, HasSubstr("would both have this name"));
}

TEST_F(Sprites, ImagesAreSpritesOnlyToWhoWorksOnThem) {
  const Ended none = run("optimize in -p weld -o out");
  EXPECT_EQ(none.code, 1);
  EXPECT_THAT(none.err, HasSubstr("its images count as sprites only if"));
  fs::copy_file(fs::path(FOREDRAW_SOURCE_DIR) / "benchmarks/corpus/static/spot.glb", folder_ / "in/spot.glb");
  ASSERT_EQ(run("optimize in -p weld -o out").code, 0);
  EXPECT_TRUE(is_there("out/spot.glb"));
  EXPECT_FALSE(is_there("out/list.json"));
  EXPECT_THAT(run("optimize in -p weld -o out -o all.html").err, HasSubstr("there are none"));
}

TEST_F(Sprites, AFolderIsCompared) {
  const Ended ended = run("compare in -p hexagons -p weld --with vertex-cache");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("in/list.json"));
  EXPECT_THAT(ended.out, HasSubstr("in/props/one.png"));
  EXPECT_THAT(ended.out, Not(HasSubstr("in/atlas.png")));
}

TEST_F(Sprites, ABadListDoesNotEndTheRun) {
  testing::put(folder_ / "in/bad.json",
               R"({"frames":{"x":{"frame":{"x":0,"y":0,"w":99,"h":1}}},"meta":{"image":"atlas.png"}})");
  const Ended ended = run("optimize in -p hexagons -o out -o all.html");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("in/bad.json: error: x: begins"));
  EXPECT_TRUE(is_there("out/list.json"));
  EXPECT_TRUE(is_there("all.html"));
}

}  // namespace
}  // namespace foredraw::sprite_test
