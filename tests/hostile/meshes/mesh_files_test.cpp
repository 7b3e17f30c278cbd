// Mesh files that mean harm, or were harmed on their way: refused in words, or read right; nothing else.
#include <foredraw/io/scene_file.h>

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <set>
#include <sstream>

#include "support/mesh_reading.h"
#include "support/meshes.h"

namespace foredraw::mesh_files_test {
namespace {

namespace fs = std::filesystem;
using testing::read_mesh;

const fs::path folder = testing::project_file("tests/hostile/meshes");

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// "vertices triangles", or the error without the file's name.
std::string outcome(const fs::path& path) {
  Diagnostics diagnostics;
  const auto file = read_scene(path.string(), diagnostics);
  if (file) {
    std::size_t vertices = 0, triangles = 0;
    for (const Draw& draw : file->scene.draws) {
      vertices += draw.levels[0].vertices->count;
      if (draw.topology == Topology::triangles) triangles += draw.levels[0].orders[0].triangle_count();
    }
    return std::to_string(vertices) + ' ' + std::to_string(triangles);
  }
  const testing::MeshRead read{std::nullopt, diagnostics};
  const std::string error = read.error();
  EXPECT_TRUE(error.starts_with(path.string())) << error;
  return error.substr(std::min(path.string().size(), error.size()));
}

TEST(HostileMeshes, OthersFilesAreReadOrRefusedAsExpected) {
  std::istringstream rows(content(folder / "expected.tsv"));
  std::string row;
  std::set<std::string> told;
  while (std::getline(rows, row)) {
    if (row.starts_with('#')) continue;
    const std::string name = row.substr(0, row.find('\t'));
    told.insert(name);
    EXPECT_EQ(outcome(folder / name), row.substr(row.find('\t') + 1)) << name;
  }
  for (const char* from : {"assimp", "trimesh"}) {
    for (const auto& entry : fs::directory_iterator(folder / from)) {
      EXPECT_TRUE(told.contains(from + ("/" + entry.path().filename().string())))
          << entry.path() << " is not in the table";
    }
  }
}

/// Whatever the text, reading it ends, and either gives a scene or says what is wrong, once and with a place.
void read_safely(MeshKind kind, const std::string& text, const std::string& what) {
  const auto read = read_mesh(kind, text);
  std::size_t errors = 0;
  for (const Diagnostic& d : read.diagnostics.all()) errors += d.severity == Severity::error ? 1 : 0;
  EXPECT_EQ(errors, read.scene ? 0u : 1u) << what << ": " << to_text(read.diagnostics);
  if (!read.scene) return;
  for (const Draw& draw : read.scene->draws) {
    for (std::uint32_t index : draw.levels[0].orders[0].indices.view()) {
      ASSERT_LT(index, draw.levels[0].vertices->count) << what;
    }
    for (const VertexStream& stream : draw.levels[0].vertices->base) {
      ASSERT_EQ(stream.count(), draw.levels[0].vertices->count) << what;
    }
  }
}

struct Sample {
  MeshKind kind;
  std::string name, text;
};

std::vector<Sample> samples() {
  std::string stl("solid by its looks alone");
  stl.resize(80, ' ');
  stl += std::string("\2\0\0\0", 4);
  for (char c : {'\1', '\2'}) stl += std::string(12, '\0') + std::string(36, c) + std::string(2, '\0');
  const auto ply = [](const std::string& format) {
    return "ply\nformat " + format +
           " 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
           "property uchar green\nproperty uchar blue\nelement face 1\nproperty list uchar int vertex_indices\n"
           "property list uchar float texcoord\nend_header\n";
  };
  std::string binary;
  for (int v = 0; v < 3; ++v) binary += std::string(12, static_cast<char>('0' + v)) + "rgb";
  binary += std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0\6", 14) + std::string(24, '<');
  return {{MeshKind::obj, "OBJ",
           "mtllib a.mtl\no a\nv 0 0 0 1 1 1\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\ng b\nusemtl c\n"
           "f 1/1/1 2/2/1 3/1/1 4/2/1\nf -4//-1 -3//-1 \\\n-2//-1\nl 1 2\n"},
          {MeshKind::ply, "ASCII PLY", ply("ascii") + "0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n3 0 1 2 6 0 0 1 0 0 1\n"},
          {MeshKind::ply, "binary PLY", ply("binary_little_endian") + binary},
          {MeshKind::ply, "PLY of strips",
           "ply\nformat ascii 1.0\nmade by hand\nelement vertex 4\nproperty float x\nproperty float y\n"
           "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
           "0 0 0\n1 0 0\n0 1 0\n1 1 0\n8 0 1 2 3 -1 3 1 0\n"},
          {MeshKind::off, "OFF of long faces", "OFF4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0\n1\n2\n3 2 1 3 9 9 9\n"},
          {MeshKind::off, "OFF",
           "STCNOFF # a\n3 1 0\n0 0 0 0 0 1 1 2 3 0 0\n1 0 0 0 0 1 1 2 3 1 0\n0 1 0 0 0 1 1 2 3 0 1\n3 0 1 2 9 9 9\n"},
          {MeshKind::stl, "ASCII STL",
           "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
           "0\nendloop\nendfacet\nendsolid a\n"},
          {MeshKind::stl, "binary STL", stl}};
}

TEST(HostileMeshes, TheSamplesAreSound) {
  for (const Sample& sample : samples()) {
    const auto read = read_mesh(sample.kind, sample.text);
    EXPECT_TRUE(read.scene) << sample.name << ": " << read.error();
  }
}

TEST(HostileMeshes, CutOffAtEveryByte) {
  for (const Sample& sample : samples()) {
    for (std::size_t size = 0; size < sample.text.size(); ++size) {
      read_safely(sample.kind, sample.text.substr(0, size), sample.name + " of " + std::to_string(size) + " bytes");
    }
  }
}

TEST(HostileMeshes, EveryBitTurned) {
  for (const Sample& sample : samples()) {
    for (std::size_t bit = 0; bit < 8 * sample.text.size(); ++bit) {
      std::string text = sample.text;
      text[bit / 8] = static_cast<char>(text[bit / 8] ^ (1 << bit % 8));
      read_safely(sample.kind, text, sample.name + " with bit " + std::to_string(bit) + " turned");
    }
  }
}

TEST(HostileMeshes, EveryNumberOfATextSetToOddOnes) {
  const char* numbers[] = {"0",    "1",     "-1", "2147483648", "4294967295", "9223372036854775808", "1e9", "nan",
                           "-inf", "1e999", ""};
  for (const Sample& sample : samples()) {
    if (sample.name.starts_with("binary STL")) continue;
    for (std::size_t at = 0; at < sample.text.size(); ++at) {
      const auto is_digit = [&](std::size_t i) {
        return i < sample.text.size() && sample.text[i] >= '0' && sample.text[i] <= '9';
      };
      if (!is_digit(at) || (at > 0 && is_digit(at - 1))) continue;
      std::size_t end = at;
      while (is_digit(end)) ++end;
      for (const std::string number : numbers) {
        read_safely(sample.kind, sample.text.substr(0, at) + number + sample.text.substr(end),
                    sample.name + " with " + number + " at byte " + std::to_string(at));
      }
    }
  }
}

TEST(HostileMeshes, EveryFourBytesSetToOddNumbers) {
  for (const Sample& sample : samples()) {
    if (!sample.name.starts_with("binary")) continue;
    for (std::size_t at = 0; at + 4 <= sample.text.size(); ++at) {
      for (const std::uint32_t number : {0u, 1u, 0x80000000u, 0xffffffffu, 0x7f800000u, 0x7fc00000u}) {
        std::string text = sample.text;
        std::memcpy(text.data() + at, &number, 4);
        read_safely(sample.kind, text,
                    sample.name + " with " + std::to_string(number) + " at byte " + std::to_string(at));
      }
    }
  }
}

TEST(HostileMeshes, LongLinesAndManyNamesTakeNoLongerThanTheirBytes) {
  std::string face = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf";
  std::string names = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  std::string joined = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3";
  for (int i = 0; i < 100'000; ++i) {
    face += ' ' + std::to_string(i % 3 + 1);
    names += "o " + std::to_string(i % 20'000) + "\nf 1 2 3\n";
    joined += "\\\n";
  }
  read_safely(MeshKind::obj, face, "a face of 100,000 corners");
  std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uint int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1000000";
  for (int i = 0; i < 1'000'000; ++i) ply += " 0";
  read_safely(MeshKind::ply, ply, "a line of a million numbers");
  read_safely(MeshKind::obj, names, "20,000 objects");
  read_safely(MeshKind::obj, joined, "100,000 joined lines");
  std::string vertices = "v 0 0 0\nv 1 0 0\nvt 0 0\n";
  for (int i = 1; i <= 100'000; ++i)
    vertices += "vt 0 0\nf 1/" + std::to_string(i) + " 1/" + std::to_string(i + 1) + " 2/1\n";
  read_safely(MeshKind::obj, vertices, "one position with 100,000 texture coordinates");
}

}  // namespace
}  // namespace foredraw::mesh_files_test
