// Wherever memory runs out while a file is read or written, the status says so; nothing leaks, no exception comes out,
// and a file is there whole or not at all.

#include "without_memory.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>

namespace foredraw::testing {
namespace {

namespace fs = std::filesystem;

const std::string source = FOREDRAW_SOURCE_DIR;
constexpr long every = std::numeric_limits<long>::max();

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Files that differ in what their reader has to do.
class FilesWithoutMemory : public WithoutMemory, public ::testing::WithParamInterface<const char*> {
 protected:
  const std::string path_ = source + '/' + GetParam();
};

TEST_P(FilesWithoutMemory, AreNotRead) {
  expect_survives(
      [&] {
        foredraw_scene* scene = nullptr;
        foredraw_text text{};
        const int status = foredraw_read(context_, path_.c_str(), &scene, &text);
        EXPECT_EQ(scene != nullptr, status == FOREDRAW_DONE);
        foredraw_scene_free(scene);
        foredraw_text_free(&text);
        return status;
      },
      every);
}

TEST_P(FilesWithoutMemory, AreNotReadInMemory) {
  if (!path_.ends_with(".glb")) GTEST_SKIP() << "is not read from memory";
  const std::string bytes = bytes_of(path_);
  expect_survives([&] {
    foredraw_scene* scene = nullptr;
    const int status = foredraw_read_memory(context_, bytes.data(), bytes.size(), "model.glb", &scene, nullptr);
    foredraw_scene_free(scene);
    return status;
  });
}

TEST_P(FilesWithoutMemory, AreNotWritten) {
  if (path_.find(".gl") == std::string::npos) GTEST_SKIP() << "what was no glTF ends the program: docs/c-library.md";
  const fs::path folder = fs::temp_directory_path() / ("foredraw_" + std::to_string(::getpid()));
  foredraw_scene *scene = nullptr, *changed = nullptr;
  ASSERT_EQ(foredraw_read(context_, path_.c_str(), &scene, nullptr), FOREDRAW_DONE);
  ASSERT_EQ(foredraw_optimize(context_, scene, "weld, tipsify, vertex-fetch", &changed, nullptr), FOREDRAW_DONE);
  for (const char* name : {"out.glb", "out.gltf"}) {
    fs::remove_all(folder);
    fs::create_directories(folder);
    const fs::path output = folder / name;
    std::string whole;
    expect_survives(
        [&] {
          fs::remove(output);
          const int status = foredraw_write(context_, changed, output.c_str(), nullptr);
          left = -1;  // to look at it takes memory, too
          const std::string written = bytes_of(output);
          if (whole.empty()) whole = written;
          EXPECT_TRUE(written == whole || (status != FOREDRAW_DONE && written.empty()));
          return status;
        },
        every);
  }
  fs::remove_all(folder);
  foredraw_scene_free(changed);
  foredraw_scene_free(scene);
}

INSTANTIATE_TEST_SUITE_P(
    Files, FilesWithoutMemory,
    ::testing::Values("benchmarks/corpus/static/spot.glb", "benchmarks/corpus/animated/cesium_man_notex.glb",
                      "tests/compressed/robot.glb", "tests/compressed/rover.glb", "tests/compressed/spot_fallback.gltf",
                      "tests/hostile/meshes/assimp/concave_polygon.obj", "tests/hostile/meshes/assimp/issue623.ply"),
    [](const auto& file) { return fs::path(file.param).stem().string(); });

}  // namespace
}  // namespace foredraw::testing
