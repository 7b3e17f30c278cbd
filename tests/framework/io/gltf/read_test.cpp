// What a scene holds after reading.
#include <foredraw/io/gltf/gltf.h>

#include <gtest/gtest.h>

#include "support/gltf_builder.h"

namespace foredraw::gltf_read_test {
namespace {

using testing::GltfBuilder;
using testing::GltfJson;
using Indices = std::vector<std::uint32_t>;

Scene read_built(const GltfBuilder& builder) {
  Diagnostics diagnostics;
  auto scene = read_gltf(builder.glb(), "test.glb", {}, diagnostics);
  if (!scene) throw std::runtime_error(to_text(diagnostics));
  return *scene;
}

Indices indices_of(const Scene& scene, std::size_t draw = 0) {
  const auto view = scene.draws[draw].levels[0].orders[0].indices.view();
  return {view.begin(), view.end()};
}

/// Five vertices in a row, drawn in that mode; indexed where there are indices.
Scene five_points(int mode, const std::vector<std::uint8_t>& indices = {}) {
  GltfBuilder builder;
  GltfJson primitive{{"mode", mode}};
  primitive["attributes"]["POSITION"] = builder.add_values(std::vector<float>(15, 1), "VEC3");
  if (!indices.empty()) primitive["indices"] = builder.add_values(indices, "SCALAR");
  builder.add_mesh(primitive);
  return read_built(builder);
}

TEST(GltfRead, strips_fans_and_loops_become_lists) {
  EXPECT_EQ(indices_of(five_points(0)), (Indices{0, 1, 2, 3, 4}));
  EXPECT_EQ(indices_of(five_points(1, {0, 1, 3, 4})), (Indices{0, 1, 3, 4}));
  EXPECT_EQ(indices_of(five_points(2)), (Indices{0, 1, 1, 2, 2, 3, 3, 4, 4, 0}));
  EXPECT_EQ(indices_of(five_points(3)), (Indices{0, 1, 1, 2, 2, 3, 3, 4}));
  EXPECT_EQ(indices_of(five_points(4, {0, 1, 2})), (Indices{0, 1, 2}));
  EXPECT_EQ(indices_of(five_points(5)), (Indices{0, 1, 2, 1, 3, 2, 2, 3, 4}));
  EXPECT_EQ(indices_of(five_points(6)), (Indices{1, 2, 0, 2, 3, 0, 3, 4, 0}));
}

TEST(GltfRead, degenerate_triangles_of_strips_are_kept) {
  EXPECT_EQ(indices_of(five_points(5, {0, 1, 2, 2, 3})), (Indices{0, 1, 2, 1, 2, 2, 2, 2, 3}));
}

TEST(GltfRead, the_greatest_index_of_its_type_begins_a_new_strip) {
  EXPECT_EQ(indices_of(five_points(2, {0, 1, 255, 2, 3, 4})), (Indices{0, 1, 1, 0, 2, 3, 3, 4, 4, 2}));
  EXPECT_EQ(indices_of(five_points(3, {255, 0, 1, 255, 255, 3, 4, 255})), (Indices{0, 1, 3, 4}));
  EXPECT_EQ(indices_of(five_points(5, {0, 1, 2, 255, 1, 2, 3, 4})), (Indices{0, 1, 2, 1, 2, 3, 2, 4, 3}));
  EXPECT_EQ(indices_of(five_points(6, {0, 1, 255, 2, 3, 4})), (Indices{3, 4, 2}));
}

TEST(GltfRead, topology_and_its_trait) {
  EXPECT_EQ(five_points(0).draws[0].topology, Topology::points);
  EXPECT_EQ(five_points(2).draws[0].topology, Topology::lines);
  EXPECT_EQ(five_points(6).draws[0].topology, Topology::triangles);
  EXPECT_FALSE(five_points(0).draws[0].traits.has(traits::triangles));
  EXPECT_TRUE(five_points(5).draws[0].traits.has(traits::triangles));
}

TEST(GltfRead, sparse_elements_are_put_in) {
  const Scene scene = read_built(testing::puppet());
  const VertexStream& target = scene.draws[0].levels[0].vertices->morph_targets.at(0).at(0);
  const std::vector<glm::vec3> values = decode_vec3(target);
  EXPECT_EQ(values[0], glm::vec3(0.5f));
  EXPECT_EQ(values[1], glm::vec3(1, 2, 3));
  EXPECT_EQ(values[4], glm::vec3(4, 5, 6));
  EXPECT_EQ(values[9], glm::vec3(7, 8, 9));
}

TEST(GltfRead, accessor_without_bytes_is_zeros) {
  GltfBuilder builder = testing::ribbon(1);
  const std::size_t zeros = builder.add("accessors", {{"componentType", 5126}, {"type", "VEC3"}, {"count", 4}});
  builder.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = zeros;
  EXPECT_EQ(decode_vec3(*read_built(builder).draws[0].levels[0].vertices->find("NORMAL")),
            std::vector<glm::vec3>(4, glm::vec3(0)));
}

TEST(GltfRead, interleaved_and_quantised_streams_come_tight_in_their_own_format) {
  struct Vertex {
    std::int16_t position[3], unused;
    std::uint8_t colour[4];
  };
  const std::vector<Vertex> vertices = {
      {{1, 2, 3}, 0, {9, 8, 7, 6}}, {{4, 5, 6}, 0, {5, 4, 3, 2}}, {{7, 8, 9}, 0, {1, 0, 1, 0}}};
  GltfBuilder builder;
  const std::size_t view = builder.add_view(std::as_bytes(std::span(vertices)), sizeof(Vertex));
  const std::size_t position = builder.add_accessor(view, 0, 5122, "VEC3", 3);
  const std::size_t colour = builder.add_accessor(view, 8, 5121, "VEC4", 3);
  builder.json["accessors"][position]["normalized"] = true;
  builder.add_mesh({{"attributes", {{"POSITION", position}, {"COLOR_0", colour}}}});
  const Scene scene = read_built(builder);
  const VertexStreams& streams = *scene.draws[0].levels[0].vertices;
  EXPECT_EQ(streams.count, 3u);
  EXPECT_EQ(streams.find("POSITION")->format, (Format{Component::int16, 3, true, 6}));
  EXPECT_EQ(streams.find("POSITION")->bytes.size(), 18u);
  EXPECT_EQ(streams.find("COLOR_0")->format, (Format{Component::uint8, 4, false, 4}));
  EXPECT_FLOAT_EQ(decode_vec3(*streams.find("POSITION"))[2].z, 9 / 32767.0f);
  EXPECT_EQ(decode_vec3(*streams.find("COLOR_0"))[1], glm::vec3(5, 4, 3));
  EXPECT_TRUE(scene.draws[0].traits.has(traits::quantized));
}

TEST(GltfRead, equal_accessors_share_streams) {
  GltfBuilder builder = testing::ribbon(3);
  GltfJson& primitives = builder.json["meshes"][0]["primitives"];
  const GltfJson first = primitives[0];
  primitives.push_back(first);
  primitives.push_back(first);
  primitives[2]["attributes"].erase("TEXCOORD_0");
  const Scene scene = read_built(builder);
  EXPECT_EQ(scene.draws[0].levels[0].vertices, scene.draws[1].levels[0].vertices);
  EXPECT_NE(scene.draws[0].levels[0].vertices, scene.draws[2].levels[0].vertices);
  EXPECT_TRUE(scene.draws[0]
                  .levels[0]
                  .vertices->find("POSITION")
                  ->bytes.is(scene.draws[2].levels[0].vertices->find("POSITION")->bytes));
  EXPECT_TRUE(scene.draws[0].levels[0].orders[0].indices.is(scene.draws[2].levels[0].orders[0].indices));
}

TEST(GltfRead, names_and_origins_of_draws) {
  GltfBuilder builder = testing::ribbon(1);
  const GltfJson primitive = builder.json["meshes"][0]["primitives"][0];
  builder.json["meshes"][0]["name"] = "Rock";
  builder.add("meshes", {{"name", "House"}, {"primitives", {primitive, primitive}}});
  builder.add("meshes", {{"primitives", {primitive, primitive}}});
  builder.json["meshes"][2]["primitives"].erase(1);
  const Scene scene = read_built(builder);
  ASSERT_EQ(scene.draws.size(), 4u);
  EXPECT_EQ(scene.draws[0].name, "Rock");
  EXPECT_EQ(scene.draws[1].name, "House/0");
  EXPECT_EQ(scene.draws[2].name, "House/1");
  EXPECT_EQ(scene.draws[3].name, "mesh2");
  EXPECT_EQ(scene.draws[2].origin, (DrawOrigin{1, 1}));
  EXPECT_EQ(scene.meshes[1].draws, (std::vector<DrawId>{1, 2}));
}

TEST(GltfRead, structure_of_the_puppet) {
  const Scene scene = read_built(testing::puppet());
  EXPECT_EQ(scene.name, "test.glb");
  ASSERT_EQ(scene.nodes.size(), 3u);
  EXPECT_EQ(scene.nodes[2].transform.translation, glm::vec3(0, 1, 0));
  EXPECT_EQ(scene.skins[0].joints, (std::vector<NodeId>{1, 2}));
  EXPECT_EQ(scene.skins[0].inverse_bind_matrices[1], glm::mat4(1));
  ASSERT_EQ(scene.animations[0].channels.size(), 2u);
  EXPECT_EQ(scene.animations[0].channels[0].path, AnimatedPath::rotation);
  EXPECT_EQ(scene.animations[0].channels[0].values.view()[6], 1.0f);
  EXPECT_TRUE(scene.animations[0].channels[0].times.is(scene.animations[0].channels[1].times));
  EXPECT_EQ(scene.materials[0].alpha_mode, AlphaMode::mask);
  EXPECT_EQ(scene.materials[0].alpha_cutoff, 0.25f);
  EXPECT_EQ(scene.images[0].media_type, "image/png");
  EXPECT_EQ(scene.images[0].bytes.size(), 16u);
  EXPECT_EQ(scene.draws[0].traits, (Traits{traits::triangles, traits::uv0, traits::skinned, traits::morphed,
                                           traits::animated, traits::masked, traits::double_sided}));
}

TEST(GltfRead, morph_weights_at_rest_are_those_of_mesh_and_node) {
  GltfBuilder builder = testing::puppet();
  builder.json["meshes"][0]["weights"] = {0.75};
  EXPECT_EQ(read_built(builder).meshes[0].weights, std::vector<float>{0.75f});
  EXPECT_EQ(read_built(builder).nodes[0].weights, std::vector<float>{});
  builder.json["nodes"][0]["weights"] = {0.5};
  EXPECT_EQ(read_built(builder).nodes[0].weights, std::vector<float>{0.5f});
}

TEST(GltfRead, the_texture_that_masks) {
  GltfBuilder builder = testing::puppet();
  const Texture plain = *read_built(builder).materials[0].base_colour;
  EXPECT_EQ(plain.image, ImageId{0});
  EXPECT_EQ(plain.texcoord, 0u);
  EXPECT_EQ(plain.wrap, (std::array{Wrap::repeat, Wrap::repeat}));
  EXPECT_FALSE(plain.is_nearest);
  EXPECT_EQ(plain.scale, glm::dvec2(1));

  builder.json["samplers"][0] = {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}};
  GltfJson& surface = builder.json["materials"][0]["pbrMetallicRoughness"];
  surface["baseColorFactor"] = {1, 1, 1, 0.25};
  surface["baseColorTexture"]["texCoord"] = 1;
  surface["baseColorTexture"]["extensions"]["KHR_texture_transform"] = {
      {"offset", {0.5, 0.25}}, {"rotation", 1.5}, {"scale", {2, 3}}, {"texCoord", 2}};
  builder.json["extensionsUsed"] = {"KHR_texture_transform"};
  Material material = read_built(builder).materials[0];
  EXPECT_EQ(material.alpha, 0.25f);
  EXPECT_EQ(material.base_colour->wrap, (std::array{Wrap::clamped, Wrap::mirrored}));
  EXPECT_TRUE(material.base_colour->is_nearest);
  EXPECT_EQ(material.base_colour->texcoord, 2u);
  EXPECT_EQ(material.base_colour->offset, glm::dvec2(0.5, 0.25));
  EXPECT_EQ(material.base_colour->rotation, 1.5);
  EXPECT_EQ(material.base_colour->scale, glm::dvec2(2, 3));

  builder.json["textures"][0].erase("source");
  EXPECT_EQ(read_built(builder).materials[0].base_colour->image, std::nullopt);
  surface.erase("baseColorTexture");
  EXPECT_FALSE(read_built(builder).materials[0].base_colour);
}

TEST(GltfRead, a_skeleton_that_moves_as_a_whole_does_not_bend) {
  const auto animated_by = [](std::size_t moved) {
    GltfBuilder builder = testing::puppet();
    builder.add("nodes", {{"name", "root"}, {"children", {1}}});  // 3: above all joints
    builder.json["scenes"][0]["nodes"] = {0, 3};
    builder.json["animations"][0]["channels"].erase(1);
    builder.json["animations"][0]["channels"][0]["target"]["node"] = moved;
    return read_built(builder).draws[0].traits.has(traits::animated);
  };
  EXPECT_FALSE(animated_by(3));
  EXPECT_FALSE(animated_by(0));
  EXPECT_TRUE(animated_by(1));
  EXPECT_TRUE(animated_by(2));
}

TEST(GltfRead, traits_of_material_nodes_and_extensions) {
  GltfBuilder builder = testing::ribbon(1);
  builder.add("materials", {{"alphaMode", "BLEND"}});
  builder.json["meshes"][0]["primitives"][0]["material"] = 0;
  EXPECT_EQ(read_built(builder).draws[0].traits, (Traits{traits::triangles, traits::uv0, traits::blended}));
  builder.json["meshes"][0]["primitives"][0]["extensions"]["KHR_materials_variants"] = GltfJson::object();
  EXPECT_FALSE(read_built(builder).draws[0].traits.has(traits::extended));
  builder.json["meshes"][0]["primitives"][0]["extensions"]["ACME_triangle_tags"] = GltfJson::object();
  EXPECT_TRUE(read_built(builder).draws[0].traits.has(traits::extended));
  EXPECT_FALSE(read_built(builder).draws[0].traits.has(traits::instanced));
  builder.add("nodes", {{"mesh", 0}});
  EXPECT_TRUE(read_built(builder).draws[0].traits.has(traits::instanced));
}

TEST(GltfRead, a_material_that_a_variant_makes_transparent_is_told) {
  const auto keeps_sides = [](const GltfJson& other) {
    GltfBuilder builder = testing::ribbon(1);
    builder.add("materials", {{"name", "own"}});
    builder.add("materials", other);
    GltfJson& primitive = builder.json["meshes"][0]["primitives"][0];
    primitive["material"] = 0;
    primitive["extensions"]["KHR_materials_variants"]["mappings"] = {{{"material", 1}, {"variants", {0}}}};
    return read_built(builder).materials[0].keeps_sides;
  };
  EXPECT_FALSE(keeps_sides({{"name", "red"}}));
  EXPECT_TRUE(keeps_sides({{"alphaMode", "BLEND"}}));
  EXPECT_TRUE(keeps_sides({{"doubleSided", true}}));
  EXPECT_TRUE(keeps_sides({{"extensions", {{"KHR_materials_transmission", GltfJson::object()}}}}));
}

/// A ribbon that is drawn twice.
GltfBuilder instanced_ribbon() {
  GltfBuilder builder = testing::ribbon(1);
  GltfJson attributes;
  attributes["TRANSLATION"] = builder.add_values(std::vector<float>{1, 2, 3, 4, 5, 6}, "VEC3");
  attributes["ROTATION"] = builder.add_values(std::vector<std::int16_t>{0, 0, 0, 32767, 0, -32767, 0, 0}, "VEC4");
  builder.json["accessors"][attributes["ROTATION"].get<std::size_t>()]["normalized"] = true;
  attributes["_TINT"] = builder.add_values(std::vector<float>{1, 0}, "SCALAR");
  builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = attributes;
  return builder;
}

TEST(GltfRead, gpu_instancing_places_a_mesh_several_times) {
  const Scene scene = read_built(instanced_ribbon());
  EXPECT_TRUE(scene.draws[0].traits.has(traits::instanced));
  const auto instances = scene.nodes[0].instances.view();
  ASSERT_EQ(instances.size(), 2u);
  EXPECT_EQ(instances[0].translation, glm::vec3(1, 2, 3));
  EXPECT_EQ(instances[0].rotation, glm::quat(1, 0, 0, 0));
  EXPECT_EQ(instances[1].translation, glm::vec3(4, 5, 6));
  EXPECT_EQ(instances[1].rotation, glm::quat(0, 0, -1, 0));
  EXPECT_EQ(instances[1].scale, glm::vec3(1));
}

TEST(GltfRead, nodes_of_the_same_instances_share_them) {
  GltfBuilder builder = instanced_ribbon();
  builder.add("nodes", builder.json["nodes"][0]);
  const Scene scene = read_built(builder);
  EXPECT_TRUE(scene.nodes[1].instances.is(scene.nodes[0].instances));
}

TEST(GltfRead, nodes_outside_of_the_scene_that_is_shown_are_not_shown) {
  GltfBuilder builder = testing::ribbon(1);
  builder.json["nodes"] = GltfJson::parse(R"([{"mesh": 0, "children": [2]}, {"mesh": 0}, {"mesh": 0}, {"mesh": 0}])");
  const auto shown = [&] {
    std::vector<bool> are;
    for (const Node& node : read_built(builder).nodes) are.push_back(node.is_shown);
    return are;
  };
  EXPECT_EQ(shown(), std::vector<bool>(4, true)) << "without scenes all are";
  builder.json["scenes"] = GltfJson::parse(R"([{"nodes": [0]}, {"nodes": [1, 3]}, {}])");
  EXPECT_EQ(shown(), (std::vector<bool>{true, false, true, false})) << "the first where none is the default";
  builder.json["scene"] = 1;
  EXPECT_EQ(shown(), (std::vector<bool>{false, true, false, true}));
  builder.json["scene"] = 2;
  EXPECT_EQ(shown(), std::vector<bool>(4, false));
  for (const char* key : {"scene", "scenes"}) builder.json.erase(key);
  builder.json["nodes"][0]["extensions"]["KHR_node_visibility"]["visible"] = false;
  builder.json["nodes"][1]["extensions"]["KHR_node_visibility"]["visible"] = true;
  builder.json["nodes"][3]["extensions"]["KHR_node_visibility"] = "odd";
  EXPECT_EQ(shown(), (std::vector<bool>{false, true, false, true})) << "with those below it";
}

}  // namespace
}  // namespace foredraw::gltf_read_test
