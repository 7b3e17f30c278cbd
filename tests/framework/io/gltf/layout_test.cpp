// Where changed data lies: what was shared, interleaved or side by side stays so, and nothing dead is left.
#include <gtest/gtest.h>

#include "framework/io/gltf/edits.h"
#include "support/gltf_builder.h"
#include "support/meshes.h"

namespace foredraw::layout_test {
namespace {

using namespace foredraw::testing;

TEST(GltfLayout, shared_accessor_is_redefined_where_all_agree) {
  Scene scene = read(sharing());
  for (Draw& draw : scene.draws) reverse(draw);
  EXPECT_EQ(written(scene), json_of(sharing().glb()));
}

TEST(GltfLayout, shared_accessor_is_parted_where_users_differ) {
  Scene scene = read(sharing());
  reverse(scene.draws[1]);
  const GltfJson json = written(scene);
  const GltfJson& primitives = json["meshes"][0]["primitives"];
  EXPECT_EQ(primitives[0]["indices"], 2);
  EXPECT_EQ(primitives[1]["indices"], 3);
  EXPECT_EQ(primitives[2]["indices"], 2);
  const Scene again = read(write(scene));
  for (std::size_t d = 0; d < 3; ++d) EXPECT_EQ(indices_of(again, d), indices_of(scene, d));
}

TEST(GltfLayout, streams_that_share_an_accessor_may_part) {
  Scene scene = read(sharing());
  reverse_vertices(scene, 0, 0);  // draws 0 and 1; draw 2 keeps the old positions
  const GltfJson json = written(scene);
  const GltfJson& primitives = json["meshes"][0]["primitives"];
  EXPECT_EQ(primitives[2]["attributes"]["POSITION"], 0);
  EXPECT_EQ(primitives[0]["attributes"]["POSITION"], primitives[1]["attributes"]["POSITION"]);
  EXPECT_NE(primitives[0]["attributes"]["POSITION"], 0);
  EXPECT_EQ(primitives[0]["attributes"]["TEXCOORD_0"], 1) << "nobody else has these";
  const Scene again = read(write(scene));
  for (std::size_t d = 0; d < 3; ++d) {
    EXPECT_EQ(again.draws[d].levels[0].vertices->stamp(), scene.draws[d].levels[0].vertices->stamp()) << d;
    EXPECT_EQ(indices_of(again, d), indices_of(scene, d));
  }
  EXPECT_EQ(again.draws[0].levels[0].vertices, again.draws[1].levels[0].vertices) << "what shared still shares";
}

struct Vertex {
  float position[3];
  std::uint8_t colour[4];
  float uv[2];
};

/// `meshes` quads in one interleaved view and one view of indices.
GltfBuilder interleaved(std::size_t meshes) {
  std::vector<Vertex> vertices;
  std::vector<std::uint16_t> indices;
  for (std::size_t m = 0; m < meshes; ++m) {
    for (int v = 0; v < 4; ++v) {
      const float x = static_cast<float>(m) + static_cast<float>(v & 1);
      vertices.push_back({{x, static_cast<float>(v / 2), 0}, {std::uint8_t(v), std::uint8_t(m), 3, 255}, {x, 1}});
    }
    for (std::uint16_t i : {0, 1, 2, 2, 1, 3}) indices.push_back(i);
  }
  GltfBuilder builder;
  const std::size_t view = builder.add_view(std::as_bytes(std::span(vertices)), sizeof(Vertex));
  const std::size_t index_view = builder.add_view(std::as_bytes(std::span(indices)));
  for (std::size_t m = 0; m < meshes; ++m) {
    const std::size_t at = 4 * m * sizeof(Vertex);
    const std::size_t position = builder.add_accessor(view, at, 5126, "VEC3", 4);
    const std::size_t colour = builder.add_accessor(view, at + 12, 5121, "VEC4", 4);
    const std::size_t uv = builder.add_accessor(view, at + 16, 5126, "VEC2", 4);
    builder.json["accessors"][colour]["normalized"] = true;
    const std::size_t index = builder.add_accessor(index_view, 12 * m, 5123, "SCALAR", 6);
    builder.add_mesh(
        {{"attributes", {{"POSITION", position}, {"COLOR_0", colour}, {"TEXCOORD_0", uv}}}, {"indices", index}});
  }
  return builder;
}

TEST(GltfLayout, interleaved_vertices_stay_interleaved) {
  Scene scene = read(interleaved(3));
  reverse_vertices(scene, 1);
  const GltfJson before = json_of(interleaved(3).glb());
  GltfJson after = written(scene);
  EXPECT_EQ(after["bufferViews"], before["bufferViews"]);
  for (std::size_t a = 0; a < after["accessors"].size(); ++a) {
    EXPECT_EQ(after["accessors"][a]["byteOffset"], before["accessors"][a]["byteOffset"]) << a;
    EXPECT_EQ(after["accessors"][a]["bufferView"], before["accessors"][a]["bufferView"]) << a;
  }
  const Scene again = read(write(scene));
  for (std::size_t d = 0; d < 3; ++d) {
    EXPECT_EQ(again.draws[d].levels[0].vertices->stamp(), scene.draws[d].levels[0].vertices->stamp()) << d;
  }
}

TEST(GltfLayout, dropped_vertices_leave_no_hole_in_a_view_of_many) {
  Scene scene = read(interleaved(3));
  scene.draws[1].levels[0].orders[0].indices = Shared<std::uint32_t>(Indices{2, 1, 3});
  reverse_vertices(scene, 1, 1);
  const GltfJson json = written(scene);
  EXPECT_EQ(json["bufferViews"][0]["byteLength"], 11 * sizeof(Vertex));
  EXPECT_EQ(json["bufferViews"][1]["byteLength"], 12 + 8 + 12) << "six bytes of indices, filled up to four";
  EXPECT_EQ(json["accessors"][8]["byteOffset"], 7 * sizeof(Vertex));
  const Scene again = read(write(scene));
  for (std::size_t d = 0; d < 3; ++d) {
    EXPECT_EQ(again.draws[d].levels[0].vertices->stamp(), scene.draws[d].levels[0].vertices->stamp()) << d;
    EXPECT_EQ(indices_of(again, d), indices_of(scene, d)) << d;
  }
}

VertexStream as_int16(const VertexStream& positions) {
  std::vector<std::int16_t> values;
  for (const glm::vec3& p : decode_vec3(positions)) {
    for (int c = 0; c < 3; ++c) values.push_back(static_cast<std::int16_t>(p[c]));
  }
  const auto bytes = std::as_bytes(std::span(values));
  return {"POSITION", {Component::int16, 3, false, 6}, Shared<std::byte>({bytes.begin(), bytes.end()})};
}

TEST(GltfLayout, narrower_positions_have_rows_of_four_bytes) {
  Scene scene = read(ribbon(2));
  const VertexStream narrow = as_int16(stream(scene, 0, "POSITION"));
  scene.draws[0].levels[0].vertices = std::make_shared<const VertexStreams>(with_stream(scene, 0, narrow));
  const GltfJson json = written(scene);
  EXPECT_EQ(json["accessors"][0]["componentType"], 5122);
  EXPECT_EQ(json["accessors"][0]["max"].dump(), "[2,1,0]");
  EXPECT_EQ(json["bufferViews"][0]["byteStride"], 8);
  EXPECT_EQ(json["bufferViews"][0]["byteLength"], 6 * 8);
  EXPECT_EQ(json["bufferViews"].size(), 3u);
  EXPECT_EQ(json["extensionsRequired"], GltfJson::array({"KHR_mesh_quantization"}));
  EXPECT_EQ(json["extensionsUsed"], json["extensionsRequired"]);
  EXPECT_EQ(stream(read(write(scene)), 0, "POSITION").bytes, narrow.bytes);
}

TEST(GltfLayout, narrower_positions_in_interleaved_rows_are_packed_again) {
  Scene scene = read(interleaved(2));
  for (std::size_t d = 0; d < 2; ++d) {
    const VertexStream narrow = as_int16(stream(scene, d, "POSITION"));
    scene.draws[d].levels[0].vertices = std::make_shared<const VertexStreams>(with_stream(scene, d, narrow));
  }
  const GltfJson json = written(scene);
  EXPECT_EQ(json["bufferViews"][0]["byteStride"], 8 + 4 + 8);
  EXPECT_EQ(json["bufferViews"][0]["byteLength"], 8 * 20);
  EXPECT_EQ(json["bufferViews"].size(), 2u);
  const Scene again = read(write(scene));
  EXPECT_EQ(again.draws[1].levels[0].vertices->stamp(), scene.draws[1].levels[0].vertices->stamp());
}

TEST(GltfLayout, left_out_attribute_lets_go_of_its_bytes_but_keeps_its_number) {
  Scene scene = read(ribbon(2));
  VertexStreams streams = *scene.draws[0].levels[0].vertices;
  std::erase_if(streams.base, [](const VertexStream& s) { return s.semantic == "TEXCOORD_0"; });
  scene.draws[0].levels[0].vertices = std::make_shared<const VertexStreams>(streams);
  const GltfJson json = written(scene);
  EXPECT_EQ(json["accessors"].size(), 3u);
  EXPECT_FALSE(json["accessors"][1].contains("bufferView"));
  EXPECT_EQ(json["bufferViews"].size(), 2u);
  EXPECT_EQ(json["accessors"][2]["bufferView"], 1);
  EXPECT_EQ(json["buffers"][0]["byteLength"], 6 * 12 + 24);
  EXPECT_FALSE(json["meshes"][0]["primitives"][0]["attributes"].contains("TEXCOORD_0"));
}

TEST(GltfLayout, unknown_extensions_and_extras_stay_and_so_does_all_they_may_point_at) {
  GltfBuilder builder = puppet();
  builder.json["extensionsUsed"] = {"ACME_secrets"};
  builder.json["extensions"]["ACME_secrets"] = {{"bufferView", 6}, {"accessor", 2}};
  builder.json["extras"] = {{"author", "somebody"}, {"number", 1.5}};
  builder.json["nodes"][0]["extras"] = {1, 2, 3};
  Scene scene = read(builder);
  reverse(scene.draws[0]);
  reverse_vertices(scene, 0);
  const Bytes file = write(scene);
  const GltfJson json = json_of(file);
  EXPECT_EQ(json["extensions"], builder.json["extensions"]);
  EXPECT_EQ(json["extras"], builder.json["extras"]);
  EXPECT_EQ(json["nodes"], builder.json["nodes"]);
  for (std::size_t v = 0; v < builder.json["bufferViews"].size(); ++v) {
    EXPECT_EQ(json["bufferViews"][v], builder.json["bufferViews"][v]) << v;
  }
  EXPECT_EQ(json["accessors"][2], builder.json["accessors"][2]) << "the extension may mean this one";
  const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  const std::string_view bytes(reinterpret_cast<const char*>(builder.buffer.data()), builder.buffer.size());
  EXPECT_NE(text.find(bytes), std::string_view::npos) << "the old buffer is there whole";
  EXPECT_EQ(indices_of(read(file), 0), indices_of(scene, 0));
  EXPECT_EQ(read(file).draws[0].levels[0].vertices->stamp(), scene.draws[0].levels[0].vertices->stamp());
}

TEST(GltfLayout, instancing_attributes_are_users_too) {
  GltfBuilder builder = ribbon(2);
  builder.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = 0;
  Scene scene = read(builder);
  reverse_vertices(scene, 0);
  const GltfJson json = written(scene);
  EXPECT_EQ(json["accessors"][0], builder.json["accessors"][0]);
  EXPECT_EQ(json["meshes"][0]["primitives"][0]["attributes"]["POSITION"], 3);
}

TEST(GltfLayout, several_buffers_become_one_unless_an_unknown_extension_tells_them_apart) {
  GltfBuilder builder = ribbon(2);
  builder.json["buffers"][0]["byteLength"] = builder.buffer.size();
  builder.json["buffers"][1] = {{"byteLength", 4}, {"uri", "data:;base64,AQIDBA=="}};
  builder.add("bufferViews", {{"buffer", 1}, {"byteLength", 4}});
  Scene scene = read(builder);
  EXPECT_EQ(write(scene), builder.glb());
  reverse(scene.draws[0]);
  GltfJson json = written(scene);
  EXPECT_EQ(json["buffers"].size(), 1u);
  EXPECT_EQ(json["bufferViews"][3]["buffer"], 0);
  EXPECT_EQ(json["bufferViews"][3]["byteLength"], 4);
  EXPECT_EQ(write(scene).back(), std::byte{4});

  builder.json["extensions"]["ACME_archive"] = {{"buffer", 1}};
  scene = read(builder);
  reverse(scene.draws[0]);
  Diagnostics diagnostics;
  EXPECT_FALSE(encode_gltf(scene, "out.glb", diagnostics));
  EXPECT_EQ(diagnostics.all().at(0).code, "cannot-express");
}

TEST(GltfLayout, sparse_accessor_whose_neighbour_shrinks_keeps_its_elements) {
  GltfBuilder builder = interleaved(2);  // the second quad's uvs become sparse
  const std::vector<std::uint8_t> places{2};
  const std::vector<float> values{7, 8};
  const std::size_t where = builder.add_view(std::as_bytes(std::span(places)));
  const std::size_t what = builder.add_view(std::as_bytes(std::span(values)));
  builder.json["accessors"][6]["sparse"] = {
      {"count", 1}, {"indices", {{"bufferView", where}, {"componentType", 5121}}}, {"values", {{"bufferView", what}}}};
  Scene scene = read(builder);
  reverse_vertices(scene, 0, 2);  // the first quad loses two vertices, so that the second moves down
  scene.draws[0].levels[0].orders[0].indices = Shared<std::uint32_t>(Indices{0, 1, 0});
  const Scene again = read(write(scene));
  EXPECT_EQ(written(scene)["accessors"][6]["sparse"]["count"], 1);
  for (std::size_t d = 0; d < 2; ++d) {
    EXPECT_EQ(again.draws[d].levels[0].vertices->stamp(), scene.draws[d].levels[0].vertices->stamp()) << d;
  }
}

}  // namespace
}  // namespace foredraw::layout_test
