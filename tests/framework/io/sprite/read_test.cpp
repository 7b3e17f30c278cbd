// Images and frame lists as scenes; those that are damaged or mean harm are refused by name.
#include <foredraw/image/sprite_pieces.h>
#include <foredraw/io/scene_file.h>
#include <foredraw/io/sprite/sprite_files.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "support/program.h"
#include "support/sprites.h"

namespace foredraw::sprite_read_test {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::HasSubstr;

class SpriteRead : public testing::InFolder {
 protected:
  SpriteRead() { testing::put_bytes(folder_ / "atlas.png", testing::disc_png(64, 32)); }

  std::optional<Scene> read(const std::string& name) {
    told_ = {};
    auto file = read_scene((folder_ / name).string(), told_);
    return file ? std::optional(std::move(file->scene)) : std::nullopt;
  }
  std::optional<Scene> read_list(const Json& list) {
    testing::put(folder_ / "list.json", list.dump());
    return read("list.json");
  }
  /// The text of what is told of a list with this one frame.
  std::string mistake(const Json& frame) {
    EXPECT_FALSE(read_list({{"frames", {{"it", frame}}}, {"meta", {{"image", "atlas.png"}}}}));
    return to_text(told_);
  }

  Diagnostics told_;
};

Json box(int x, int y, int w, int h) { return {{"x", x}, {"y", y}, {"w", w}, {"h", h}}; }

std::vector<glm::vec3> stream(const Draw& draw, const char* semantic) {
  return decode_vec3(*draw.levels[0].vertices->find(semantic));
}

TEST_F(SpriteRead, AnImageIsOneQuad) {
  const auto scene = read("atlas.png");
  ASSERT_TRUE(scene) << to_text(told_);
  ASSERT_EQ(scene->draws.size(), 1u);
  const Draw& draw = scene->draws[0];
  EXPECT_EQ(draw.name, "atlas");
  EXPECT_EQ(draw.frame, (SpriteFrame{0, 0, 64, 32}));
  for (const Trait trait : {traits::triangles, traits::uv0, traits::blended, traits::sprite, traits::double_sided}) {
    EXPECT_TRUE(draw.traits.has(trait)) << trait;
  }
  EXPECT_TRUE(is_made_of_quads(draw));
  EXPECT_EQ(stream(draw, "POSITION")[0], glm::vec3(-0.5f, -0.25f, 0));
  EXPECT_EQ(stream(draw, "POSITION")[2], glm::vec3(0.5f, 0.25f, 0));
  EXPECT_EQ(stream(draw, "TEXCOORD_0")[0], glm::vec3(0, 1, 0));  // the lower left corner
  ASSERT_TRUE(scene->materials[0].base_colour);
  EXPECT_EQ(scene->materials[0].base_colour->wrap[0], Wrap::clamped);
  EXPECT_EQ(scene->materials[0].alpha_mode, AlphaMode::blend);
  EXPECT_EQ(scene->images[0].media_type, "image/png");
  EXPECT_EQ(scene->source->bytes(), scene->images[0].bytes.size());
}

TEST_F(SpriteRead, AnyKindOfImage) {
  const std::vector<std::uint16_t> values = testing::discs(16, 16);
  testing::put_bytes(folder_ / "a.tga", testing::tga_of({16, 16, 4, 8}, values));
  testing::put_bytes(folder_ / "b.jpeg", testing::jpeg_of({16, 16, 3, 8}, std::vector<std::uint16_t>(16 * 16 * 3, 99)));
  testing::put_bytes(folder_ / "c.EXR",
                     testing::exr_of({16, 16, 4, 32, true}, std::vector<float>(16 * 16 * 4, 0.5f), "zip"));
  for (const char* name : {"a.tga", "b.jpeg", "c.EXR"}) EXPECT_TRUE(read(name)) << name << to_text(told_);
}

TEST_F(SpriteRead, DamagedImagesAreRefused) {
  testing::put(folder_ / "no.png", "no image at all");
  EXPECT_FALSE(read("no.png"));
  EXPECT_THAT(to_text(told_), HasSubstr("no.png: error: is not an image"));
  testing::put(folder_ / "empty.jpg", "");
  EXPECT_FALSE(read("empty.jpg"));
  std::vector<std::byte> vast = testing::disc_png(8, 8);
  vast[16] = std::byte{0x7f};  // the width
  testing::put_bytes(folder_ / "vast.png", vast);
  EXPECT_FALSE(read("vast.png"));
  EXPECT_THAT(to_text(told_), HasSubstr("more than the limit"));
  EXPECT_FALSE(read("missing.png"));
}

TEST_F(SpriteRead, AListIsADrawForEachFrame) {
  const auto scene = read_list(
      {{"frames",
        {{"left", {{"frame", box(0, 0, 32, 32)}}}, {"right", {{"frame", box(40, 2, 20, 24)}, {"rotated", true}}}}},
       {"meta", {{"image", "atlas.png"}, {"size", {{"w", 64}, {"h", 32}}}}}});
  ASSERT_TRUE(scene) << to_text(told_);
  EXPECT_TRUE(told_.empty()) << to_text(told_);
  ASSERT_EQ(scene->draws.size(), 2u);
  EXPECT_EQ(scene->draws[0].name, "left");
  EXPECT_EQ(scene->nodes[0].transform.translation, glm::vec3(-0.25f, 0, 0));
  const Draw& turned = scene->draws[1];
  EXPECT_EQ(turned.frame, (SpriteFrame{40, 2, 24, 20}));  // as it lies there
  EXPECT_EQ(stream(turned, "POSITION")[2], glm::vec3(20 / 128.f, 24 / 128.f, 0));
  // Turned clockwise, the lower left corner is the upper left one, the lower right one the lower left one.
  EXPECT_EQ(stream(turned, "TEXCOORD_0")[0], glm::vec3(40 / 64.f, 2 / 32.f, 0));
  EXPECT_EQ(stream(turned, "TEXCOORD_0")[1], glm::vec3(40 / 64.f, 22 / 32.f, 0));
  EXPECT_TRUE(is_made_of_quads(turned));

  // The node puts each corner where it lies in the image.
  const auto world = world_transforms(*scene);
  for (std::size_t d = 0; d < 2; ++d) {
    for (std::size_t v = 0; v < 4; ++v) {
      const glm::vec4 at = world[d] * glm::vec4(stream(scene->draws[d], "POSITION")[v], 1);
      const glm::vec3 uv = stream(scene->draws[d], "TEXCOORD_0")[v];
      EXPECT_NEAR(at.x, uv.x - 0.5f, 1e-6f) << d << ' ' << v;
      EXPECT_NEAR(at.y, (0.5f - uv.y) / 2, 1e-6f) << d << ' ' << v;
    }
  }
}

TEST_F(SpriteRead, ListsOfOtherForms) {
  const Json frame = {{"filename", "a"}, {"frame", box(0, 0, 8, 8)}};
  auto scene = read_list({{"frames", {frame}}, {"meta", {{"image", "atlas.png"}}}});
  ASSERT_TRUE(scene) << to_text(told_);
  EXPECT_EQ(scene->draws[0].name, "a");
  testing::put_bytes(folder_ / "second.png", testing::disc_png(16, 16));
  scene = read_list(
      {{"textures", {{{"image", "atlas.png"}, {"frames", {frame}}}, {{"image", "second.png"}, {"frames", {frame}}}}}});
  ASSERT_TRUE(scene) << to_text(told_);
  ASSERT_EQ(scene->images.size(), 2u);
  EXPECT_EQ(scene->draws[1].material, 1u);
}

TEST_F(SpriteRead, AnImageIsOneTextures) {
  const Json texture = {{"image", "atlas.png"}, {"frames", {{{"filename", "a"}, {"frame", box(0, 0, 8, 8)}}}}};
  EXPECT_FALSE(read_list({{"textures", {texture, texture}}}));
  EXPECT_THAT(to_text(told_), HasSubstr("textures[1].image: is the image of an earlier texture"));
}

TEST_F(SpriteRead, BadFramesAreRefusedByName) {
  EXPECT_THAT(mistake({{"frame", box(-1, 0, 8, 8)}}), HasSubstr("list.json: error: frames.it.frame.x: is -1"));
  EXPECT_THAT(mistake({{"frame", box(0, 0, 0, 8)}}), HasSubstr("frames.it.frame.w: is 0"));
  EXPECT_THAT(mistake({{"frame", {{"x", 0.5}, {"y", 0}, {"w", 1}, {"h", 1}}}}), HasSubstr("is 0.5"));
  EXPECT_THAT(mistake({{"frame", {{"x", 1e300}, {"y", 0}, {"w", 1}, {"h", 1}}}}), HasSubstr("whole number"));
  EXPECT_THAT(mistake({{"frame", {{"x", "1"}, {"y", 0}, {"w", 1}, {"h", 1}}}}), HasSubstr("must be a number"));
  EXPECT_THAT(mistake({{"frame", box(60, 0, 5, 8)}}), HasSubstr("it: begins at 60, 0 and has 5 x 8 texels"));
  EXPECT_THAT(mistake({{"frame", box(0, 30, 8, 2)}, {"rotated", true}}), HasSubstr("has 2 x 8 texels"));
  EXPECT_THAT(mistake({{"frame", box(0, 0, 8, 8)}, {"rotated", 90}}), HasSubstr("frames.it.rotated: must be true or"));
  EXPECT_THAT(mistake({{"frame", box(0, 0, 8, 8)}, {"sourceSize", 3}}), HasSubstr("frames.it.sourceSize"));
  EXPECT_THAT(mistake({{"frame", box(0, 0, 8, 8)}, {"spriteSourceSize", box(-3, 0, 8, 8)}}), HasSubstr("is -3"));
  EXPECT_THAT(mistake(Json::object()), HasSubstr("frames.it.frame: must be an object"));
  EXPECT_THAT(mistake(7), HasSubstr("frames.it: must be an object"));
}

TEST_F(SpriteRead, BadListsAreRefused) {
  const auto told = [&](const std::string& text) {
    testing::put(folder_ / "list.json", text);
    EXPECT_FALSE(read("list.json")) << text;
    return to_text(told_);
  };
  EXPECT_THAT(told("{"), HasSubstr("list.json:1:2: error: is not JSON"));
  EXPECT_THAT(told("[]"), HasSubstr("must be an object"));
  EXPECT_THAT(told("{}"), HasSubstr("meta.image: must be the name"));
  EXPECT_THAT(told(R"({"frames":{},"meta":{"image":"atlas.png"}})"), HasSubstr("frames: has no frames"));
  EXPECT_THAT(told(R"({"frames":7,"meta":{"image":"atlas.png"}})"), HasSubstr("frames: must be an object of frames"));
  EXPECT_THAT(told(R"({"textures":[]})"), HasSubstr("textures: must be a list"));
  EXPECT_THAT(told(R"({"textures":[5]})"), HasSubstr("textures[0]: must be an object"));
  EXPECT_THAT(told(std::string(100000, '[')), HasSubstr("nested deeper"));
  const std::string frame = R"({"filename":"a","frame":{"x":0,"y":0,"w":1,"h":1}})";
  const std::string meta = R"(,"meta":{"image":"atlas.png"}})";
  EXPECT_THAT(told(R"({"frames":[)" + frame + ',' + frame + ']' + meta), HasSubstr("frames[1]: is called 'a'"));
  EXPECT_THAT(told(R"({"frames":{"a":)" + frame + R"(,"a":)" + frame + '}' + meta), HasSubstr("occurs twice"));
  EXPECT_THAT(told(R"({"frames":[{"frame":{}}])" + meta), HasSubstr("frames[0].filename"));
  std::string many = R"({"frames":[7)";
  for (int i = 0; i < 16384; ++i) many += ",7";
  EXPECT_THAT(told(many + ']' + meta), HasSubstr("more than 16384 frames"));
}

TEST_F(SpriteRead, ImagesStayInTheFolder) {
  const auto told = [&](const std::string& image) {
    EXPECT_FALSE(read_list({{"frames", {{"a", {{"frame", box(0, 0, 1, 1)}}}}}, {"meta", {{"image", image}}}})) << image;
    return to_text(told_);
  };
  EXPECT_THAT(told("/etc/passwd"), HasSubstr("is an absolute path"));
  EXPECT_THAT(told("../atlas.png"), HasSubstr("leads out"));
  EXPECT_THAT(told("a/../../atlas.png"), HasSubstr("leads out"));
  EXPECT_THAT(told("a\\atlas.png"), HasSubstr("backslash"));
  EXPECT_THAT(told("http://x/atlas.png"), HasSubstr("scheme"));
  EXPECT_THAT(told(""), HasSubstr("is empty"));
  EXPECT_THAT(told("none.png"), HasSubstr("is missing"));
  std::filesystem::create_directories(folder_ / "in");
  std::filesystem::copy_file(folder_ / "atlas.png", folder_ / "in/atlas.png");
  EXPECT_TRUE(read_list({{"frames", {{"a", {{"frame", box(0, 0, 1, 1)}}}}}, {"meta", {{"image", "in/atlas.png"}}}}));
}

TEST_F(SpriteRead, ImagesMayLieWithinTheRoot) {
  const std::string list = R"({"frames":{"a":{"frame":{"x":0,"y":0,"w":1,"h":1}}},"meta":{"image":"../atlas.png"}})";
  const auto read_within = [&](const std::filesystem::path& root) {
    return read_sprite_list(std::as_bytes(std::span(list)), "list.json", folder_ / "in", told_, {.root = root});
  };
  std::filesystem::create_directories(folder_ / "in");
  EXPECT_TRUE(read_within(folder_)) << to_text(told_);
  EXPECT_FALSE(read_within(folder_ / "in"));
}

TEST_F(SpriteRead, OtherSizesAreToldOf) {
  EXPECT_TRUE(read_list({{"frames", {{"a", {{"frame", box(0, 0, 1, 1)}}}}},
                         {"meta", {{"image", "atlas.png"}, {"size", {{"w", 128}, {"h", 64}}}}}}));
  EXPECT_THAT(to_text(told_), HasSubstr("made for an image of 128 x 64"));
}

TEST_F(SpriteRead, ListsAreToldFromOtherJson) {
  testing::put(folder_ / "package.json", R"({"name":"x","frames-per-second":60})");
  EXPECT_FALSE(images_of_list(folder_ / "package.json"));
  testing::put(folder_ / "other.json", R"({"animation":{"frames":[1,2]}})");
  EXPECT_FALSE(images_of_list(folder_ / "other.json"));
  read_list({{"frames", {{"a", {{"frame", box(0, 0, 1, 1)}}}}}, {"meta", {{"image", "atlas.png"}}}});
  EXPECT_EQ(images_of_list(folder_ / "list.json"), std::vector{folder_ / "atlas.png"});
}

}  // namespace
}  // namespace foredraw::sprite_read_test
