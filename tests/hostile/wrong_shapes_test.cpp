// Files that are too deep, too wide, run in circles, or say much with little.
#include "whole_way.h"

#include "support/gltf_builder.h"
#include "support/program.h"

#include <foredraw/scene/subject.h>

namespace foredraw::wrong_shapes_test {
namespace {

using testing::bytes_of;
using testing::GltfBuilder;
using testing::GltfJson;
using testing::go_the_whole_way;

using Codes = std::vector<std::string>;

std::string repeated(const std::string& text, std::size_t times) {
  std::string result;
  for (std::size_t i = 0; i < times; ++i) result += text;
  return result;
}

Codes codes_of(const std::string& text) { return go_the_whole_way(bytes_of(text)); }

TEST(WrongShapes, deep_nesting_is_refused_before_it_is_parsed) {
  constexpr std::size_t deep = 100'000;
  const std::string arrays = repeated("[", deep) + repeated("]", deep);
  const std::string objects = repeated("{\"a\":", deep) + "0" + repeated("}", deep);
  for (const std::string& nested : {arrays, objects, repeated("[", deep), repeated("[{\"a\":", deep)}) {
    for (const char* key : {"extras", "nodes", "extensions", "asset", "bufferViews"}) {
      EXPECT_EQ(codes_of(R"({"asset":{"version":"2.0"},")" + std::string(key) + "\":" + nested + "}"),
                Codes{"json-nesting"});
    }
    EXPECT_EQ(go_the_whole_way(testing::glb_of("{\"extras\":" + nested + "}", {})), Codes{"json-nesting"});
  }
}

TEST(WrongShapes, circles_of_nodes_are_refused) {
  constexpr std::size_t many = 50'000;
  GltfBuilder circle;
  for (std::size_t i = 0; i < many; ++i) circle.add("nodes", {{"children", {(i + 1) % many}}});
  EXPECT_EQ(go_the_whole_way(circle.gltf()), Codes{"node-cycle"});
  EXPECT_EQ(codes_of(R"({"asset":{"version":"2.0"},"nodes":[{"children":[0]}]})"), Codes{"node-cycle"});
  EXPECT_EQ(
      codes_of(
          R"({"asset":{"version":"2.0"},"nodes":[{"children":[1]},{"children":[0]}],"skins":[{"joints":[0,1],"skeleton":1}]})"),
      Codes{"node-cycle"});
  EXPECT_EQ(codes_of(R"({"asset":{"version":"2.0"},"nodes":[{"children":[1,1]},{}]})"), Codes{"node-parents"});
}

/// A chain is no circle, however long. Names of characters, what hangs below what and who is moved must not take the
/// square of its length: that would be longer than a test may take.
TEST(WrongShapes, long_chains_are_read) {
  constexpr std::size_t many = 100'000;
  GltfBuilder chain = testing::puppet();
  GltfJson joints = GltfJson::array();  // the deepest first, so that each hangs below another
  for (std::size_t i = 3; i < many; ++i) {
    chain.json["nodes"][i - 1]["children"] = {i};
    chain.add("nodes", GltfJson::object());
  }
  for (std::size_t i = many; i-- > 1;) joints.push_back(i);
  chain.json["skins"][0] = {{"joints", joints}};
  Diagnostics diagnostics;
  const auto scene = read_gltf(chain.glb(), "chain", {}, diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  EXPECT_EQ(subjects_of(*scene).size(), 1u);
}

TEST(WrongShapes, primitives_times_nodes_are_bounded) {
  GltfBuilder builder = testing::ribbon(1);
  const GltfJson primitive = builder.json["meshes"][0]["primitives"][0];
  for (int i = 1; i < 3000; ++i) builder.json["meshes"][0]["primitives"].push_back(primitive);
  for (int i = 1; i < 3000; ++i) builder.add("nodes", {{"mesh", 0}});
  EXPECT_EQ(go_the_whole_way(builder.glb()), Codes{"too-many-draws"});
  GltfBuilder instanced = testing::ribbon(1);
  const std::size_t zeros =
      instanced.add("accessors", {{"componentType", 5126}, {"type", "VEC3"}, {"count", 5'000'000}});
  instanced.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"] = zeros;
  EXPECT_EQ(go_the_whole_way(instanced.glb()), Codes{"too-many-draws"});
}

TEST(WrongShapes, keys_that_stand_twice_are_refused) {
  EXPECT_EQ(codes_of(R"({"asset":{"version":"2.0"},"asset":{"version":"2.0"}})"), Codes{"json-duplicate-key"});
  EXPECT_EQ(codes_of(R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0,"mesh":1}]})"), Codes{"json-duplicate-key"});
  EXPECT_EQ(codes_of(R"({"asset":{"version":"2.0","version":"2.0"}})"), Codes{"json-duplicate-key"});
}

TEST(WrongShapes, a_crowd_of_keys_is_refused) {
  std::string text = R"({"asset":{"version":"2.0"},"extras":{)";
  for (int i = 0; i < 1'000'000; ++i) text += '"' + std::to_string(i) + "\":0,";
  text.back() = '}';
  EXPECT_EQ(codes_of(text + '}'), Codes{"json-crowd"});
}

TEST(WrongShapes, text_that_is_no_utf8_is_refused) {
  for (const char* bad : {"\xff", "\xc0\x80", "\xed\xa0\x80", "\xf5\x80\x80\x80", "\xe2\x82", "\x80"}) {
    EXPECT_EQ(codes_of(R"({"asset":{"version":"2.0"},"nodes":[{"name":")" + std::string(bad) + "\"}]}"),
              Codes{"json-syntax"});
    EXPECT_EQ(codes_of(R"({"asset":{"version":"2.0"},")" + std::string(bad) + "\":0}"), Codes{"json-syntax"});
  }
  EXPECT_TRUE(codes_of("{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{\"name\":\"\\u0000\\ud83d\\ude00\"}]}").empty());
  EXPECT_EQ(codes_of(R"({"asset":{"version":"2.0"},"nodes":[{"name":"\ud800"}]})"), Codes{"json-syntax"});
}

#ifdef FOREDRAW_PROGRAM
/// With a limit that reading stays far below, and that a copy for each reader of the bytes would exceed.
class SmallFiles : public testing::InFolder {
 protected:
  testing::Ended optimize(const std::string& name, std::span<const std::byte> bytes) {
    testing::put(folder_ / name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    const std::string limit = testing::is_sanitized ? "" : " --memory-limit 500M";
    return testing::run_program(folder_,
                                "optimize " + name + " -o out.glb -p weld --with vertex-cache --threads 2" + limit);
  }

  /// Ten million bytes, as positions; who draws them is left to the test.
  static GltfBuilder big_buffer() {
    GltfBuilder builder;
    builder.add_view(std::vector<std::byte>(10'000'000 / 12 * 12));
    builder.add_values(std::vector<std::uint16_t>{0, 1, 2}, "SCALAR");
    return builder;
  }

  static void add_primitive(GltfBuilder& builder, std::size_t position) {
    builder.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", position}}}, {"indices", 0}});
  }
};

TEST_F(SmallFiles, many_primitives_share_one_accessor) {
  GltfBuilder builder = big_buffer();
  const std::size_t position = builder.add_accessor(0, 0, 5126, "VEC3", 833'333);
  for (int i = 0; i < 60; ++i) add_primitive(builder, position);
  builder.add("nodes", {{"mesh", 0}});
  const testing::Ended ended = optimize("in.glb", builder.glb());
  EXPECT_EQ(ended.code, 0) << ended.err.substr(0, 2000);
}

TEST_F(SmallFiles, many_accessors_lie_over_the_same_bytes) {
  GltfBuilder builder = big_buffer();
  for (int i = 0; i < 60; ++i) add_primitive(builder, builder.add_accessor(0, 0, 5126, "VEC3", 833'333));
  builder.add("nodes", {{"mesh", 0}});
  const testing::Ended ended = optimize("in.glb", builder.glb());
  EXPECT_EQ(ended.code, 0) << ended.err.substr(0, 2000);
}

TEST_F(SmallFiles, many_accessors_that_overlap_are_refused) {
  GltfBuilder builder = big_buffer();
  for (std::size_t i = 0; i < 2000; ++i) add_primitive(builder, builder.add_accessor(0, 12 * i, 5126, "VEC3", 800'000));
  builder.add("nodes", {{"mesh", 0}});
  const testing::Ended ended = optimize("in.glb", builder.glb());
  EXPECT_EQ(ended.code, 2);
  EXPECT_NE(ended.err.find("in.glb: error: accessors["), std::string::npos) << ended.err.substr(0, 2000);
  EXPECT_EQ(files(), Codes{"in.glb"});
}

TEST_F(SmallFiles, many_views_that_overlap_are_refused) {
  GltfBuilder builder = big_buffer();
  for (int i = 0; i < 2000; ++i) builder.add("bufferViews", builder.json["bufferViews"][0]);
  const testing::Ended ended = optimize("in.glb", builder.glb());
  EXPECT_EQ(ended.code, 2);
  EXPECT_NE(ended.err.find("in.glb: error: bufferViews["), std::string::npos) << ended.err.substr(0, 2000);
}

TEST_F(SmallFiles, many_images_share_one_view) {
  GltfBuilder builder = big_buffer();
  for (int i = 0; i < 2000; ++i) builder.add("images", {{"bufferView", 0}, {"mimeType", "image/png"}});
  EXPECT_EQ(optimize("in.glb", builder.glb()).code, 0);
}

TEST_F(SmallFiles, many_buffers_share_one_file) {
  testing::put(folder_ / "data.bin", std::string(10'000'000, '\0'));
  GltfBuilder builder;
  for (std::size_t i = 0; i < 2000; ++i) {
    builder.add("buffers", {{"uri", repeated("./", i % 50) + "data.bin"}, {"byteLength", 9'000'000 + i}});
  }
  const std::string text = builder.json.dump();
  EXPECT_EQ(optimize("in.gltf", std::as_bytes(std::span(text))).code, 0);
}

TEST_F(SmallFiles, zeros_without_end_are_refused) {
  GltfBuilder builder;
  builder.add("accessors", {{"componentType", 5126}, {"type", "VEC3"}, {"count", 4294967295u}});
  builder.add_mesh({{"attributes", {{"POSITION", 0}}}});
  const testing::Ended ended = optimize("in.gltf", builder.gltf());
  EXPECT_EQ(ended.code, 2);
  EXPECT_NE(ended.err.find("accessors[0].count"), std::string::npos) << ended.err;
}

TEST_F(SmallFiles, a_large_data_uri_is_read_once) {
  GltfBuilder builder = big_buffer();
  builder.json["extras"] = "x";
  EXPECT_EQ(optimize("in.gltf", builder.gltf()).code, 0);
}

/// A file may be far longer than its buffer, and far longer than the memory.
TEST_F(SmallFiles, of_a_long_file_only_the_buffer_is_read) {
  testing::put(folder_ / "data.bin", "");
  std::filesystem::resize_file(folder_ / "data.bin", std::uintmax_t{1} << 40);
  GltfBuilder builder = testing::ribbon(1);
  builder.json["buffers"][0] = {{"uri", "data.bin"}, {"byteLength", builder.buffer.size()}};
  const std::string text = builder.json.dump();
  const testing::Ended ended = optimize("in.gltf", std::as_bytes(std::span(text)));
  EXPECT_EQ(ended.code, 0) << ended.err;
}
#endif

}  // namespace
}  // namespace foredraw::wrong_shapes_test
