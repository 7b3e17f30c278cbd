// Files written by the library for C, beside those of the program: the same bytes for every preset and setting, and the
// same words where something is wrong.

#include <foredraw/c/foredraw.h>

#include "handles.h"

#include <support/program.h>

namespace foredraw::testing::written_files_test {
namespace {

const std::string corpus = FOREDRAW_SOURCE_DIR "/benchmarks/corpus/";
const std::string spot = corpus + "static/spot.glb", bench = corpus + "scenes/kaykit_city/bench.gltf";
const std::string sprites = corpus + "particles/atlas_playcanvas_numbers.json";

class WrittenFiles : public InFolder {
 protected:
  SceneHandle made(const std::string& input, const std::string& pipeline) const {
    foredraw_scene *scene = nullptr, *result = nullptr;
    EXPECT_EQ(foredraw_read(context_.get(), input.c_str(), &scene, nullptr), FOREDRAW_DONE);
    const SceneHandle read(scene);
    Told report;
    EXPECT_EQ(foredraw_optimize(context_.get(), scene, pipeline.c_str(), &result, report.out()), FOREDRAW_DONE);
    return SceneHandle(result);
  }
  std::string written(const SceneHandle& scene, const char* settings = nullptr) const {
    const std::string path = (folder_ / "ours.glb").string();
    EXPECT_EQ(foredraw_write_as(context_.get(), scene.get(), path.c_str(), settings, nullptr), FOREDRAW_DONE);
    return content(path);
  }
  std::string of_program(const std::string& input, const std::string& rest) const {
    const Ended ended = run_program(folder_, "optimize '" + input + "' -o theirs.glb --with vertex-cache " + rest);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return content(folder_ / "theirs.glb");
  }

  const Context context_{foredraw_context_new(nullptr)};
};

TEST_F(WrittenFiles, AreThoseOfTheProgramForEveryPreset) {
  std::size_t count = 0;
  for (const auto& preset : std::filesystem::directory_iterator(FOREDRAW_SOURCE_DIR "/framework/presets")) {
    const std::string name = '@' + preset.path().stem().string();
    const std::string& input = name == "@sprites" ? sprites : bench;
    const SceneHandle scene = made(input, name);
    EXPECT_EQ(foredraw_write(context_.get(), scene.get(), (folder_ / "ours.glb").c_str(), nullptr), FOREDRAW_DONE);
    EXPECT_EQ(content(folder_ / "ours.glb") == of_program(input, "-p " + name), true) << name;
    ++count;
  }
  EXPECT_GT(count, 5u);
}

TEST_F(WrittenFiles, OutputOfThePipelineHoldsUnlessASettingSaysOtherwise) {
  const SceneHandle small = made(spot, "@small");
  EXPECT_EQ(written(small) == of_program(spot, "-p @small"), true);
  EXPECT_LT(written(small).size(), 30'000u);
  for (const std::string word : {"none", "ext-meshopt", "draco"}) {
    EXPECT_EQ(written(small, ("compression=" + word).c_str()) == of_program(spot, "-p @small --compression " + word),
              true)
        << word;
  }
  const SceneHandle levels = made(spot, "quadric-collapse, levels, vertex-fetch");
  EXPECT_EQ(written(levels, "levels=msft-lod, products = 'none'") ==
                of_program(spot, "-p 'quadric-collapse, levels, vertex-fetch' --levels msft-lod --products none"),
            true);
  EXPECT_NE(written(levels), written(levels, "levels=msft-lod"));
}

TEST_F(WrittenFiles, GoToMemoryAsToDisk) {
  const SceneHandle small = made(spot, "@small");
  Told file, problems;
  ASSERT_EQ(foredraw_write_memory(context_.get(), small.get(), "ours.glb", nullptr, file.out(), nullptr),
            FOREDRAW_DONE);
  EXPECT_EQ(file.text() == written(small), true);
  Told mesh;
  ASSERT_EQ(foredraw_write_memory(context_.get(), small.get(), "ours.stl", "", mesh.out(), problems.out()),
            FOREDRAW_DONE);
  EXPECT_EQ(mesh.text().substr(0, 10), "binary STL");
  EXPECT_EQ(problems.json().at("diagnostics").at(0).at("code"), "made-anew");
  Told several, why;
  EXPECT_EQ(foredraw_write_memory(context_.get(), small.get(), "ours.gltf", nullptr, several.out(), why.out()),
            FOREDRAW_FAILED);
  EXPECT_EQ(several.text(), "");
  EXPECT_EQ(why.json().at("diagnostics").at(0).at("code"), "several-files");
  EXPECT_EQ(foredraw_write_memory(context_.get(), small.get(), "ours.glb", nullptr, nullptr, nullptr),
            FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_write_as(context_.get(), small.get(), nullptr, nullptr, nullptr), FOREDRAW_NULL_POINTER);
}

TEST_F(WrittenFiles, WhatIsWrongIsSaidInTheWordsOfTheProgramAndNothingIsWritten) {
  const SceneHandle scene = made(spot, "tipsify");
  struct Row {
    const char* path;
    const char* settings;
    int status;
    const char* code;
    const char* arguments;
  };
  for (const Row& row : {Row{"x.svg", "", FOREDRAW_FAILED, "unknown-kind", "-o x.svg"},
                         Row{"x.fbx", "", FOREDRAW_FAILED, "unknown-kind", "-o x.fbx"},
                         Row{"x.glb", "zip=1", FOREDRAW_MISTAKE, "unknown-word", "-o x.glb --set output.zip=1"},
                         Row{"x.glb", "compression=zip", FOREDRAW_MISTAKE, "bad-value", "-o x.glb --compression zip"},
                         Row{"no/x.glb", "", FOREDRAW_FAILED, "no-such-folder", "-o no/x.glb"}}) {
    const std::string path = (folder_ / row.path).string();
    Told problems, in_memory, file;
    EXPECT_EQ(foredraw_write_as(context_.get(), scene.get(), path.c_str(), row.settings, problems.out()), row.status);
    const Json told = problems.json().at("diagnostics").at(0);
    EXPECT_EQ(told.at("code"), row.code);
    EXPECT_EQ(told.at("severity"), "error");
    const Ended program = run_program(folder_, "optimize '" + spot + "' " + row.arguments);
    EXPECT_NE(program.code, 0);
    for (const char* part : {"message", "hint"}) {
      std::string text = told.at(part);
      if (const auto at = text.find(folder_.string() + '/'); at != std::string::npos) {
        text.erase(at, folder_.string().size() + 1);
      }
      EXPECT_NE(program.err.find(text), std::string::npos) << text << "\n" << program.err;
    }
    if (std::string(row.code) == "no-such-folder") continue;  // memory has no folders
    EXPECT_EQ(
        foredraw_write_memory(context_.get(), scene.get(), path.c_str(), row.settings, file.out(), in_memory.out()),
        row.status);
    EXPECT_EQ(in_memory.json(), problems.json());
  }
  EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace foredraw::testing::written_files_test
