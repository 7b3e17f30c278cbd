// Meshes written back to their own kind: what moved has moved, and nothing else.
#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/scene_file.h>

#include <foredraw/scene/reorder.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/mesh_reading.h"

namespace foredraw::mesh_write_test {
namespace {

using testing::drawn;
using testing::read_mesh;
using testing::reversed;

struct Written {
  std::string text;
  std::string told;   ///< codes
  std::string error;  ///< the first one's
};

Written write(const Scene& scene, MeshKind kind) {
  Diagnostics diagnostics;
  Written written;
  const auto file = encode_mesh_file(scene, kind, "out" + std::string(extension_of(kind)), diagnostics);
  for (const Diagnostic& d : diagnostics.all()) {
    if (d.severity == Severity::error)
      written.error = d.message;
    else
      written.told += (written.told.empty() ? "" : " ") + d.code;
  }
  if (file) written.text = testing::text_of(*file);
  return written;
}

Scene read(MeshKind kind, const std::string& text) {
  auto made = read_mesh(kind, text);
  if (!made.scene) throw std::runtime_error(made.error());
  return *made.scene;
}

/// Reads, turns all round, writes, and looks whether the same is drawn.
std::string turned_round(MeshKind kind, const std::string& text) {
  const Scene scene = read(kind, text);
  EXPECT_EQ(write(scene, kind).text, text) << "nothing moved";
  const Written written = write(reversed(scene), kind);
  EXPECT_EQ(written.error, "");
  EXPECT_EQ(drawn(read(kind, written.text)), drawn(scene)) << written.text;
  return written.text;
}

TEST(MeshWrite, ObjFacesAndRecordsMoveAndTheRestStays) {
  EXPECT_EQ(turned_round(MeshKind::obj,
                         "# made by hand\nmtllib a.mtl\nv 0 0 0 # first\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 1\n"
                         "usemtl a\nmystery 7\nf 1/1 2/2 3/1 # one\nf -3/-2 -1/-1 -2/-2\nl 1 2\nl -1 -2"),
            "# made by hand\nmtllib a.mtl\nv 1 1 0\nv 1 0 0\nv 0 1 0\nv 0 0 0 # first\nvt 1 1\nvt 0 0\n"
            "usemtl a\nmystery 7\nf 2/2 1/1 3/2\nf 4/2 2/1 3/2 # one\nl 4 2\nl 1 3");
}

TEST(MeshWrite, ObjFacesTakeTheirSmoothingGroupsAlong) {
  EXPECT_EQ(
      turned_round(MeshKind::obj,
                   "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\ns 1\nf 2 3 1\ns 2\nf 3 1 2\ns 1\nl 1 2\nf 3 2 1\n"),
      "v 0 1 0\nv 1 0 0\nv 0 0 0\ns 1\nf 1 2 3\ns 1\ns 2\nf 1 3 2\ns 2\ns 1\nf 2 1 3\ns 1\nl 3 2\ns off\nf 3 2 1\n");
}

TEST(MeshWrite, ObjFacesStayInTheirObjectsAndRecordsInTheirBlocks) {
  const std::string made = turned_round(MeshKind::obj,
                                        "o a\r\nv 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\nf 1 3 2\r\n"
                                        "o b\r\nv 0 0 1\r\nv 1 0 1\r\nv 0 1 1\r\nf 4 5 6\r\nf 4 6 5\r\n");
  EXPECT_LT(made.find("f 3 2 1"), made.find("o b"));
  EXPECT_GT(made.find("v 0 0 1"), made.find("o b"));
}

TEST(MeshWrite, ObjFacesMayNotComeBeforeTheirVertices) {
  const Scene scene = read(MeshKind::obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nv 1 1 0\nf 2 3 4\n");
  EXPECT_NE(write(reversed(scene), MeshKind::obj).error.find("would come before a vertex"), std::string::npos);
}

TEST(MeshWrite, ObjLinesAreNotRepeatedWithoutBound) {
  const std::string one = "g " + std::string(20'000, 'a') + '\n', two = "g " + std::string(20'000, 'b') + '\n';
  std::string text = "o all\nv 0 0 0\nv 1 0 0\nv 0 1 0\n" + one;
  for (int i = 0; i < 400; ++i) text += "f 1 2 3\n";
  text += two;
  for (int i = 0; i < 400; ++i) text += "f 1 2 3\n";
  const Scene scene = read(MeshKind::obj, text);
  Scene mixed = scene;
  IndexOrder order;
  for (std::uint32_t i = 0; i < 400; ++i) order.insert(order.end(), {i, i + 400});
  mixed.draws[0] = with_triangle_order(mixed.draws[0], order);
  EXPECT_THAT(write(mixed, MeshKind::obj).error, ::testing::HasSubstr("repeated lines of groups and materials"));
}

TEST(MeshWrite, ObjPolygonsStayWhole) {
  const Scene scene = read(MeshKind::obj, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nf 1 2 3 4\nf 1 2 5\n");
  Scene torn = scene;
  torn.draws[0] = with_triangle_order(scene.draws[0], IndexOrder{1, 2, 0});
  const Written written = write(torn, MeshKind::obj);
  EXPECT_EQ(written.told, "polygons-stay-whole");
  EXPECT_NE(written.text.find("f 1 2 3 4\nf 1 2 5\n"), std::string::npos);
}

const std::string ascii_ply =
    "ply\nformat ascii 1.0\ncomment kept\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "property int id\nelement face 2\nproperty list uchar int vertex_indices\nproperty int id\nend_header\n"
    "0 0 0 10\n1 0 0 11\n1 1 0 12\n0 1 0 13\n4 0 1 2 3 20\n3 0 1 2 21\n";

TEST(MeshWrite, PlyRecordsMoveWithAllTheirProperties) {
  const std::string made = turned_round(MeshKind::ply, ascii_ply);
  EXPECT_EQ(made.substr(made.find("end_header")),
            "end_header\n0 1 0 13\n1 1 0 12\n1 0 0 11\n0 0 0 10\n3 3 2 1 21\n4 3 2 1 0 20\n");
}

TEST(MeshWrite, BinaryPlyInBothByteOrders) {
  for (const bool big : {false, true}) {
    std::string text =
        std::string("ply\nformat binary_") + (big ? "big" : "little") +
        "_endian 1.0\nelement vertex 3\nproperty uchar x\nproperty uchar y\nproperty uchar z\nelement face 2\n"
        "property list uchar ushort vertex_index\nproperty uchar id\nend_header\n";
    text += std::string("\0\0\0\1\0\0\0\1\0", 9);
    const auto face = [&](char a, char b, char c, char id) {
      text += '\3';
      for (char corner : {a, b, c}) text += big ? std::string{'\0', corner} : std::string{corner, '\0'};
      text += id;
    };
    face(0, 1, 2, 'a');
    face(2, 1, 0, 'b');
    const std::string made = turned_round(MeshKind::ply, text);
    EXPECT_EQ(made.size(), text.size());
    EXPECT_EQ(made.back(), 'a');
  }
}

TEST(MeshWrite, PlyIsRefusedWhereNumbersWouldNoLongerFit) {
  std::string edges = ascii_ply;
  edges.replace(edges.find("end_header"), 0, "element edge 1\nproperty int vertex1\nproperty int vertex2\n");
  edges += "0 1\n";
  EXPECT_EQ(write(read(MeshKind::ply, edges), MeshKind::ply).text, edges);
  EXPECT_NE(write(reversed(read(MeshKind::ply, edges)), MeshKind::ply).error.find("element 'edge'"), std::string::npos);

  std::string narrow =
      "ply\nformat ascii 1.0\nelement vertex 300\nproperty float x\nproperty float y\nproperty float z\nelement face "
      "1\n"
      "property list uchar uchar vertex_indices\nend_header\n";
  for (int i = 0; i < 300; ++i) narrow += std::to_string(i) + " 0 0\n";
  narrow += "3 0 1 2\n";
  EXPECT_NE(write(reversed(read(MeshKind::ply, narrow)), MeshKind::ply).error.find("too narrow"), std::string::npos);
}

TEST(MeshWrite, PlyValuesThatAreNotUsedStayAsTheyAre) {
  const std::string made = turned_round(
      MeshKind::ply,
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property float q\nelement face 2\nproperty list uchar int vertex_indices\nproperty float q\nend_header\n"
      "0 0 0 inf\n1 0 0 1e99\n0 1 0 1.#QNAN\n3 0 1 2 nan\n3 2 1 0 1000\nand more\n");
  EXPECT_EQ(made.substr(made.find("end_header")),
            "end_header\n0 1 0 1.#QNAN\n1 0 0 1e99\n0 0 0 inf\n3 0 1 2 1000\n3 2 1 0 nan\nand more\n");
}

TEST(MeshWrite, ASecondListOfAPlysCornersStaysWhileVerticesDo) {
  std::string two = ascii_ply;
  two.replace(two.find("end_header"), 0, "property list uchar int vertex_index\n");
  two.replace(two.find("20\n"), 3, "20 3 3 2 1\n");
  two.replace(two.find("21\n"), 3, "21 0\n");
  const Scene scene = read(MeshKind::ply, two);
  EXPECT_EQ(write(scene, MeshKind::ply).text, two);
  Scene faces_moved = scene;
  faces_moved.draws[0] = with_triangle_order(scene.draws[0], IndexOrder{2, 0, 1});
  EXPECT_THAT(write(faces_moved, MeshKind::ply).text, ::testing::EndsWith("3 0 1 2 21 0\n4 0 1 2 3 20 3 3 2 1\n"));
  EXPECT_THAT(write(reversed(scene), MeshKind::ply).error,
              ::testing::HasSubstr("'vertex_index' names vertices besides"));
}

TEST(MeshWrite, PlyStripsBecomeAListOfFaces) {
  const auto header = [](const std::string& format, const std::string& line_end) {
    std::string text = "ply\nformat " + format +
                       " 1.0\nelement vertex 5\nproperty uchar x\nproperty uchar y\nproperty uchar z\n"
                       "element tristrips 2\nproperty list uchar int vertex_indices\ncomment last\nend_header\n";
    for (std::size_t at = text.find('\n'); at != text.npos; at = text.find('\n', at + line_end.size()))
      text.replace(at, 1, line_end);
    return text;
  };
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n5 5 5\n";
  const std::string made =
      turned_round(MeshKind::ply, header("ascii", "\r\n") + vertices + "6 0 1 2 3 -1 4\n3 4 1 0\nand more\n");
  EXPECT_THAT(made,
              ::testing::HasSubstr("z\r\nelement face 3\r\nproperty list uchar int vertex_indices\r\ncomment last\r"));
  EXPECT_THAT(made, ::testing::EndsWith("\n0 0 0\n3 0 3 4\n3 2 3 1\n3 4 3 2\nand more\n"));

  for (const bool big : {false, true}) {
    std::string binary = header(big ? "binary_big_endian" : "binary_little_endian", "\n");
    for (char v = 0; v < 5; ++v) binary += std::string{v, static_cast<char>(v * v), '\0'};
    const auto strip = [&](const std::vector<char>& numbers) {
      binary += static_cast<char>(numbers.size());
      for (const char number : numbers) {
        const std::string high(3, number < 0 ? '\xFF' : '\0');
        binary += big ? high + number : number + high;
      }
    };
    strip({0, 1, 2, 3, -1, 4});
    strip({4, 1, 0});
    turned_round(MeshKind::ply, binary);
  }

  std::string both = header("ascii", "\n");
  both.replace(both.find("element tri"), 0, "element face 1\nproperty list uchar int vertex_indices\n");
  both += vertices + "3 0 1 4\n4 0 1 2 3\n3 4 1 0\n";
  EXPECT_EQ(write(read(MeshKind::ply, both), MeshKind::ply).text, both);
  EXPECT_THAT(write(reversed(read(MeshKind::ply, both)), MeshKind::ply).error,
              ::testing::HasSubstr("element 'tristrips' may refer"));
}

TEST(MeshWrite, MendedFilesKeepWhatIsWrongInThem) {
  EXPECT_EQ(turned_round(MeshKind::obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/7/8 2//9 3/1\nf 3/1/1 2/1/1 1/1/1\n"),
            "v 0 1 0\nv 1 0 0\nv 0 0 0\nf 1/1/1 2/1/1 3/1/1\nf 3/7/8 2//9 1/1\n");
  const std::string ply =
      turned_round(MeshKind::ply,
                   "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                   "property float q\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
                   "0 0 0\n1 0 0 5 6\n0 1 0 7\n3 0 1 2 9 9\n3 2 1 0\n");
  EXPECT_THAT(ply, ::testing::EndsWith("\n0 1 0 7\n1 0 0 5 6\n0 0 0\n3 0 1 2\n3 2 1 0 9 9\n"));
  EXPECT_EQ(turned_round(MeshKind::off, "OFF3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0\n1 # one\n2 # two\n3 2 1 0 9\n"),
            "OFF3 2 0\n0 1 0\n1 0 0\n0 0 0\n3 0 1 2 9 # two\n3 2\n1 # one\n0\n");
}

TEST(MeshWrite, OffLinesMoveWithWhatIsOnThem) {
  EXPECT_EQ(
      turned_round(MeshKind::off, "OFF\n# head\n4 2 0\n0 0 0\n1 0 0 # b\n\n1 1 0\n0 1 0\n4 0 1 2 3  1 0 0\n3 0 1 2"),
      "OFF\n# head\n4 2 0\n0 1 0\n1 1 0 # b\n\n1 0 0\n0 0 0\n3 3 2 1\n4 3 2 1 0  1 0 0");
}

TEST(MeshWrite, AByteOrderMarkStays) {
  const std::string mark = "\xEF\xBB\xBF";
  EXPECT_EQ(turned_round(MeshKind::ply, mark + ascii_ply).substr(0, 6), mark + "ply");
  EXPECT_EQ(turned_round(MeshKind::off, mark + "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").substr(0, 6),
            mark + "OFF");
  EXPECT_EQ(turned_round(MeshKind::obj, mark + "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
            mark + "v 0 1 0\nv 1 0 0\nv 0 0 0\nf 3 2 1\n");
}

TEST(MeshWrite, StlTrianglesMoveWithinTheirSolid) {
  const auto facet = [](const std::string& z, const std::string& note) {
    return "facet normal " + note + " 0 1\nouter loop\nvertex 0 0 " + z + "\nvertex 1 0 " + z + "\nvertex 0 1 " + z +
           "\nendloop\nendfacet\n";
  };
  EXPECT_EQ(turned_round(MeshKind::stl, "solid facet\n" + facet("1", "a") + facet("2", "b") +
                                            "endsolid facet\nsolid x\n" + facet("3", "c") + "endsolid\n"),
            "solid facet\n" + facet("2", "b") + facet("1", "a") + "endsolid facet\nsolid x\n" + facet("3", "c") +
                "endsolid\n");

  for (const char* note : {"solid", "facet", "endfacet", "endsolid"}) {  // a normal is read over, whatever it is
    turned_round(MeshKind::stl, "solid\n" + facet("1", note) + facet("2", "b") + "endsolid\n");
  }

  turned_round(MeshKind::stl, "solid a " + facet("1", "a") + facet("2", "b") + "endsolid a");

  turned_round(MeshKind::stl, "\xEF\xBB\xBFsolid facet\n" + facet("1", "a") + facet("2", "b") + "endsolid\n");

  std::string binary(80, ' ');
  binary += std::string("\2\0\0\0", 4);
  for (const char* name : {"ab", "cd"}) binary += std::string(12, '\1') + std::string(36, name[0]) + name;
  const std::string made = turned_round(MeshKind::stl, binary);
  EXPECT_EQ(made.substr(made.size() - 2), "ab") << "attribute bytes go with their triangle";
}

TEST(MeshWrite, MergedAndUnusedVerticesStayInTheFile) {
  Scene scene = read(MeshKind::off, "OFF\n5 1 0\n7 7 7\n0 0 0\n1 0 0\n0 1 0\n0 0 0\n3 1 2 3\n");
  const auto group = vertex_groups(scene).front();
  move_vertices(scene, group, std::vector<std::uint32_t>{no_vertex, 2, 1, 0, 2}, 3);
  const Written written = write(scene, MeshKind::off);
  EXPECT_EQ(written.told, "vertices-stay");
  EXPECT_EQ(written.text, "OFF\n5 1 0\n0 1 0\n1 0 0\n0 0 0\n0 0 0\n7 7 7\n3 2 1 0\n");
}

TEST(MeshWrite, TheSequenceOfDrawsStaysAndSaysSo) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\no both\nusemtl a\nf 1 2 3\nusemtl b\nf 3 2 1\n";
  Scene scene = read(MeshKind::obj, text);
  ASSERT_EQ(scene.meshes.at(0).draws.size(), 2u);
  std::ranges::reverse(scene.meshes[0].draws);
  const Written written = write(scene, MeshKind::obj);
  EXPECT_EQ(written.error, "");
  EXPECT_EQ(written.told, "sequence-stays");
  EXPECT_EQ(written.text, text);
}

TEST(MeshWrite, MoreThanOrderIsRefused) {
  const Scene scene = read(MeshKind::off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  Scene moved = scene;
  VertexStreams streams = *moved.draws[0].levels[0].vertices;
  std::vector<std::byte> bytes(streams.base[0].bytes.view().begin(), streams.base[0].bytes.view().end());
  bytes[3] = std::byte{0x40};
  streams.base[0].bytes = Shared<std::byte>(bytes);
  moved.draws[0].levels[0].vertices = std::make_shared<const VertexStreams>(streams);
  EXPECT_NE(write(moved, MeshKind::off).error.find("more than the order"), std::string::npos);

  Scene rotated = scene;  // the same triangle, begun at another corner: no order of triangles says that
  rotated.draws[0].levels[0].orders[0].indices = Shared<std::uint32_t>({1, 2, 0});
  EXPECT_NE(write(rotated, MeshKind::off).error.find("more than the order"), std::string::npos);

  Scene without = scene;
  without.draws.clear();
  EXPECT_NE(write(without, MeshKind::off).error.find("more than the order"), std::string::npos);
  EXPECT_NE(write(scene, MeshKind::stl).error.find("only a scene that was read from .stl"), std::string::npos);
}

TEST(MeshWrite, AsGltfAMeshKeepsNamesMaterialsAndTriangles) {
  const Scene scene =
      read(MeshKind::obj,
           "v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\no caf\xE9\nusemtl red\nf 1/1/1 2/1/1 3/1/1\n"
           "usemtl blue\nf 1 2 3\no empty\n");
  Diagnostics diagnostics;
  const auto files = encode_scene(scene, "out.glb", diagnostics);
  ASSERT_TRUE(files) << to_text(diagnostics);
  const auto again = read_gltf(files->front().bytes, "out.glb", {}, diagnostics);
  ASSERT_TRUE(again) << to_text(diagnostics);
  EXPECT_EQ(drawn(*again).size(), 2u);
  EXPECT_EQ(again->meshes[0].name, "caf\xC3\xA9") << "Latin-1 became UTF-8";
  EXPECT_EQ(again->material_of(again->draws[1])->name, "blue");
  EXPECT_EQ(again->nodes.size(), 1u);
}

TEST(MeshWrite, AnyMeshCanBeWrittenAsAnyKindOfMeshFile) {
  Diagnostics diagnostics;
  EXPECT_TRUE(can_write_scene("a/out.OBJ", "in.obj", diagnostics));
  EXPECT_TRUE(can_write_scene("out.glb", "in.stl", diagnostics));
  EXPECT_TRUE(can_write_scene("out.ply", "in.obj", diagnostics));
  EXPECT_TRUE(can_write_scene("out.obj", "in.glb", diagnostics));
  EXPECT_TRUE(can_write_scene("out.stl", "-", diagnostics));
  EXPECT_TRUE(diagnostics.empty());
  EXPECT_FALSE(can_write_scene("out.fbx", "in.fbx", diagnostics));
  EXPECT_FALSE(can_write_scene("out.obj", "in.png", diagnostics));
}

}  // namespace
}  // namespace foredraw::mesh_write_test
