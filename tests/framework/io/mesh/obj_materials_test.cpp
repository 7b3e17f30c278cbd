// Materials and textures that an OBJ names: found beside it, told where they are not, never sought elsewhere.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support/mesh_reading.h"
#include "support/test_folder.h"

namespace foredraw::obj_materials_test {
namespace {

namespace fs = std::filesystem;
using testing::read_mesh;

class MeshObjMaterials : public ::testing::Test {
 protected:
  MeshObjMaterials() { fs::create_directories(folder_ / "inner"); }
  void put(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }

  const std::string square_ = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  testing::TestFolder own_;
  const fs::path folder_ = own_.path();
};

TEST_F(MeshObjMaterials, BlendedOnesAndTexturesAreKnown) {
  put("inner/a b.mtl", "newmtl glass\nd 0.5\nnewmtl wood\nKd 1 0.5 0\nmap_Kd -s 1 1 1 wood.png\nmap_Kd ../out.png\n");
  put("inner/wood.png", "");
  const std::string text =
      "mtllib a b.mtl\n" + square_ + "vt 0 0\nusemtl glass\nf 1 2 3\nusemtl wood\nf 1/1 3/1 4/1\nusemtl new\nf 2 3 4\n";
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
                              "mtllib m.mtl\n" + square_ +
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
        MeshKind::obj, "mtllib " + library + "\n" + square_ + "usemtl glass # of the window\nf 1 2 3\n", folder_);
    ASSERT_TRUE(made.scene) << made.error();
    EXPECT_EQ(made.told(), "") << library;
    EXPECT_TRUE(made.scene->draws[0].traits.has(traits::blended)) << library;
  }
}

TEST_F(MeshObjMaterials, ThoseThatNoLibraryHoldsAreTold) {
  put("m.mtl", "newmtl a\n");
  std::string text = "mtllib m.mtl\n" + square_;
  for (const char* name : {"a", "b", "c", "b", "d", "e"}) text += std::string("usemtl ") + name + "\nf 1 2 3\n";
  const auto made = read_mesh(MeshKind::obj, text, folder_);
  ASSERT_EQ(made.told(), "unknown-material");
  EXPECT_EQ(made.diagnostics.all()[0].message, "'b' is in none of the material libraries that were read");
  EXPECT_EQ(made.diagnostics.all()[0].places, 4u);
}

TEST_F(MeshObjMaterials, WithoutCoordinatesATextureStaysOut) {
  put("m.mtl", "newmtl wood\nd 0.5\nmap_Kd wood.png\n");
  put("none.mtl", "");
  put("wood.png", "");
  const std::string text =
      "mtllib none.mtl m.mtl\n" + square_ + "vt 0 0\nusemtl wood\nf 1 2 3\nf 1/1 2/1 3/1\nusemtl wood\nf 1 2 4\n";
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
        read_mesh(MeshKind::obj, "mtllib " + name + "\n" + square_ + "usemtl m\nf 1 2 3\n", folder_ / "inner");
    ASSERT_TRUE(made.scene) << name;
    EXPECT_EQ(made.told(), "missing-file unknown-material") << name;
    EXPECT_FALSE(made.scene->draws[0].traits.has(traits::blended)) << name;
  }
}

TEST_F(MeshObjMaterials, LibrariesAndTexturesWithinTheRootAre) {
  put("m.mtl", "newmtl m\nd 0.5\nmap_Kd ../wood.png\n");
  put("wood.png", "");
  const auto read_within = [&](const fs::path& root) {
    return read_mesh(MeshKind::obj, "mtllib ../m.mtl\n" + square_ + "vt 0 0\nusemtl m\nf 1/1 2/1 3/1\n",
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
  const std::string good = "mtllib m.mtl\n" + square_ + "usemtl m\nf 1 2 3\n";
  const std::string prefix = "input.obj:";
  for (const auto& [text, why] : std::vector<std::pair<std::string, std::string>>{
           {good, "m.mtl: error: the texture 'gone.png' is missing"},
           {square_ + "f 1 2 3\nnonsense\n", prefix + "6:1: error: 'nonsense' is not a keyword of OBJ"},
           {square_ + "f 1 2 3\nl 1 2\np 3\n",
            prefix + "6:1: error: 'l' makes no faces, and only faces are read (and 1 more like it)"},
           {"mtllib n.mtl\n" + square_ + "f 1 2 3\n", prefix + " error: the material library 'n.mtl' is missing"},
           {square_ + "usemtl new\nf 1 2 3\n",
            prefix + " error: 'new' is in none of the material libraries that were read"}}) {
    EXPECT_TRUE(read_mesh(MeshKind::obj, text, folder_).scene);
    const auto strict = read_mesh(MeshKind::obj, text, folder_, {.strict = true});
    EXPECT_FALSE(strict.scene);
    EXPECT_EQ(strict.error(), why);
  }
}

}  // namespace
}  // namespace foredraw::obj_materials_test
