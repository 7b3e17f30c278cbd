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

class WrittenWithoutMemory : public WithoutMemory {
 protected:
  ~WrittenWithoutMemory() override { fs::remove_all(folder_); }

  /// However much memory there is: no file, or all of it.
  void expect_whole_or_none(const foredraw_scene* scene, const std::string& name) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    const fs::path output = folder_ / name;
    std::string whole;
    expect_survives(
        [&] {
          fs::remove(output);
          const int status = foredraw_write(context_, scene, output.c_str(), nullptr);
          left = -1;  // to look at it takes memory, too
          const std::string written = bytes_of(output);
          if (whole.empty()) whole = written;
          EXPECT_TRUE(written == whole || (status != FOREDRAW_DONE && written.empty()));
          return status;
        },
        every);
  }

 private:
  const fs::path folder_ = fs::temp_directory_path() / ("foredraw_" + std::to_string(::getpid()));
};

/// Files that differ in what their reader has to do.
class FilesWithoutMemory : public WrittenWithoutMemory, public ::testing::WithParamInterface<const char*> {
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
  foredraw_scene *scene = nullptr, *changed = nullptr;
  ASSERT_EQ(foredraw_read(context_, path_.c_str(), &scene, nullptr), FOREDRAW_DONE);
  ASSERT_EQ(foredraw_optimize(context_, scene, "weld, tipsify, vertex-fetch", &changed, nullptr), FOREDRAW_DONE);
  for (const char* name : {"out.glb", "out.gltf"}) expect_whole_or_none(changed, name);
  if (path_.ends_with(".obj") || path_.ends_with(".ply"))
    expect_whole_or_none(changed, "out" + path_.substr(path_.size() - 4));
  foredraw_scene_free(changed);
  foredraw_scene_free(scene);
}

INSTANTIATE_TEST_SUITE_P(
    Files, FilesWithoutMemory,
    ::testing::Values("benchmarks/corpus/static/spot.glb", "benchmarks/corpus/animated/cesium_man_notex.glb",
                      "tests/compressed/robot.glb", "tests/compressed/rover.glb", "tests/compressed/spot_fallback.gltf",
                      "tests/hostile/meshes/assimp/concave_polygon.obj", "tests/hostile/meshes/assimp/issue623.ply"),
    [](const auto& file) { return fs::path(file.param).stem().string(); });

/// Two draws with all that a scene of arrays may have.
TEST_F(WrittenWithoutMemory, ArraysAreNotWritten) {
  const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  const float normals[] = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  const float texcoords[] = {0, 0, 1, 0, 0, 1, 1, 1};
  const std::uint32_t indices[] = {0, 1, 2, 2, 1, 3};
  const foredraw_stream streams[] = {{"NORMAL", normals, 0, FOREDRAW_FLOAT32, 3, 0},
                                     {"TEXCOORD_0", texcoords, 0, FOREDRAW_FLOAT32, 2, 0}};
  foredraw_draw draws[2]{};
  for (foredraw_draw& draw : draws) {
    draw.size = sizeof draw;
    draw.vertex_count = 4;
    draw.triangle_count = 2;
    draw.indices = indices;
    draw.positions = positions;
    draw.streams = streams;
    draw.stream_count = 2;
  }
  foredraw_scene *scene = nullptr, *changed = nullptr;
  ASSERT_EQ(foredraw_make_scene(context_, draws, 2, &scene, nullptr), FOREDRAW_DONE);
  ASSERT_EQ(foredraw_optimize(context_, scene, "weld, tipsify, vertex-fetch", &changed, nullptr), FOREDRAW_DONE);
  for (const char* name : {"out.glb", "out.gltf"}) expect_whole_or_none(changed, name);
  foredraw_scene_free(changed);
  foredraw_scene_free(scene);
}

}  // namespace
}  // namespace foredraw::testing
