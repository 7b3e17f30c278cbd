// The program, its folders and its cache with files that are imported; and no file and no importer ends it.

#include "support/importing.h"
#include "support/meshes.h"

#include <gmock/gmock.h>

#include <array>
#include <random>

namespace foredraw::import_faults_test {
namespace {

namespace fs = std::filesystem;
using testing::content;
using testing::Ended;
class ImportedByProgram : public testing::Imported {};
using ::testing::HasSubstr;
using ::testing::Not;
using testing::quick;

TEST_F(ImportedByProgram, TheProgramOptimizesAnFbx) {
  testing::put(folder_ / "bar.fbx", testing::bending_bar().text());
  const Ended ended = run("optimize bar.fbx -o bar.glb -p @default");
  EXPECT_EQ(ended.code, 0) << ended.err;
  Diagnostics diagnostics;
  const auto made = read_scene((folder_ / "bar.glb").string(), diagnostics, {});
  ASSERT_TRUE(made) << to_text(diagnostics);
  EXPECT_LT(distance(shown(made->scene, {.clip = 0, .time = 1}), {0.1f, 1.1f, 1}), 1e-4f);
  EXPECT_EQ(run("inspect bar.fbx").code, 0);
  const Ended as_fbx = run("optimize bar.fbx -o other.fbx");
  EXPECT_EQ(as_fbx.code, 1);
  EXPECT_THAT(as_fbx.err, HasSubstr(".glb"));
}

TEST_F(ImportedByProgram, WithoutAnImporterTheMessageSaysWhatToInstall) {
  testing::put(folder_ / "bar.fbx", testing::bending_bar().text());
  fs::copy_file(FOREDRAW_PROGRAM, folder_ / "alone");
  const Ended ended = run("", "unset FOREDRAW_IMPORTER; exec ./alone optimize bar.fbx -o bar.glb;");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("foredraw-import"));
  EXPECT_THAT(ended.err, HasSubstr("libassimp-dev"));
}

TEST_F(ImportedByProgram, WhatTheEnvironmentSaysWrongIsNotPassedOver) {
  testing::put(folder_ / "bar.fbx", testing::bending_bar().text());
  for (const char* wrong : {"FOREDRAW_IMPORTER=/nowhere/foredraw-import", "FOREDRAW_IMPORT_MEMORY=4G",
                            "FOREDRAW_IMPORT_SECONDS=-1", "FOREDRAW_IMPORT_SECONDS=soon"}) {
    const Ended ended = run("optimize bar.fbx -o bar.glb", std::string("export ") + wrong + ";");
    EXPECT_EQ(ended.code, 2) << wrong;
    EXPECT_THAT(ended.err, HasSubstr(std::string("bar.fbx: error: cannot be imported: the environment has ") + wrong));
  }
  const Ended other = run("optimize bar.fbx -o bar.glb", "export FOREDRAW_IMPORTER=/bin/true;");
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("the importer /bin/true ended without an answer"));
}

TEST_F(ImportedByProgram, TheImporterAloneSaysWhatIsWrong) {
  testing::put(folder_ / "bar.fbx", testing::bending_bar().text());
  const auto alone = [&](const std::string& arguments) {
    return run("", "exec '" FOREDRAW_IMPORT_PROGRAM "' " + arguments + ";");
  };
  EXPECT_EQ(alone("bar.fbx bar.glb").code, 0);
  EXPECT_EQ(content(folder_ / "bar.glb").substr(0, 4), "glTF");
  EXPECT_EQ(alone("no.fbx no.glb").err, "no.fbx: error: there is no such file\n");
  EXPECT_EQ(alone(". no.glb").err, ".: error: is a folder; a file was expected\n");
  EXPECT_THAT(alone("bar.fbx bar.gltf").err, HasSubstr("give the output the extension .glb"));
  const Ended help = alone("--help");
  EXPECT_EQ(help.code, 0);
  EXPECT_THAT(help.out, HasSubstr("INPUT OUTPUT.glb"));
  EXPECT_EQ(alone("bar.fbx").code, 1);
}

TEST_F(ImportedByProgram, WhateverTheImporterDoesIsOneError) {
  for (const auto& [stand_in, told] :
       std::vector<std::pair<std::string, std::string>>{{"leaves", "bar.fbx: error:"},
                                                        {"is ended", "bar.fbx: error:"},
                                                        {"rubbish", "bar.fbx: error:"},
                                                        {"nothing", "bar.fbx: error:"},
                                                        {"half", "bar.fbx: error:"},
                                                        {"no end", "bar.fbx: error:"},
                                                        {"words", "its words are ?[31mred?"}}) {
    SCOPED_TRACE(stand_in);
    const Ended ended = run_with(stand_in);
    EXPECT_EQ(ended.code, 2) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("bar.fbx: error:"));
    EXPECT_THAT(ended.err, HasSubstr(stand_in == "words" ? "its words are" : told));
    EXPECT_THAT(ended.err, Not(HasSubstr("\x1b")));
    EXPECT_FALSE(fs::exists(folder_ / "bar.glb"));
  }
  const Ended ended = run_with("hangs", "FOREDRAW_IMPORT_SECONDS=1");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("was not done within 1 second"));
}

TEST_F(ImportedByProgram, MemoryHasALimit) {
  if (testing::is_sanitized) GTEST_SKIP() << "sanitizers keep terabytes mapped";
  testing::put(folder_ / "bar.fbx", testing::bending_bar().text());
  const Ended ended = run("optimize bar.fbx -o bar.glb", "export FOREDRAW_IMPORT_MEMORY=300000;");
  EXPECT_EQ(ended.code, 2) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("bar.fbx: error: the importer needs more than the 300,000 bytes"));
  EXPECT_THAT(ended.err, HasSubstr("hint: set FOREDRAW_IMPORT_MEMORY to more bytes"));
}

TEST_F(ImportedByProgram, AFolderHoldsThemBesideOthers) {
  fs::create_directories(folder_ / "in");
  testing::put(folder_ / "in/bar.fbx", testing::bending_bar().text());
  testing::put(folder_ / "in/broken.fbx", testing::bending_bar().text().substr(0, 900));
  testing::put(folder_ / "in/quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
  fs::copy_file(testing::project_file("benchmarks/corpus/static/spot.glb"), folder_ / "in/spot.glb");
  testing::put(folder_ / "in/spot.fbx", testing::bending_bar().text());
  const Ended ended = run("optimize in -o out" + std::string(quick));
  EXPECT_EQ(ended.code, 2) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("broken.fbx: error:"));
  for (const char* name : {"bar.glb", "quad.glb", "spot.glb"}) EXPECT_TRUE(fs::exists(folder_ / "out" / name)) << name;
  EXPECT_GT(fs::file_size(folder_ / "out/spot.glb"), 50000u) << "of the .glb, and not of the .fbx beside it";

  const Ended without =
      run("optimize in -o others" + std::string(quick), "export FOREDRAW_IMPORTER=/nowhere/foredraw-import;");
  EXPECT_EQ(without.code, 0) << without.err;
  EXPECT_THAT(without.err, HasSubstr("is passed by"));
  EXPECT_TRUE(fs::exists(folder_ / "others/spot.glb"));
}

TEST_F(ImportedByProgram, ACacheKnowsTheImportersBuild) {
  fs::create_directories(folder_ / "in");
  testing::put(folder_ / "in/bar.fbx", testing::bending_bar().text());
  fs::copy_file(FOREDRAW_IMPORT_PROGRAM, folder_ / "other-import");
  const std::string optimize = "optimize in -o out --cache cache --report r.json" + std::string(quick);
  const auto is_kept = [&] { return content(folder_ / "r.json").find("\"cached\": true") != std::string::npos; };
  ASSERT_EQ(run(optimize).code, 0);
  EXPECT_FALSE(is_kept());
  ASSERT_EQ(run(optimize).code, 0);
  EXPECT_TRUE(is_kept());
  std::ofstream(folder_ / "other-import", std::ios::app) << "another build";
  ASSERT_EQ(run(optimize, "export FOREDRAW_IMPORTER=./other-import;").code, 0);
  EXPECT_FALSE(is_kept());
}

/// What is left of a file after damage: cut short, bytes changed, pieces moved.
std::string damaged(const std::string& text, std::mt19937& random) {
  std::string made = text;
  const auto below = [&](std::size_t end) { return random() % std::max<std::size_t>(end, 1); };
  switch (random() % 4) {
    case 0: made.resize(below(made.size())); break;
    case 1:
      for (std::size_t k = 0, count = 1 + below(30); k < count; ++k) {
        made[below(made.size())] = static_cast<char>(random());
      }
      break;
    case 2: made.insert(below(made.size()), made.substr(below(made.size()), below(3000))); break;
    default: {
      const std::size_t at = made.find_first_of("0123456789", below(made.size()));
      constexpr std::array numbers{"-1", "4294967295", "1e308", "nan", "99999999999999999999", "2147483648"};
      if (at != std::string::npos) made.replace(at, 1, numbers[below(numbers.size())]);
    }
  }
  return made;
}

void expect_no_end(const fs::path& folder, const std::string& text, std::mt19937& random) {
  testing::put(folder / "damaged.fbx", damaged(text, random));
  const Ended ended = testing::run_program(folder, "optimize damaged.fbx -o made.glb -p 'tipsify' --with vertex-cache",
                                           "export FOREDRAW_IMPORT_SECONDS=20 FOREDRAW_IMPORT_MEMORY=1000000000;");
  EXPECT_THAT(ended.code, ::testing::AnyOf(0, 2)) << ended.err;
  if (ended.code != 2) return;
  EXPECT_THAT(ended.err, HasSubstr("damaged.fbx: error:"));
}

TEST_F(ImportedByProgram, DamagedFilesNeverEndTheProgram) {
  std::mt19937 random(1);
  const std::string text = testing::bending_bar().text();
  for (int i = 0; i < 60; ++i) expect_no_end(folder_, text, random);
}

/// FOREDRAW_FUZZ_RUNS and FOREDRAW_FUZZ_FILE: how many of them (10,000), and of which file.
TEST_F(ImportedByProgram, DamagedFilesNeverEndTheProgramLong) {
  const char* asked = std::getenv("FOREDRAW_FUZZ_RUNS");
  const char* named = std::getenv("FOREDRAW_FUZZ_FILE");
  std::mt19937 random(2);
  const std::string text = named == nullptr ? testing::bending_bar().text() : content(named);
  const int runs = asked == nullptr ? 10'000 : std::atoi(asked);
  for (int i = 0; i < runs && !HasFailure(); ++i) expect_no_end(folder_, text, random);
}

}  // namespace
}  // namespace foredraw::import_faults_test
