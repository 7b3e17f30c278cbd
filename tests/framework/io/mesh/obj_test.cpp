// What an OBJ says becomes the scene that people expect, or is refused with its line.
#include <gtest/gtest.h>

#include "support/mesh_reading.h"

namespace foredraw::obj_test {
namespace {

using testing::read_mesh;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Scene read(const std::string& text) {
  auto made = read_mesh(MeshKind::obj, text);
  if (!made.scene) throw std::runtime_error(made.error());
  return *made.scene;
}

std::string error(const std::string& text) { return read_mesh(MeshKind::obj, text).error(); }

const VertexStreams& vertices(const Scene& scene, DrawId draw = 0) { return *scene.draws.at(draw).levels[0].vertices; }
std::vector<std::uint32_t> indices(const Scene& scene, DrawId draw = 0) {
  const auto view = scene.draws.at(draw).levels[0].orders[0].indices.view();
  return {view.begin(), view.end()};
}

TEST(MeshObj, AQuadIsTwoTrianglesWoundAsItWas) {
  const Scene scene = read(square + "f 1 2 3 4\n");
  EXPECT_EQ(indices(scene), (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(decode_vec3(*vertices(scene).find("POSITION"))[2], glm::vec3(1, 1, 0));
  ASSERT_EQ(scene.nodes.size(), 1u);
  EXPECT_EQ(scene.meshes[0].name, "input");
  EXPECT_TRUE(scene.draws[0].traits.has(traits::triangles));
}

TEST(MeshObj, CornersThatDifferInTextureOrNormalAreVerticesOfTheirOwn) {
  const std::string corners = "vt 0 0\nvt 1 0.25\nvn 0 0 1\nvn 0 1 0\n";
  const Scene seam = read(square + corners + "f 1/1/1 2/1/1 3/1/1\nf 1/2/1 3/1/1 4/1/1\nf 1/1/2 3/1/2 4/1/2\n");
  EXPECT_EQ(vertices(seam).count, 3u + 2u + 3u);
  EXPECT_EQ(indices(seam), (std::vector<std::uint32_t>{0, 1, 2, 3, 2, 4, 5, 6, 7})) << "in the sequence of first use";
  // OBJ counts v from below, glTF from above.
  EXPECT_EQ(decode_component(*vertices(seam).find("TEXCOORD_0"), 3, 1), 0.75f);
}

TEST(MeshObj, NegativeIndicesCountFromTheLineTheyStandIn) {
  const Scene scene = read("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -4 -3 -2\n");
  EXPECT_EQ(indices(scene), (std::vector<std::uint32_t>{0, 1, 2, 0, 1, 2}));
  EXPECT_EQ(decode_vec3(*vertices(scene).find("POSITION"))[0], glm::vec3(0));
  EXPECT_EQ(error(square + "f 1 2 -5\n"), "input.obj:5:7: error: names record -5, but the file has 4 so far");
}

TEST(MeshObj, RecordsMayComeAfterTheFace) { EXPECT_EQ(vertices(read("f 1 2 3\n" + square)).count, 3u); }

TEST(MeshObj, ThreeTrianglesOnAnEdgeStay) {
  EXPECT_EQ(indices(read(square + "v 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 2 5\n")).size(), 9u);
}

TEST(MeshObj, ObjectsAreMeshesAndMaterialsAreDraws) {
  const Scene scene = read(square +
                           "o left\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\ng part\nusemtl red\nf 1 2 4\n"
                           "o right\nf 2 3 4\n");
  ASSERT_EQ(scene.meshes.size(), 2u);
  EXPECT_EQ(scene.meshes[0].name, "left");
  ASSERT_EQ(scene.draws.size(), 3u);
  EXPECT_EQ(scene.draws[0].name, "left/0");
  EXPECT_EQ(indices(scene, 0).size(), 6u) << "a group does not part where there are objects";
  EXPECT_EQ(scene.draws[2].name, "right");
  EXPECT_EQ(scene.material_of(scene.draws[1])->name, "blue");
  EXPECT_EQ(scene.material_of(scene.draws[2])->name, "red");
  EXPECT_EQ(scene.nodes.size(), 2u);
}

TEST(MeshObj, WithoutObjectsGroupsAreMeshes) {
  EXPECT_EQ(read(square + "g a\nf 1 2 3\ng b\nf 1 3 4\n").meshes.at(1).name, "b");
}

TEST(MeshObj, FacesWithAndWithoutTextureAreDrawsOfTheirOwn) {
  const Scene scene = read(square + "vt 0 0\nf 1/1 2/1 3/1\nf 1 3 4\nf 1/1 2 3\n");
  ASSERT_EQ(scene.draws.size(), 2u);
  EXPECT_TRUE(scene.draws[0].traits.has(traits::uv0));
  EXPECT_EQ(vertices(scene, 1).find("TEXCOORD_0"), nullptr) << "nothing is made up";
}

TEST(MeshObj, ColorsOfVerticesStay) {
  const Scene scene = read("v 0 0 0 1 0.5 0\nv 1 0 0\nv 0 1 0 0 0 1\nf 1 2 3\n");
  const VertexStream* colors = vertices(scene).find("COLOR_0");
  ASSERT_NE(colors, nullptr);
  EXPECT_EQ(decode_component(*colors, 0, 1), 0.5f);
  EXPECT_EQ(decode_component(*colors, 1, 0), 1.0f) << "white where the file says nothing";
}

TEST(MeshObj, LinesMayBeJoinedAndEndAsTheyLike) {
  const Scene scene = read("\xEF\xBB\xBFv 0 0 0 # one\r\nv 1 0 \\\r\n 0\r\nv 0 +1 0\r\n# a path C:\\\r\nf 1 2 \\\n3");
  EXPECT_EQ(indices(scene).size(), 3u);
}

TEST(MeshObj, CommentsEndWithTheirLine) {
  const Scene scene =
      read("v 0 0 0 # C:\\\nv 1 0 0\t#\\\r\nv 0 1 0\nf 1 2 \\\n3 # C:\\\nf 3 2 \\\n# nothing\\\nf 1 3 2\n");
  EXPECT_EQ(vertices(scene).count, 3u);
  EXPECT_EQ(indices(scene), (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 1})) << "a face of two corners is left out";
}

TEST(MeshObj, ANumberSignThatStandsAloneEndsAName) {
  const Scene scene = read(square +
                           "o left # the wing\nusemtl red # \xC3\xA9\nf 1 2 3\nusemtl red #2#3 # 4\nf 1 3 4\n"
                           "o Object #7\nusemtl #\nf 1 2 4\n");
  EXPECT_EQ(scene.meshes[0].name, "left");
  EXPECT_EQ(scene.material_of(scene.draws[0])->name, "red");
  EXPECT_EQ(scene.material_of(scene.draws[1])->name, "red #2#3");
  EXPECT_EQ(scene.meshes[1].name, "Object #7");
  EXPECT_EQ(scene.material_of(scene.draws[2]), nullptr);
}

TEST(MeshObj, WhatIsLeftOutIsTold) {
  const auto small = read_mesh(MeshKind::obj, square + "f 1 2\nf 1 2 3\nf\nl 1 2\nv 0 0 0 2\nnonsense 1\n");
  EXPECT_EQ(small.told(), "weights-left-out faces-left-out elements-left-out unknown-line");
  EXPECT_EQ(read_mesh(MeshKind::obj, square + "f 1 2 3\n").told(), "");
}

TEST(MeshObj, PointsAloneAreAScene) {
  const Scene scene = read(square);
  EXPECT_EQ(scene.draws[0].topology, Topology::points);
  EXPECT_EQ(vertices(scene).count, 4u);
}

TEST(MeshObj, RefusalsNameTheLine) {
  EXPECT_EQ(error("v 0 0\n"), "input.obj:1:1: error: 'v' takes at least 3 numbers, but has 2");
  EXPECT_EQ(error("v 0 0 0\nv 0 nan 0\n"), "input.obj:2:5: error: 'nan' is not finite");
  EXPECT_EQ(error("v 0 0 -inf\n"), "input.obj:1:7: error: '-inf' is not finite");
  EXPECT_EQ(error("v 0 1e39 0\n"), "input.obj:1:5: error: '1e39' does not fit into a 32-bit float");
  EXPECT_EQ(error("v 0 0 zero\n"), "input.obj:1:7: error: 'zero' is not a number");
  EXPECT_EQ(error(square + "f 1 2 5\n"), "input.obj:5:1: error: the face names 'v' number 5, but the file has 4");
  EXPECT_EQ(error(square + "f 0 1 2\n"), "input.obj:5:3: error: names record 0, but OBJ counts from 1");
  EXPECT_EQ(error(square + "f 1 2 99999999999999999999\n"),
            "input.obj:5:7: error: '99999999999999999999' is not a whole number");
  EXPECT_EQ(error(square + "f 1 2 4294967297\n"),
            "input.obj:5:7: error: names record 4294967297, which no file can hold");
  EXPECT_EQ(error(std::string("v 0 0\0 0", 8)), "input.obj: error: byte 5: found a zero byte: the file is not text");
  EXPECT_EQ(error(""), "input.obj: error: the file holds no vertices");
  EXPECT_EQ(error(square + "f 1 2\n"), "input.obj: error: none of the file's faces has three corners");
}

TEST(MeshObj, AttributesOfWhichThereAreNoneAtAllAreNone) {
  const std::string text = square + "vn 0 0 1\nf 1/1/1 2/9/1 3/3/1\nf 1/1/1 3/1/1 4/1/1\n";
  const auto made = read_mesh(MeshKind::obj, text);
  ASSERT_TRUE(made.scene) << made.error();
  EXPECT_EQ(made.told(), "missing-attribute");
  EXPECT_EQ(made.diagnostics.all()[0].places, 6u);
  EXPECT_TRUE(made.scene->draws[0].traits.has(traits::normals));
  EXPECT_FALSE(made.scene->draws[0].traits.has(traits::uv0));
  EXPECT_EQ(read_mesh(MeshKind::obj, text, {}, {.strict = true}).error(),
            "input.obj:6:1: error: the face names 'vt' number 1, but the file has 0 (and 5 more like it)");
}

TEST(MeshObj, AttributesThatAreNotThereAreNone) {
  for (const std::string wrong : {"2/2/1", "2/0/1", "2/-2/1"}) {
    const auto made =
        read_mesh(MeshKind::obj, square + "vn 0 0 1\nvt 0 0\nf 1/1/1 2/1/1 3/1/1\nf 1/1/1 " + wrong + " 3/1/1\n");
    ASSERT_TRUE(made.scene) << made.error();
    EXPECT_EQ(made.told(), "missing-attribute");
    ASSERT_EQ(made.scene->draws.size(), 2u);
    EXPECT_TRUE(made.scene->draws[0].traits.has(traits::uv0));
    EXPECT_FALSE(made.scene->draws[1].traits.has(traits::uv0));
    EXPECT_TRUE(made.scene->draws[1].traits.has(traits::normals));
  }
}

TEST(MeshObj, ZeroBytesBehindTheTextAreSkipped) {
  using namespace std::string_literals;
  const auto made = read_mesh(MeshKind::obj, square + "f 1 2 3\n\0\n\0"s);
  ASSERT_TRUE(made.scene) << made.error();
  EXPECT_EQ(made.told(), "zero-bytes");
  EXPECT_EQ(indices(*made.scene).size(), 3u);
}

TEST(MeshObj, AttributesThatAreNotFiniteAreZero) {
  const auto made = read_mesh(MeshKind::obj,
                              "v 0 0 0 nan 1 1\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1\nvt -1.#IND 1\nvn inf 1e99 1\n"
                              "f 1/1/1 2/1/1 3/1/1\n");
  ASSERT_TRUE(made.scene) << made.error();
  EXPECT_EQ(made.told(), "not-finite");
  EXPECT_EQ(made.diagnostics.all()[0].places, 4u);
  const VertexStreams& streams = vertices(*made.scene);
  EXPECT_EQ(decode_component(*streams.find("COLOR_0"), 0, 0), 0);
  EXPECT_EQ(decode_component(*streams.find("TEXCOORD_0"), 0, 0), 0);
  EXPECT_EQ(decode_vec3(*streams.find("NORMAL"))[0], glm::vec3(0, 0, 1));
}

TEST(MeshObj, Utf16IsRefused) {
  for (const char* mark : {"\xFE\xFF", "\xFF\xFE"}) {
    EXPECT_EQ(error(mark + std::string("v\0", 2)), "input.obj: error: the text is UTF-16");
  }
}

TEST(MeshObj, WhatIsTooSmallForAFloatIsZero) {
  const Scene scene = read("v 1e-60 0 0\nv -1e-400 0.5e-39 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(decode_vec3(*vertices(scene).find("POSITION"))[0].x, 0);
  EXPECT_EQ(decode_vec3(*vertices(scene).find("POSITION"))[1].x, 0);
}

TEST(MeshObj, LongNamesAreNotRepeatedWithoutBound) {
  std::string text = square + "g " + std::string(50'000, 'x') + '\n';
  for (int i = 0; i < 5000; ++i) text += "o " + std::to_string(i) + "\nf 1 2 3\n";
  EXPECT_FALSE(read_mesh(MeshKind::obj, text).scene);
}

TEST(MeshObj, NumbersTooSmallAreZeroAndThoseTooLargeRefused) {
  const auto text = [](const std::string& x) { return "v " + x + " 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n"; };
  const std::string zeros(46, '0'), nines(46, '9');
  for (const std::string& small : {std::string("1e-60"), "0." + zeros + "1", std::string("-1E-400")}) {
    EXPECT_TRUE(read_mesh(MeshKind::obj, text(small)).scene) << small;
  }
  for (const std::string& large : {std::string("1e60"), "1" + zeros + "e-2", "0" + nines, std::string("1e400")}) {
    EXPECT_FALSE(read_mesh(MeshKind::obj, text(large)).scene) << large;
  }
}

}  // namespace
}  // namespace foredraw::obj_test
