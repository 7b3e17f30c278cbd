// Wherever memory runs out while a file is read or written, the status says so; nothing leaks, no exception comes out,
// and a file is there whole or not at all.

#include "without_memory.h"

#include <support/test_folder.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace foredraw::testing::files_without_memory_test {
namespace {

namespace fs = std::filesystem;

const std::string source = FOREDRAW_SOURCE_DIR;
constexpr long every = std::numeric_limits<long>::max();

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// 128 triangles with all that a scene of arrays may have.
struct Grid {
  std::vector<float> positions, normals, texcoords;
  std::vector<std::uint32_t> indices;

  Grid() {
    for (std::uint32_t i = 0; i < 81; ++i) {
      const float x = static_cast<float>(i % 9) / 8, y = static_cast<float>(i / 9) / 8;
      positions.insert(positions.end(), {x, y, x * y});
      normals.insert(normals.end(), {0, 0, 1});
      texcoords.insert(texcoords.end(), {x, y});
      if (i % 9 == 8 || i / 9 == 8) continue;
      indices.insert(indices.end(), {i, i + 1, i + 9, i + 9, i + 1, i + 10});
    }
  }
};

class WrittenWithoutMemory : public WithoutMemory {
 protected:
  /// However much memory there is: no file, or all of it.
  void expect_whole_or_none(const foredraw_scene* scene, const std::string& pipeline,
                            const std::vector<std::string>& names) {
    foredraw_scene* changed = nullptr;
    ASSERT_EQ(foredraw_optimize(context_, scene, pipeline.c_str(), &changed, nullptr), FOREDRAW_DONE);
    for (const std::string& name : names) expect_whole_or_none(changed, name);
    foredraw_scene_free(changed);
  }

 private:
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

  const TestFolder own_;
  const fs::path folder_ = own_.path() / "written";
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
  foredraw_scene* scene = nullptr;
  ASSERT_EQ(foredraw_read(context_, path_.c_str(), &scene, nullptr), FOREDRAW_DONE);
  std::vector<std::string> names = {"out.glb", "out.gltf"};
  if (path_.ends_with(".obj") || path_.ends_with(".ply")) names.push_back("out" + path_.substr(path_.size() - 4));
  expect_whole_or_none(scene, "weld, tipsify, vertex-fetch", names);
  foredraw_scene_free(scene);
}

INSTANTIATE_TEST_SUITE_P(
    Files, FilesWithoutMemory,
    ::testing::Values("benchmarks/corpus/static/spot.glb", "benchmarks/corpus/animated/cesium_man_notex.glb",
                      "tests/compressed/robot.glb", "tests/compressed/rover.glb", "tests/compressed/spot_fallback.gltf",
                      "tests/hostile/meshes/assimp/concave_polygon.obj", "tests/hostile/meshes/assimp/issue623.ply"),
    [](const auto& file) { return fs::path(file.param).stem().string(); });

/// Two draws, and what extensions hold of them.
TEST_F(WrittenWithoutMemory, ArraysAreNotWritten) {
  const Grid grid;
  const foredraw_stream streams[] = {{"NORMAL", grid.normals.data(), 0, FOREDRAW_FLOAT32, 3, 0},
                                     {"TEXCOORD_0", grid.texcoords.data(), 0, FOREDRAW_FLOAT32, 2, 0}};
  foredraw_draw draws[2]{};
  for (foredraw_draw& draw : draws) {
    draw.size = sizeof draw;
    draw.name = "a name of more than fifteen characters";
    draw.vertex_count = static_cast<std::uint32_t>(grid.positions.size() / 3);
    draw.triangle_count = grid.indices.size() / 3;
    draw.indices = grid.indices.data();
    draw.positions = grid.positions.data();
    draw.streams = streams;
    draw.stream_count = 2;
  }
  foredraw_scene* scene = nullptr;
  ASSERT_EQ(foredraw_make_scene(context_, draws, 2, &scene, nullptr), FOREDRAW_DONE);
  expect_whole_or_none(scene, "weld, tipsify, vertex-fetch", {"out.glb", "out.gltf"});
  expect_whole_or_none(scene, "weld, quadric-collapse, levels(keep-sequences=true)", {"out.glb"});
  const std::string map = source + "/benchmarks/corpus/particles/kenney_dirt_03.png";
  expect_whole_or_none(scene, "displacement(map=\"" + map + "\"), tessellation-levels, vertex-pack", {"out.glb"});
  foredraw_scene_free(scene);
}

/// Materials with textures become glTF's.
TEST_F(WrittenWithoutMemory, TexturedMeshesAreNotWritten) {
  const TestFolder own;
  const fs::path& folder = own.path();
  fs::copy_file(source + "/benchmarks/corpus/particles/kenney_dirt_03.png", folder / "dirt.png",
                fs::copy_options::overwrite_existing);
  std::ofstream(folder / "mesh.mtl") << "newmtl dirt\nKd 1 0.5 0.2\nmap_Kd dirt.png\nnewmtl plain\nKd 0 0 1\n";
  std::ofstream(folder / "mesh.obj") << "mtllib mesh.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                                        "usemtl dirt\nf 1/1 2/2 3/3\nusemtl plain\nf 3/1 2/2 4/3\n";
  foredraw_scene* scene = nullptr;
  ASSERT_EQ(foredraw_read(context_, (folder / "mesh.obj").string().c_str(), &scene, nullptr), FOREDRAW_DONE);
  expect_whole_or_none(scene, "weld, tipsify", {"out.glb", "out.gltf", "out.obj"});
  foredraw_scene_free(scene);
}

TEST_F(WrittenWithoutMemory, SpritesAreNotWritten) {
  const std::string atlas = source + "/benchmarks/corpus/particles/atlas_playcanvas_bonus.json";
  foredraw_scene* scene = nullptr;
  ASSERT_EQ(foredraw_read(context_, atlas.c_str(), &scene, nullptr), FOREDRAW_DONE);
  expect_whole_or_none(scene, "particle-trim", {"out.json", "out.glb"});
  foredraw_scene_free(scene);
}

}  // namespace
}  // namespace foredraw::testing::files_without_memory_test
