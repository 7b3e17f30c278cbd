// What is touched is written, and nothing else.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "framework/io/gltf/edits.h"
#include "support/gltf_builder.h"
#include "support/meshes.h"
#include "support/test_folder.h"

namespace foredraw::gltf_write_test {
namespace {

using namespace foredraw::testing;

TEST(GltfWrite, untouched_file_comes_out_byte_for_byte) {
  EXPECT_EQ(write(read(puppet())), puppet().glb());
  Diagnostics diagnostics;
  const auto files = encode_gltf(read(puppet().gltf()), "out.gltf", diagnostics);
  ASSERT_EQ(files->size(), 1u);
  EXPECT_EQ(files->front().bytes, puppet().gltf());
}

/// A .bin beside is that of a .gltf of the name, which may be written there too.
TEST(GltfWrite, untouched_glb_takes_in_the_bytes_that_lay_beside_it) {
  const testing::TestFolder own;
  const std::filesystem::path& folder = own.path();
  std::filesystem::create_directories(folder / "out");
  const GltfBuilder built = ribbon(3);
  GltfJson json = built.json;
  json["buffers"] = {{{"byteLength", built.buffer.size()}, {"uri", "a.bin"}}};
  const auto put = [&](const char* name, const Bytes& bytes) {
    std::ofstream(folder / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  };
  put("a.glb", glb_of(json.dump(), {}));
  put("a.bin", built.buffer);
  Diagnostics diagnostics;
  const auto scene = read_gltf(folder / "a.glb", diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  const auto files = encode_gltf(*scene, folder / "out/a.glb", diagnostics);
  ASSERT_TRUE(files) << to_text(diagnostics);
  EXPECT_EQ(files->size(), 1u);
  EXPECT_EQ(stream(read(files->front().bytes), 0, "POSITION").bytes.stamp(),
            stream(*scene, 0, "POSITION").bytes.stamp());
}

TEST(GltfWrite, reordered_triangles_change_the_bytes_of_the_indices_alone) {
  Scene scene = read(puppet());
  reverse(scene.draws[0]);
  const Bytes before = puppet().glb();
  const Bytes after = write(scene);
  EXPECT_EQ(json_of(after), json_of(before));
  std::size_t differing = 0;
  for (std::size_t i = 0; i < before.size(); ++i) differing += before[i] != after[i];
  EXPECT_GT(differing, 0u);
  EXPECT_LE(differing, 48u);
  EXPECT_EQ(indices_of(read(after), 0), indices_of(scene, 0));
  EXPECT_EQ(write(scene), after) << "twice the same bytes";
}

TEST(GltfWrite, moved_vertices_drop_sparse_and_keep_the_rest) {
  Scene scene = read(puppet());
  reverse_vertices(scene, 0);
  const GltfJson json = written(scene);
  EXPECT_FALSE(json["accessors"][5].contains("sparse"));
  EXPECT_EQ(json["bufferViews"].size(), 11u) << "two of thirteen held sparse elements";
  EXPECT_EQ(json["accessors"][0]["min"], puppet().json["accessors"][0]["min"]);
  EXPECT_EQ(json["accessors"][0]["max"].dump(), "[4,1,0]") << "equal numbers keep their letters";
  EXPECT_EQ(json["accessors"][5]["max"].dump(), "[7.0,8.0,9.0]") << "positions have a range, of targets too";
  EXPECT_EQ(json["animations"], puppet().json["animations"]);
  const Scene again = read(write(scene));
  EXPECT_EQ(again.draws[0].levels[0].vertices->stamp(), scene.draws[0].levels[0].vertices->stamp());
  EXPECT_EQ(again.images[0].bytes, scene.images[0].bytes);
  EXPECT_EQ(again.animations[0].channels[0].values, scene.animations[0].channels[0].values);
}

TEST(GltfWrite, range_is_of_finite_positions) {
  Scene scene = read(ribbon(1));
  std::vector<glm::vec3> positions = decode_vec3(stream(scene, 0, "POSITION"));
  positions[0].x = std::numeric_limits<float>::quiet_NaN();
  positions[3].y = 5;
  VertexStream changed = stream(scene, 0, "POSITION");
  const auto bytes = std::as_bytes(std::span(positions));
  changed.bytes = Shared<std::byte>({bytes.begin(), bytes.end()});
  scene.draws[0].levels[0].vertices = std::make_shared<const VertexStreams>(with_stream(scene, 0, changed));
  const GltfJson json = written(scene);
  EXPECT_EQ(json["accessors"][0]["min"].dump(), "[0,0,0]");
  EXPECT_EQ(json["accessors"][0]["max"].dump(), "[1,5.0,0]");
}

TEST(GltfWrite, index_type_stays_or_grows) {
  const auto type_after = [](int squares, std::uint32_t vertices, bool eight_bit) {
    GltfBuilder builder = ribbon(static_cast<std::size_t>(squares));
    if (eight_bit) {
      builder.json["meshes"][0]["primitives"][0]["indices"] =
          builder.add_values(std::vector<std::uint8_t>{0, 1, 2}, "SCALAR");
    }
    Scene scene = read(builder);
    const std::vector<glm::vec3> positions(vertices, glm::vec3(1));
    scene.draws[0].levels[0].vertices = vertex_streams(positions);
    scene.draws[0].levels[0].orders[0].indices = Shared<std::uint32_t>(Indices{vertices - 1, 0, 1});
    const GltfJson json = written(scene);
    return json["accessors"][json["meshes"][0]["primitives"][0]["indices"].get<std::size_t>()]["componentType"]
        .get<int>();
  };
  EXPECT_EQ(type_after(4, 4, false), 5123) << "16 bits stay 16 bits";
  EXPECT_EQ(type_after(4, 65535, false), 5123);
  EXPECT_EQ(type_after(4, 65536, false), 5125) << "65535 is kept free";
  EXPECT_EQ(type_after(4, 255, true), 5121);
  EXPECT_EQ(type_after(4, 256, true), 5123);
}

/// A strip, a fan and an unindexed list over the same six vertices.
GltfBuilder shapes() {
  GltfBuilder builder = ribbon(2);
  GltfJson& primitives = builder.json["meshes"][0]["primitives"];
  const GltfJson first = primitives[0];
  for (int mode : {5, 6, 4}) {
    GltfJson primitive = first;
    primitive["mode"] = mode;
    if (mode == 4) primitive.erase("indices");
    primitives.push_back(primitive);
  }
  primitives.erase(0);
  return builder;
}

TEST(GltfWrite, strips_and_unindexed_draws_stay_until_their_triangles_change) {
  Scene scene = read(shapes());
  scene.materials.push_back({"new", AlphaMode::opaque, 0.5f, true});
  GltfJson json = written(scene);
  EXPECT_EQ(json["meshes"], shapes().json["meshes"]);

  for (Draw& draw : scene.draws) reverse(draw);
  json = written(scene);
  const Scene again = read(write(scene));
  for (std::size_t d = 0; d < 3; ++d) {
    EXPECT_EQ(json["meshes"][0]["primitives"][d]["mode"], 4);
    EXPECT_TRUE(json["meshes"][0]["primitives"][d].contains("indices"));
    EXPECT_EQ(indices_of(again, d), indices_of(scene, d));
  }
}

TEST(GltfWrite, unindexed_draw_whose_vertices_follow_its_triangles_stays_unindexed) {
  GltfBuilder builder = shapes();
  builder.json["meshes"][0]["primitives"].erase(0);
  builder.json["meshes"][0]["primitives"].erase(0);
  Scene scene = read(builder);
  const std::vector<std::uint32_t> whole{3, 4, 5, 0, 1, 2};
  reverse(scene.draws[0]);
  scene.draws[0] = with_vertices_moved(
      scene.draws[0], 0,
      std::make_shared<const VertexStreams>(with_vertices_moved(*scene.draws[0].levels[0].vertices, whole, 6)), whole);
  EXPECT_FALSE(written(scene)["meshes"][0]["primitives"][0].contains("indices"));
  EXPECT_EQ(read(write(scene)).draws[0].levels[0].vertices->stamp(), scene.draws[0].levels[0].vertices->stamp());
}

TEST(GltfWrite, sequence_of_keys_is_kept) {
  GltfBuilder builder = ribbon(2);
  const std::string text = R"({"scenes":[],"extras":{"z":1,"a":2},"asset":{"generator":"x","version":"2.0"}})";
  GltfJson odd = GltfJson::parse(text);
  odd.erase("scenes");
  for (const auto& [key, value] : builder.json.items()) {
    if (key != "asset") odd[key] = value;
  }
  builder.json = odd;
  Scene scene = read(builder);
  reverse(scene.draws[0]);
  EXPECT_EQ(written(scene).dump(), json_of(builder.glb()).dump());
}

TEST(GltfWrite, draws_may_be_added_and_taken_away) {
  Scene scene = read(sharing());
  Draw added = draw_of(grid(3, 3), "added");
  scene.draws.push_back(added);
  scene.meshes[0].draws = {2, 3, 0};
  const Scene again = read(write(scene));
  ASSERT_EQ(again.draws.size(), 3u);
  EXPECT_EQ(indices_of(again, 0), indices_of(scene, 2));
  EXPECT_EQ(indices_of(again, 1), indices_of(scene, 3));
  EXPECT_EQ(again.draws[1].levels[0].vertices->stamp(), added.levels[0].vertices->stamp());
  EXPECT_EQ(again.draws[2].levels[0].vertices->stamp(), scene.draws[0].levels[0].vertices->stamp());
}

TEST(GltfWrite, empty_draw_is_written_as_a_triangle_without_area) {
  Scene scene = read(ribbon(2));
  scene.draws[0].levels[0].orders[0].indices = Shared<std::uint32_t>(Indices{});
  EXPECT_EQ(indices_of(read(write(scene)), 0), (Indices{0, 0, 0}));
}

TEST(GltfWrite, images_and_materials_may_change) {
  Scene scene = read(puppet());
  const Bytes picture = bytes_of("\x89PNG, longer than it was before");
  scene.images[0].bytes = Shared<std::byte>(picture);
  scene.materials[0].double_sided = false;
  scene.images.push_back({"second", "image/jpeg", "", Shared<std::byte>(picture)});
  const Scene again = read(write(scene));
  EXPECT_EQ(again.images[0].bytes, scene.images[0].bytes);
  EXPECT_EQ(again.images[1].media_type, "image/jpeg");
  EXPECT_EQ(again.images[1].bytes, scene.images[1].bytes);
  EXPECT_FALSE(again.materials[0].double_sided);
  EXPECT_EQ(again.materials[0].alpha_cutoff, 0.25f);
  EXPECT_EQ(again.draws[0].levels[0].vertices->stamp(), scene.draws[0].levels[0].vertices->stamp());
}

/// As exporters pack them: a picture that an extension alone names, or with a plain one beside it.
TEST(GltfWrite, pictures_that_no_decoder_knows_pass_through_and_are_known_to_be_the_texture) {
  struct Packed {
    const char* extension;
    const char* media_type;
    std::string bytes;
  };
  const Packed all[] = {{"KHR_texture_basisu", "image/ktx2", "\xabKTX 20\xbb\r\n\x1a\n and supercompressed texels"},
                        {"EXT_texture_webp", "image/webp", "RIFF----WEBPVP8L----"},
                        {"EXT_texture_avif", "image/avif", "----ftypavif----"}};
  for (const auto& [extension, media_type, bytes] : all) {
    for (const bool has_plain : {false, true}) {
      GltfBuilder built = ribbon(3);
      const auto view = built.add_view(std::as_bytes(std::span(bytes)));
      GltfJson texture{{"extensions", {{extension, {{"source", has_plain ? 1 : 0}}}}}};
      if (has_plain) {
        built.add("images", {{"uri", "data:image/png;base64,AAAA"}});
        texture["source"] = 0;
      }
      built.add("images", {{"bufferView", view}, {"mimeType", media_type}});
      built.add("textures", texture);
      built.add("materials", {{"alphaMode", "MASK"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
      built.json["meshes"][0]["primitives"][0]["material"] = 0;
      built.json["extensionsUsed"] = {extension};
      if (!has_plain) built.json["extensionsRequired"] = {extension};
      Scene scene = read(built.glb());
      EXPECT_EQ(scene.materials[0].base_colour->image, 0u) << "where there are two, the one that all viewers show";
      reverse(scene.draws[0]);
      const Scene after = read(write(scene));
      const auto kept = after.images[has_plain ? 1 : 0].bytes.view();
      EXPECT_TRUE(std::ranges::equal(kept, std::as_bytes(std::span(bytes)))) << extension;
      EXPECT_EQ(json_of(write(scene))["textures"], built.json["textures"]);
    }
  }
}

TEST(GltfWrite, what_can_not_be_said_is_an_error) {
  const Scene scene = read(puppet());
  const auto refused = [](const Scene& changed, const std::string& inside) {
    Diagnostics diagnostics;
    const auto files = encode_gltf(changed, "out.glb", diagnostics);
    return !files && diagnostics.all().size() == 1 && diagnostics.all()[0].code == "cannot-express" &&
           diagnostics.all()[0].where.inside == inside;
  };
  Scene changed = scene;
  changed.nodes[1].skin = 0;
  EXPECT_TRUE(refused(changed, "nodes[1]"));
  changed = scene;
  changed.animations.clear();
  EXPECT_TRUE(refused(changed, "animations"));
  changed = scene;
  changed.skins[0].joints = {2, 1};
  EXPECT_TRUE(refused(changed, "skins[0]"));
  changed = scene;
  changed.meshes[0].draws.clear();
  EXPECT_TRUE(refused(changed, ""));
  changed = scene;
  changed.images[0].bytes = Shared<std::byte>(bytes_of("?"));
  changed.images[0].media_type.clear();
  EXPECT_TRUE(refused(changed, "images[0]"));
}

TEST(GltfWrite, made_scene_is_written_whole) {
  const Scene scene = scene_of({draw_of(torus(8, 6), "ring"), draw_of(soup(5, 1), "soup")});
  const Scene again = read(write(scene));
  ASSERT_EQ(again.draws.size(), 2u);
  for (std::size_t d = 0; d < 2; ++d) {
    EXPECT_EQ(indices_of(again, d), indices_of(scene, d));
    EXPECT_EQ(again.draws[d].levels[0].vertices->stamp(), scene.draws[d].levels[0].vertices->stamp());
    EXPECT_EQ(again.draws[d].name, scene.draws[d].name);
  }
  EXPECT_EQ(again.nodes.size(), 2u);
  const GltfJson json = written(scene);
  EXPECT_EQ(json["scenes"][0]["nodes"], GltfJson::array({0, 1}));
  EXPECT_FALSE(json["meshes"][1]["primitives"][0].contains("indices")) << "soup names each vertex in turn";
}

TEST(GltfWrite, instances_are_written_as_gpu_instancing) {
  Scene scene = scene_of({draw_of(torus(8, 6), "ring"), draw_of(soup(5, 1), "soup")});
  std::vector<Transform> three(3);
  three[1].translation = {1, 2, 3};
  scene.nodes[1].instances = Shared<Transform>(three);
  GltfJson json = written(scene);
  EXPECT_EQ(json["extensionsUsed"], GltfJson::array({"EXT_mesh_gpu_instancing"}));
  EXPECT_EQ(json["extensionsRequired"], json["extensionsUsed"]) << "without it there would be one in place of three";
  EXPECT_FALSE(json["nodes"][0].contains("extensions"));
  EXPECT_EQ(json["nodes"][1]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"].size(), 1u);
  three[0].rotation = glm::quat(0, 0, 1, 0);
  three[2].scale = {1, -2, 1};
  scene.nodes[1].instances = Shared<Transform>(three);
  const Scene again = read(write(scene));
  EXPECT_TRUE(again.nodes[0].instances.empty());
  EXPECT_EQ(again.nodes[1].instances, scene.nodes[1].instances);
  EXPECT_EQ(write(again), write(scene));
}

TEST(GltfWrite, chunks_of_others_are_kept) {
  Bytes file = ribbon(2).glb();
  const Bytes chunk = bytes_of(std::string("\4\0\0\0ACMEdata", 12));
  file.insert(file.end(), chunk.begin(), chunk.end());
  const auto length = static_cast<std::uint32_t>(file.size());
  std::memcpy(file.data() + 8, &length, 4);
  Scene scene = read(file);
  reverse(scene.draws[0]);
  const Bytes after = write(scene);
  EXPECT_TRUE(std::equal(chunk.rbegin(), chunk.rend(), after.rbegin()));
}

}  // namespace
}  // namespace foredraw::gltf_write_test
