// What is written of sprites: polygons come from the draws' own triangles.
#include <foredraw/image/sprite_pieces.h>
#include <foredraw/io/image/images.h>
#include <foredraw/io/scene_file.h>
#include <foredraw/io/sprite/sprite_files.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <set>

#include "support/meshes.h"
#include "support/program.h"
#include "support/sprites.h"

namespace foredraw::sprite_write_test {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::HasSubstr;
using ::testing::Not;

Json box(int x, int y, int w, int h) { return {{"x", x}, {"y", y}, {"w", w}, {"h", h}}; }

class SpriteWrite : public testing::InFolder {
 protected:
  SpriteWrite() {
    testing::put_bytes(folder_ / "atlas.png", testing::disc_png(64, 32));
    const Json list = {{"frames",
                        {{"left", {{"pivot", {{"x", 0.25}}}, {"frame", box(0, 0, 32, 32)}, {"rotated", false}}},
                         {"a & <b>\"?",
                          {{"frame", box(32, 4, 20, 24)},
                           {"rotated", true},
                           {"trimmed", true},
                           {"spriteSourceSize", box(3, 5, 20, 24)},
                           {"sourceSize", {{"w", 30}, {"h", 40}}}}}}},
                       {"meta", {{"app", "packer"}, {"image", "atlas.png"}, {"mine", {1, "two"}}}}};
    testing::put(folder_ / "list.json", list.dump(1));
  }

  Scene read(const std::string& name) {
    auto file = read_scene((folder_ / name).string(), told_);
    EXPECT_TRUE(file) << to_text(told_);
    return file ? std::move(file->scene) : Scene{};
  }
  Scene trimmed(const std::string& name, int corners = 6) {
    Scene scene = read(name);
    for (Draw& draw : scene.draws) testing::trim(draw, corners);
    return scene;
  }
  std::string text(const Scene& scene, const std::string& name) {
    const auto files = encode_scene(scene, (folder_ / name).string(), told_);
    EXPECT_TRUE(files) << to_text(told_);
    if (!files) return {};
    const auto& bytes = files->front().bytes;
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  std::string refused(const Scene& scene, const std::string& name) {
    Diagnostics told;
    EXPECT_FALSE(encode_scene(scene, (folder_ / name).string(), told)) << name;
    return to_text(told);
  }

  Diagnostics told_;
};

TEST_F(SpriteWrite, AListKeepsWhatItHeld) {
  const Json was = Json::parse(testing::content(folder_ / "list.json"));
  Json now = Json::parse(text(trimmed("list.json"), "out.json"));
  for (auto& [name, frame] : now["frames"].items()) {
    EXPECT_EQ(frame["vertices"].size(), 6u);
    EXPECT_EQ(frame["verticesUV"].size(), 6u);
    EXPECT_EQ(frame["triangles"].size(), 4u);
    for (const char* key : {"vertices", "verticesUV", "triangles"}) frame.erase(key);
  }
  EXPECT_EQ(now["meta"]["polygons"]["winding"], "counter-clockwise");
  now["meta"].erase("polygons");
  EXPECT_EQ(now.dump(), was.dump());  // with the sequence of the keys
}

TEST_F(SpriteWrite, TexelsAreThoseOfTheCoordinates) {
  const Scene scene = trimmed("list.json", 7);
  const Json now = Json::parse(text(scene, "out.json"));
  std::size_t d = 0;
  for (const auto& [name, frame] : now["frames"].items()) {
    const auto t = decode_vec3(*scene.draws[d].levels[0].vertices->find("TEXCOORD_0"));
    const auto p = decode_vec3(*scene.draws[d].levels[0].vertices->find("POSITION"));
    const glm::vec2 whole_middle = d == 0 ? glm::vec2(16, 16) : glm::vec2(3 + 10, 5 + 12);
    for (std::size_t v = 0; v < 7; ++v) {
      EXPECT_EQ(frame["verticesUV"][v][0].get<float>(), t[v].x * 64);
      EXPECT_EQ(frame["verticesUV"][v][1].get<float>(), t[v].y * 32);
      // As the draw's own positions say, in texels and with y down.
      EXPECT_NEAR(frame["vertices"][v][0].get<float>(), whole_middle.x + 64 * p[v].x, 1e-4) << name << v;
      EXPECT_NEAR(frame["vertices"][v][1].get<float>(), whole_middle.y - 64 * p[v].y, 1e-4) << name << v;
    }
    ++d;
  }
}

TEST_F(SpriteWrite, AnImageBecomesANewListThatIsRead) {
  testing::put(folder_ / "out.json", text(trimmed("atlas.png"), "out.json"));
  const Json list = Json::parse(testing::content(folder_ / "out.json"));
  EXPECT_EQ(list["frames"][0]["filename"], "atlas");
  EXPECT_EQ(list["meta"]["app"], "foredraw");
  EXPECT_EQ(list["meta"]["image"], "atlas.png");
  EXPECT_EQ(list["meta"]["size"], (Json{{"w", 64}, {"h", 32}}));
  const Scene again = read("out.json");
  EXPECT_EQ(again.draws[0].frame, (SpriteFrame{0, 0, 64, 32}));
  EXPECT_THAT(to_text(told_), HasSubstr("already have polygons"));
}

TEST_F(SpriteWrite, ListsElsewhereNameTheSameImage) {
  const Scene scene = read("list.json");
  EXPECT_EQ(Json::parse(text(scene, "made/out.json"))["meta"]["image"], "../atlas.png");
}

TEST_F(SpriteWrite, PartsOfASpriteAreFramesOfTheirOwn) {
  Scene scene = read("list.json");
  Draw half = scene.draws[0];
  half.name = "half";
  half.frame = SpriteFrame{0, 0, 16, 32};
  testing::trim(half, 5);
  scene.draws[0].name = "left/rest";
  scene.draws[0].frame = SpriteFrame{16, 0, 16, 32};
  scene.draws.insert(scene.draws.begin(), half);
  for (Mesh& mesh : scene.meshes) {
    for (DrawId& id : mesh.draws) ++id;
  }
  scene.meshes[0].draws.insert(scene.meshes[0].draws.begin(), 0);
  const Json frames = Json::parse(text(scene, "out.json"))["frames"];
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_EQ(frames.items().begin().key(), "half");
  EXPECT_EQ(frames["half"]["frame"], box(0, 0, 16, 32));
  EXPECT_EQ(frames["half"]["pivot"]["x"], 0.25);  // what is not known stays
  EXPECT_EQ(frames["left/rest"]["sourceSize"]["w"], 16);
  EXPECT_TRUE(frames.contains("a & <b>\"?"));
}

TEST_F(SpriteWrite, DrawsThatNoFrameStandsForAreNewFramesBehindTheOthers) {
  Scene scene = read("list.json");
  Draw made = scene.draws[0];
  made.name = "made";
  made.origin.reset();
  scene.draws.insert(scene.draws.begin(), made);
  const Json frames = Json::parse(text(scene, "out.json"))["frames"];
  ASSERT_EQ(frames.size(), 3u);
  ASSERT_EQ(frames.get_ref<const Json::object_t&>().back().first, "made");
  EXPECT_EQ(frames["made"]["frame"], box(0, 0, 32, 32));
  EXPECT_FALSE(frames["made"].contains("pivot")) << "which is that of the frame it was made of";
}

TEST_F(SpriteWrite, WithoutItsFileASceneNamesItsImages) {
  Scene scene = read("list.json");
  scene.source = nullptr;
  scene.images[0].name = "painted.png";
  const Json list = Json::parse(text(scene, "out.json"));
  EXPECT_EQ(list["meta"]["image"], "painted.png");
  EXPECT_EQ(list["frames"][0]["filename"], scene.draws[0].name);
}

TEST_F(SpriteWrite, SeveralScenesAreATextureForEachImage) {
  testing::put_bytes(folder_ / "other.png", testing::disc_png(16, 16));
  const std::vector<Scene> scenes = {read("other.png"), trimmed("list.json"), read("atlas.png"), read("atlas.png")};
  const auto file = encode_sprites(scenes, folder_ / "all.json", told_);
  ASSERT_TRUE(file) << to_text(told_);
  testing::put_bytes(folder_ / "all.json", file->bytes);
  const Scene again = read("all.json");
  ASSERT_EQ(again.draws.size(), 5u);
  EXPECT_EQ(again.images.size(), 2u);
  EXPECT_EQ(again.draws[4].name, "atlas#2");
}

TEST_F(SpriteWrite, AHeaderCompiles) {
  Scene scene = trimmed("list.json");
  scene.draws.push_back(scene.draws[0]);
  scene.draws.back().name = "left";
  scene.draws.back().frame->width = 31;  // another sprite of the same name
  scene.draws.push_back(scene.draws[0]);
  scene.draws.back().levels[0].orders[0].indices = {};
  testing::put(folder_ / "out 1.h", text(scene, "out 1.h"));
  const std::string header = testing::content(folder_ / "out 1.h");
  EXPECT_THAT(header, HasSubstr("out_1_left_2_uv"));
  EXPECT_THAT(header, HasSubstr("out_1_a_b_uv"));
  EXPECT_THAT(header, HasSubstr(R"("a & <b>\042\077")"));
  testing::put(folder_ / "use.c", "#include \"out 1.h\"\n#include \"out 1.h\"\nint main(void) { return 0; }\n");
  testing::put(folder_ / "use.cpp",
               "#include \"out 1.h\"\nint main() { return out_1_frames[3].uv == NULL ? 0 : 1; }\n");
  const std::string in = "cd '" + folder_.string() + "' && ";
  if (std::system("cc --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "there is no compiler here";
  EXPECT_EQ(std::system((in + "cc -std=c99 -Wall -Wextra -Werror -pedantic use.c -o use").c_str()), 0);
  EXPECT_EQ(std::system((in + "c++ -std=c++11 -Wall -Wextra -Werror -pedantic use.cpp -o use && ./use").c_str()), 0);
}

TEST_F(SpriteWrite, PagesAreMade) {
  const std::string made = text(trimmed("list.json"), "out.html");
  EXPECT_THAT(made, HasSubstr("a &amp; &lt;b&gt;&quot;?"));
  EXPECT_THAT(made, Not(HasSubstr("<b>\"")));
  EXPECT_THAT(made, Not(HasSubstr("script")));
  EXPECT_THAT(made, HasSubstr("2 sprites, 12 vertices, "));
  const std::string uri = "data:image/png;base64,";
  ASSERT_THAT(made, HasSubstr(uri));
  EXPECT_EQ(made.find(uri), made.rfind(uri)) << "once";
  const std::string polygon = "class=\"polygon\" d=\"";
  const std::size_t at = made.find(polygon) + polygon.size();
  ASSERT_GT(at, polygon.size());
  EXPECT_EQ(std::count(made.begin() + at, made.begin() + made.find('"', at), 'L'), 5) << "six corners";
}

TEST_F(SpriteWrite, ImagesOfOtherKindsBecomePng) {
  testing::put_bytes(folder_ / "a.tga", testing::tga_of({16, 16, 4, 8}, testing::discs(16, 16)));
  testing::put_bytes(folder_ / "b.exr",
                     testing::exr_of({16, 16, 4, 32, true}, std::vector<float>(16 * 16 * 4, 0.5f), "zip"));
  for (const char* image : {"a.tga", "b.exr"}) {
    EXPECT_THAT(text(read(image), "out.html"), HasSubstr("data:image/png;base64,iVBOR")) << image;
  }
  EXPECT_TRUE(encode_scene(read("a.tga"), (folder_ / "a.glb").string(), told_));
  EXPECT_THAT(refused(read("b.exr"), "b.glb"), HasSubstr("an image of floats"));
}

TEST_F(SpriteWrite, GltfHoldsTheSprites) {
  for (const char* target : {"out.glb", "out.gltf"}) {
    const Scene scene = read("list.json");
    auto files = encode_scene(scene, (folder_ / target).string(), told_);
    ASSERT_TRUE(files) << to_text(told_);
    ASSERT_TRUE(write_scene(*files, told_));
    const Scene again = read(target);
    ASSERT_EQ(again.draws.size(), 2u);
    for (const Draw& draw : again.draws) {
      EXPECT_TRUE(draw.traits.has(traits::sprite));
      EXPECT_TRUE(draw.traits.has(traits::double_sided));
    }
    ASSERT_EQ(again.materials.size(), 1u);
    EXPECT_EQ(again.materials[0].alpha_mode, AlphaMode::blend);
    ASSERT_TRUE(again.materials[0].base_colour);
    EXPECT_EQ(again.materials[0].base_colour->wrap[1], Wrap::clamped);
    EXPECT_EQ(again.images[0].bytes, scene.images[0].bytes);
    EXPECT_EQ(again.nodes[1].transform.translation, scene.nodes[1].transform.translation);
  }
  const auto files = encode_scene(trimmed("list.json"), (folder_ / "trimmed.glb").string(), told_);
  ASSERT_TRUE(files && write_scene(*files, told_));
  const Scene again = read("trimmed.glb");
  EXPECT_EQ(sprite_pieces(again.draws[1])[0].outline.size(), 6u);
}

TEST_F(SpriteWrite, NothingThatWasReadIsReplaced) {
  const Scene scene = read("list.json");
  EXPECT_THAT(refused(scene, "list.json"), HasSubstr("list.json: error: would replace a file"));
  std::filesystem::create_symlink(folder_ / "atlas.png", folder_ / "link.html");
  EXPECT_THAT(refused(scene, "link.html"), HasSubstr("would replace a file"));
}

TEST_F(SpriteWrite, MeshesAreNoSprites) {
  Scene scene = testing::scene_of(testing::grid(2, 2));
  for (const char* name : {"a.json", "a.h", "a.html"}) {
    EXPECT_THAT(refused(scene, name), HasSubstr("has no frame")) << name;
  }
  EXPECT_THAT(refused({}, "a.html"), HasSubstr("no sprite"));
  Diagnostics told;
  EXPECT_FALSE(can_write_scene("a.html", "a.glb", told));
  EXPECT_THAT(to_text(told), HasSubstr("holds only sprites"));
  EXPECT_TRUE(can_write_scene("a.html", "a.png", told));
}

TEST_F(SpriteWrite, SeveralScenesAreWrittenOrNone) {
  const Scene scene = read("list.json");
  std::vector<std::vector<OutputFile>> all;
  for (const char* name : {"a.html", "b.gltf", "c.gltf"}) {
    all.push_back(*encode_scene(scene, (folder_ / name).string(), told_));
  }
  ASSERT_TRUE(write_scenes(all, told_)) << to_text(told_);
  EXPECT_EQ(files(),
            (std::vector<std::string>{"a.html", "atlas.png", "b.bin", "b.gltf", "c.bin", "c.gltf", "list.json"}));
  all.front().front().path = folder_ / "no/a.html";
  all.back().front().path = folder_ / "d.gltf";
  EXPECT_FALSE(write_scenes(all, told_));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "d.gltf"));
}

}  // namespace
}  // namespace foredraw::sprite_write_test
