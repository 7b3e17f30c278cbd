// Pictures and materials of scenes of other formats: where they are found, and what comes of them.

#include "support/image_builder.h"
#include "support/importing.h"

#include <foredraw/io/image/images.h>

#include <gmock/gmock.h>

namespace foredraw::import_pictures_test {
namespace {

namespace fs = std::filesystem;
using testing::content;
using testing::Ended;
using testing::FbxBuilder;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::put;
using testing::quick;

class ImportedPictures : public testing::Imported {
 protected:
  static std::string text_of(const std::vector<std::byte>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  static std::string small_png() {
    return text_of(
        testing::png_of({.width = 2, .height = 2, .channels = 3, .bits = 8}, std::vector<std::uint16_t>(12, 99)));
  }
  /// With a material, and with texture coordinates for its picture.
  static FbxBuilder green_leaf(const std::vector<double>& uv = {0, 0, 1, 0, 0, 1}) {
    FbxBuilder file = testing::leaf({.uv = uv});
    file.material(250, "green", 200);
    return file;
  }
  static std::string with_texture(const std::string& path) {
    FbxBuilder file = green_leaf();
    file.texture(260, 250, path);
    return file.text();
  }
};

TEST_F(ImportedPictures, PicturesComeAlongAndAreNamedWhereTheyDoNot) {
  FbxBuilder file = green_leaf();
  file.texture(260, 250, "C:\\\\art\\\\leaf.png");
  put(folder_ / "leaf.fbx", file.text());
  Ended ended = run("optimize leaf.fbx -o leaf.glb" + std::string(quick));
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err,
              HasSubstr("leaf.png' is left out: there is no such file, nor one of its name beside the scene"));

  put(folder_ / "leaf.png", small_png());
  ended = run("optimize leaf.fbx -o leaf.glb --depfile leaf.d" + std::string(quick));
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, Not(HasSubstr("left out")));
  EXPECT_THAT(content(folder_ / "leaf.d"), HasSubstr("leaf.png"));
  Diagnostics diagnostics;
  const auto made = read_scene((folder_ / "leaf.glb").string(), diagnostics, {});
  ASSERT_TRUE(made);
  EXPECT_EQ(made->scene.images.size(), 1u);
  ASSERT_EQ(made->scene.materials.size(), 1u);
  EXPECT_EQ(made->scene.materials[0].name, "green");
  EXPECT_EQ(made->scene.materials[0].colour, glm::vec3(1)) << "a picture of an FBX file takes the colour's place";
  put(folder_ / "leaf.png", "no picture");
  EXPECT_EQ(read("leaf.fbx", file.text()).materials[0].colour, glm::vec3(0.5f, 0.25f, 1));
}

TEST_F(ImportedPictures, NothingIsReadOutsideTheFolder) {
  fs::create_directories(folder_ / "in");
  put(folder_ / "secret.png", small_png());
  FbxBuilder file = green_leaf();
  file.texture(260, 250, "../secret.png");
  put(folder_ / "in/leaf.fbx", file.text());
  const std::string told = run("optimize in/leaf.fbx -o leaf.glb" + std::string(quick)).err;
  EXPECT_THAT(told, HasSubstr("'../secret.png' is left out: it lies outside the scene's folder"));
  EXPECT_THAT(told, HasSubstr("hint: give --root"));
  EXPECT_THAT(run("optimize in/leaf.fbx -o leaf.glb --root ." + std::string(quick)).err, Not(HasSubstr("left out")));
}

/// As whoever moved a project from a system that knows no difference between capitals and small letters has it.
TEST_F(ImportedPictures, AreFoundByTheEndOfTheirPathWhateverTheirCapitals) {
  fs::create_directories(folder_ / "maps/green");
  put(folder_ / "maps/green/leaf.png", small_png());
  for (const char* path : {"C:\\\\art\\\\Maps\\\\green\\\\LEAF.PNG", "/art/maps/green/leaf.png",
                           "//maps/green/leaf.png", "maps/./green/Leaf.png", "maps/green/leaf.png"}) {
    EXPECT_EQ(read("leaf.fbx", with_texture(path)).images.size(), 1u) << path;
    EXPECT_EQ(told_, "") << path;
  }
  EXPECT_TRUE(read("leaf.fbx", with_texture("C:\\\\maps\\\\leaf.png")).images.empty()) << "another folder's";
}

TEST_F(ImportedPictures, OfTgaAreWrittenAsPngWithTheSameTexels) {
  const ImageFacts facts{.width = 2, .height = 2, .channels = 4, .bits = 8};
  const auto tga = testing::tga_of(facts, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16});
  put(folder_ / "leaf.tga", text_of(tga));
  const Scene scene = read("leaf.fbx", with_texture("leaf.tga"));
  EXPECT_EQ(told_, "");
  ASSERT_EQ(scene.images.size(), 1u);
  EXPECT_EQ(scene.images[0].media_type, "image/png");
  Diagnostics diagnostics;
  const auto texels = decode_image(scene.images[0].bytes.view(), {}, diagnostics);
  const auto before = decode_image(tga, {}, diagnostics);
  ASSERT_TRUE(texels && before) << to_text(diagnostics);
  EXPECT_EQ(texels->facts, facts);
  EXPECT_EQ(texels->bytes, before->bytes);
  put(folder_ / "leaf.bmp", "BM and more");
  EXPECT_TRUE(read("leaf.fbx", with_texture("leaf.bmp")).images.empty());
  EXPECT_THAT(told_, HasSubstr("leaf.bmp' is left out: it is no PNG, JPEG or TGA"));
}

TEST_F(ImportedPictures, MayLieInTheSceneItself) {
  FbxBuilder file = green_leaf();
  file.texture(260, 250, "C:\\\\art\\\\inside.png");
  file.video(270, 260, "C:\\\\art\\\\inside.png",
             "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGNgAAAAAgABSK+kcQAAAABJRU5ErkJggg==");
  const Scene scene = read("leaf.fbx", file.text());
  EXPECT_EQ(told_, "");
  ASSERT_EQ(scene.images.size(), 1u);
  EXPECT_EQ(scene.images[0].facts, (ImageFacts{.width = 1, .height = 1, .channels = 1, .bits = 8}));
}

TEST_F(ImportedPictures, AMeshWithoutTextureCoordinatesGetsAMaterialWithoutPictures) {
  put(folder_ / "leaf.png", small_png());
  FbxBuilder file = green_leaf({});
  file.texture(260, 250, "leaf.png");
  const Scene scene = read("leaf.fbx", file.text());
  EXPECT_THAT(told_, HasSubstr("textures of the material 'green' are left out of the mesh 'leaf'"));
  ASSERT_EQ(scene.draws.size(), 1u);
  const Material* material = scene.material_of(scene.draws[0]);
  ASSERT_NE(material, nullptr);
  EXPECT_EQ(material->name, "green");
  EXPECT_FALSE(material->base_colour);
}

TEST_F(ImportedPictures, WhatAnFbxDoesWithItsTexturesIsTold) {
  put(folder_ / "leaf.png", small_png());
  FbxBuilder file = green_leaf();
  file.texture(260, 250, "leaf.png", FbxBuilder::vector("Scaling", 2, 2, 1));
  read("leaf.fbx", file.text());
  EXPECT_THAT(told_, HasSubstr("that the material 'green' tiles, moves or turns its texture 'leaf.png' is left out"));
}

}  // namespace
}  // namespace foredraw::import_pictures_test
