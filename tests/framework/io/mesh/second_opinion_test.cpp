// On sound files OpenMesh, an older reader, sees the same triangles as ours.
#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <OpenMesh/Core/IO/reader/OBJReader.hh>
#include <OpenMesh/Core/IO/reader/OFFReader.hh>
#include <OpenMesh/Core/IO/reader/PLYReader.hh>
#include <OpenMesh/Core/IO/reader/STLReader.hh>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "support/mesh_reading.h"
#include "support/meshes.h"
#include "support/test_folder.h"

namespace foredraw::second_opinion_test {
namespace {

using OpenMesh::EdgeHandle;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::Vec2f;
using OpenMesh::Vec3d;
using OpenMesh::Vec3f;
using OpenMesh::Vec3uc;
using OpenMesh::Vec4f;
using OpenMesh::Vec4uc;
using OpenMesh::VertexHandle;
using Status = OpenMesh::Attributes::StatusInfo;

/// Positions and faces as flat arrays, without any half-edges; all else is passed by.
class FlatImporter final : public OpenMesh::IO::BaseImporter {
 public:
  VertexHandle add_vertex(const Vec3f& p) override {
    positions.push_back({p[0], p[1], p[2]});
    return VertexHandle(static_cast<int>(positions.size()) - 1);
  }
  VertexHandle add_vertex() override { return add_vertex(Vec3f(0, 0, 0)); }
  void set_point(VertexHandle v, const Vec3f& p) override { positions[v.idx()] = {p[0], p[1], p[2]}; }
  FaceHandle add_face(const VHandles& corners) override {
    for (const VertexHandle& corner : corners) indices.push_back(static_cast<std::uint32_t>(corner.idx()));
    return FaceHandle(static_cast<int>(indices.size() / 3) - 1);
  }
  std::size_t n_vertices() const override { return positions.size(); }
  std::size_t n_faces() const override { return indices.size() / 3; }

  HalfedgeHandle add_edge(VertexHandle, VertexHandle) override { return HalfedgeHandle(); }
  FaceHandle add_face(HalfedgeHandle) override { return FaceHandle(); }
  void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec2f>&) override {}
  void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec3f>&) override {}
  void set_face_texindex(FaceHandle, int) override {}
  void set_halfedge(VertexHandle, HalfedgeHandle) override {}
  void set_normal(VertexHandle, const Vec3f&) override {}
  void set_normal(VertexHandle, const Vec3d&) override {}
  void set_color(VertexHandle, const Vec3uc&) override {}
  void set_color(VertexHandle, const Vec4uc&) override {}
  void set_color(VertexHandle, const Vec3f&) override {}
  void set_color(VertexHandle, const Vec4f&) override {}
  void set_texcoord(VertexHandle, const Vec2f&) override {}
  void set_status(VertexHandle, const Status&) override {}
  void set_next(HalfedgeHandle, HalfedgeHandle) override {}
  void set_face(HalfedgeHandle, FaceHandle) override {}
  void request_face_texcoords2D() override {}
  void set_texcoord(HalfedgeHandle, const Vec2f&) override {}
  void set_texcoord(VertexHandle, const Vec3f&) override {}
  void set_texcoord(HalfedgeHandle, const Vec3f&) override {}
  void set_status(HalfedgeHandle, const Status&) override {}
  void set_color(EdgeHandle, const Vec3uc&) override {}
  void set_color(EdgeHandle, const Vec4uc&) override {}
  void set_color(EdgeHandle, const Vec3f&) override {}
  void set_color(EdgeHandle, const Vec4f&) override {}
  void set_status(EdgeHandle, const Status&) override {}
  void set_normal(FaceHandle, const Vec3f&) override {}
  void set_normal(FaceHandle, const Vec3d&) override {}
  void set_color(FaceHandle, const Vec3uc&) override {}
  void set_color(FaceHandle, const Vec4uc&) override {}
  void set_color(FaceHandle, const Vec3f&) override {}
  void set_color(FaceHandle, const Vec4f&) override {}
  void set_status(FaceHandle, const Status&) override {}
  void add_texture_information(int, std::string) override {}
  std::size_t n_edges() const override { return 0; }

  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
};

using Triangles = std::vector<std::array<float, 9>>;

/// In the file's sequence.
Triangles triangles(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
  Triangles result(indices.size() / 3);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    for (int k = 0; k < 3; ++k) result[i / 3][3 * (i % 3) + static_cast<std::size_t>(k)] = positions[indices[i]][k];
  }
  return result;
}

std::string text_of(MeshKind kind, const testing::TestMesh& mesh) {
  const std::size_t faces = mesh.indices.size() / 3;
  std::string text;
  if (kind == MeshKind::ply) {
    text = fmt::format(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        mesh.positions.size(), faces);
  }
  if (kind == MeshKind::off) text = fmt::format("OFF\n{} {} 0\n", mesh.positions.size(), faces);
  if (kind == MeshKind::stl) text = "solid torus\n";
  for (const glm::vec3& p : mesh.positions) {
    if (kind != MeshKind::stl) text += fmt::format("{}{} {} {}\n", kind == MeshKind::obj ? "v " : "", p.x, p.y, p.z);
  }
  for (std::size_t f = 0; f < faces; ++f) {
    const std::uint32_t* corners = mesh.indices.data() + 3 * f;
    if (kind == MeshKind::obj) text += fmt::format("f {} {} {}\n", corners[0] + 1, corners[1] + 1, corners[2] + 1);
    if (kind == MeshKind::ply || kind == MeshKind::off) {
      text += fmt::format("3 {} {} {}\n", corners[0], corners[1], corners[2]);
    }
    if (kind != MeshKind::stl) continue;
    text += "facet normal 0 0 1\nouter loop\n";
    for (int k = 0; k < 3; ++k) {
      const glm::vec3 p = mesh.positions[corners[k]];
      text += fmt::format("vertex {} {} {}\n", p.x, p.y, p.z);
    }
    text += "endloop\nendfacet\n";
  }
  return kind == MeshKind::stl ? text + "endsolid torus\n" : text;
}

TEST(MeshSecondOpinion, OpenMeshSeesTheSameTriangles) {
  const testing::TestMesh torus = testing::torus(24, 12);
  for (const MeshKind kind : {MeshKind::obj, MeshKind::ply, MeshKind::off, MeshKind::stl}) {
    const std::string text = text_of(kind, torus);
    const auto ours = testing::read_mesh(kind, text);
    ASSERT_TRUE(ours.scene) << ours.error();
    const Level& level = ours.scene->draws[0].levels[0];

    const testing::TestFolder folder;
    const auto file = folder.path() / ("torus" + std::string(extension_of(kind)));
    std::ofstream(file) << text;
    FlatImporter theirs;
    OpenMesh::IO::Options options;
    OpenMesh::IO::BaseReader& reader =
        kind == MeshKind::obj   ? static_cast<OpenMesh::IO::BaseReader&>(OpenMesh::IO::OBJReader())
        : kind == MeshKind::ply ? static_cast<OpenMesh::IO::BaseReader&>(OpenMesh::IO::PLYReader())
        : kind == MeshKind::off ? static_cast<OpenMesh::IO::BaseReader&>(OpenMesh::IO::OFFReader())
                                : OpenMesh::IO::STLReader();
    ASSERT_TRUE(reader.read(file.string(), theirs, options));

    EXPECT_EQ(triangles(decode_vec3(*level.vertices->find("POSITION")), level.orders[0].indices.view()),
              triangles(theirs.positions, theirs.indices))
        << extension_of(kind);
    EXPECT_EQ(level.vertices->count, theirs.positions.size()) << extension_of(kind);
  }
}

}  // namespace
}  // namespace foredraw::second_opinion_test
