// What an OBJ says becomes the scene that people expect, or is refused with its line.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support/mesh_reading.h"
#include "support/test_folder.h"

namespace foredraw {
namespace {

namespace fs = std::filesystem;
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

TEST(MeshObj, Utf16IsReadByItsByteOrderMark) {
  const std::u16string text = u"o caf\u00e9 \U0001F600\r\nv 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n";
  for (const bool big : {false, true}) {
    const auto in_bytes = [&](std::u16string_view units) {
      std::string bytes = big ? "\xFE\xFF" : "\xFF\xFE";
      for (const char16_t unit : units) {
        const char high = static_cast<char>(unit >> 8), low = static_cast<char>(unit & 0xFF);
        bytes += big ? std::string{high, low} : std::string{low, high};
      }
      return bytes;
    };
    const auto made = read_mesh(MeshKind::obj, in_bytes(text));
    ASSERT_TRUE(made.scene) << made.error();
    EXPECT_EQ(made.told(), "utf-16");
    EXPECT_EQ(made.scene->meshes[0].name, "caf\xC3\xA9 \xF0\x9F\x98\x80");
    for (const std::u16string bad : {u"\xD83D", u"\xDE00\xD83D", u"\xD83Dv"}) {
      EXPECT_EQ(error(in_bytes(text + bad)),
                "input.obj: error: the file begins with the byte order mark of UTF-16, but the rest is not UTF-16");
    }
    EXPECT_NE(error(in_bytes(text) + " "), "");
  }
}

TEST(MeshObj, WhatIsTooSmallForAFloatIsZero) {
  const Scene scene = read("v 1e-60 0 0\nv -1e-400 0.5e-39 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(decode_vec3(*vertices(scene).find("POSITION"))[0].x, 0);
  EXPECT_EQ(decode_vec3(*vertices(scene).find("POSITION"))[1].x, 0);
}

class MeshObjMaterials : public ::testing::Test {
 protected:
  MeshObjMaterials() { fs::create_directories(folder_ / "inner"); }
  void put(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }

  testing::TestFolder own_;
  const fs::path folder_ = own_.path();
};

TEST_F(MeshObjMaterials, BlendedOnesAndTexturesAreKnown) {
  put("inner/a b.mtl", "newmtl glass\nd 0.5\nnewmtl wood\nKd 1 0.5 0\nmap_Kd -s 1 1 1 wood.png\nmap_Kd ../out.png\n");
  put("inner/wood.png", "");
  const std::string text =
      "mtllib a b.mtl\n" + square + "vt 0 0\nusemtl glass\nf 1 2 3\nusemtl wood\nf 1/1 3/1 4/1\nusemtl new\nf 2 3 4\n";
  const auto made = read_mesh(MeshKind::obj, text, folder_ / "inner");
  ASSERT_TRUE(made.scene) << made.error();
  EXPECT_EQ(made.told(), "missing-file unknown-material") << "the texture that leads out of the folder, and 'new'";
  EXPECT_TRUE(made.scene->draws[0].traits.has(traits::blended));
  EXPECT_EQ(made.scene->material_of(made.scene->draws[1])->name, "wood");
  ASSERT_EQ(made.scene->images.size(), 1u);
  EXPECT_EQ(made.scene->images[0].uri, "wood.png");
  EXPECT_EQ(made.scene->materials.size(), 3u);
}

TEST_F(MeshObjMaterials, NamesMayHoldNumberSigns) {
  put("m.mtl", "newmtl Material #25\nd 0.5 # half\nnewmtl Material #26\nmap_Kd tex#1.png # of wood\n");
  put("tex#1.png", "");
  const auto made = read_mesh(MeshKind::obj,
                              "mtllib m.mtl\n" + square +
                                  "vt 0 0\nusemtl Material #25\nf 1 2 3\n"
                                  "usemtl Material #26\nf 1/1 3/1 4/1\n",
                              folder_);
  ASSERT_TRUE(made.scene) << made.error();
  EXPECT_EQ(made.told(), "");
  EXPECT_TRUE(made.scene->draws[0].traits.has(traits::blended));
  ASSERT_EQ(made.scene->images.size(), 1u);
  EXPECT_EQ(made.scene->images[0].uri, "tex%231.png");
}

TEST_F(MeshObjMaterials, CommentsAreNotPartOfNames) {
  put("a b.mtl", "\xEF\xBB\xBFnewmtl glass # thin\nd 0.5\n");
  for (const std::string library : {"a b.mtl # ours", "a b.mtl #ours", "a b.mtl"}) {
    const auto made = read_mesh(
        MeshKind::obj, "mtllib " + library + "\n" + square + "usemtl glass # of the window\nf 1 2 3\n", folder_);
    ASSERT_TRUE(made.scene) << made.error();
    EXPECT_EQ(made.told(), "") << library;
    EXPECT_TRUE(made.scene->draws[0].traits.has(traits::blended)) << library;
  }
}

TEST_F(MeshObjMaterials, ThoseThatNoLibraryHoldsAreTold) {
  put("m.mtl", "newmtl a\n");
  std::string text = "mtllib m.mtl\n" + square;
  for (const char* name : {"a", "b", "c", "b", "d", "e"}) text += std::string("usemtl ") + name + "\nf 1 2 3\n";
  const auto made = read_mesh(MeshKind::obj, text, folder_);
  ASSERT_EQ(made.told(), "unknown-material");
  EXPECT_EQ(made.diagnostics.all()[0].message, "'b' is in none of the material libraries that were read");
  EXPECT_EQ(made.diagnostics.all()[0].places, 4u);
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

TEST_F(MeshObjMaterials, WithoutCoordinatesATextureStaysOut) {
  put("m.mtl", "newmtl wood\nd 0.5\nmap_Kd wood.png\n");
  put("none.mtl", "");
  put("wood.png", "");
  const std::string text =
      "mtllib none.mtl m.mtl\n" + square + "vt 0 0\nusemtl wood\nf 1 2 3\nf 1/1 2/1 3/1\nusemtl wood\nf 1 2 4\n";
  const auto made = read_mesh(MeshKind::obj, text, folder_);
  ASSERT_TRUE(made.scene) << made.error();
  ASSERT_EQ(made.scene->draws.size(), 2u);
  EXPECT_EQ(made.scene->materials.size(), 2u);
  EXPECT_NE(made.scene->draws[0].material, made.scene->draws[1].material);
  EXPECT_EQ(made.scene->material_of(made.scene->draws[0])->alpha_mode, AlphaMode::blend);
}

TEST_F(MeshObjMaterials, LibrariesOutsideTheFolderAreNotOpened) {
  put("secret.mtl", "newmtl m\nd 0.5\n");
  fs::create_symlink(folder_ / "secret.mtl", folder_ / "inner/link.mtl");
  for (const std::string name : {"../secret.mtl", "..\\secret.mtl", "link.mtl", "missing.mtl", "C:\\secret.mtl", "."}) {
    const auto made =
        read_mesh(MeshKind::obj, "mtllib " + name + "\n" + square + "usemtl m\nf 1 2 3\n", folder_ / "inner");
    ASSERT_TRUE(made.scene) << name;
    EXPECT_EQ(made.told(), "missing-file unknown-material") << name;
    EXPECT_FALSE(made.scene->draws[0].traits.has(traits::blended)) << name;
  }
}

TEST_F(MeshObjMaterials, LibrariesAndTexturesWithinTheRootAre) {
  put("m.mtl", "newmtl m\nd 0.5\nmap_Kd ../wood.png\n");
  put("wood.png", "");
  const auto read_within = [&](const fs::path& root) {
    return read_mesh(MeshKind::obj, "mtllib ../m.mtl\n" + square + "vt 0 0\nusemtl m\nf 1/1 2/1 3/1\n",
                     folder_ / "inner", {.root = root});
  };
  const auto made = read_within(folder_);
  ASSERT_TRUE(made.scene) << made.error();
  EXPECT_EQ(made.told(), "");
  EXPECT_EQ(made.scene->images.at(0).uri, "../wood.png");
  EXPECT_EQ(read_within(folder_ / "inner").told(), "missing-file unknown-material");
}

TEST_F(MeshObjMaterials, FaultsAreRefusedWhereTheReaderIsStrict) {
  put("m.mtl", "newmtl m\nmap_Kd gone.png\n");
  const std::string good = "mtllib m.mtl\n" + square + "usemtl m\nf 1 2 3\n";
  const std::string prefix = "input.obj:";
  for (const auto& [text, why] : std::vector<std::pair<std::string, std::string>>{
           {good, "m.mtl: error: the texture 'gone.png' is missing"},
           {square + "f 1 2 3\nnonsense\n", prefix + "6:1: error: 'nonsense' is not a keyword of OBJ"},
           {square + "f 1 2 3\nl 1 2\np 3\n",
            prefix + "6:1: error: 'l' makes no faces, and only faces are read (and 1 more like it)"},
           {"mtllib n.mtl\n" + square + "f 1 2 3\n", prefix + " error: the material library 'n.mtl' is missing"},
           {square + "usemtl new\nf 1 2 3\n",
            prefix + " error: 'new' is in none of the material libraries that were read"}}) {
    EXPECT_TRUE(read_mesh(MeshKind::obj, text, folder_).scene);
    const auto strict = read_mesh(MeshKind::obj, text, folder_, {.strict = true});
    EXPECT_FALSE(strict.scene);
    EXPECT_EQ(strict.error(), why);
  }
}

}  // namespace
}  // namespace foredraw
