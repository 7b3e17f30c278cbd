// Faults that do not keep a file from being read: each alone and with each other, read, refused where strict, written.
#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/reading/faults.h>

#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <set>

#include "support/compressed_gltf.h"

namespace foredraw::faults_test {
namespace {

using testing::GltfBuilder;
using testing::GltfJson;
using Bytes = std::vector<std::byte>;

template <class T>
void poke(GltfBuilder& b, std::size_t accessor, std::size_t element, T value) {
  const GltfJson& view = b.json["bufferViews"][b.json["accessors"][accessor]["bufferView"].get<std::size_t>()];
  std::memcpy(b.buffer.data() + view["byteOffset"].get<std::size_t>() + element * sizeof(T), &value, sizeof(T));
}

GltfJson& primitive(GltfBuilder& b) { return b.json["meshes"][0]["primitives"][0]; }

/// The text of a GLB's first chunk changed, and the lengths with it.
Bytes with_json(const Bytes& glb, const std::function<void(std::string&)>& change) {
  std::uint32_t length;
  std::memcpy(&length, glb.data() + 12, 4);
  std::string text(reinterpret_cast<const char*>(glb.data()) + 20, length);
  change(text);
  const Bytes changed = testing::bytes_of(text);
  Bytes made(glb.begin(), glb.begin() + 20);
  made.insert(made.end(), changed.begin(), changed.end());
  made.insert(made.end(), glb.begin() + 20 + length, glb.end());
  const auto whole = static_cast<std::uint32_t>(made.size()), part = static_cast<std::uint32_t>(changed.size());
  std::memcpy(made.data() + 8, &whole, 4);
  std::memcpy(made.data() + 12, &part, 4);
  return made;
}

/// A buffer behind that of the file's own bytes.
std::size_t add_buffer(GltfBuilder& b, GltfJson buffer) {
  if (!b.json.contains("buffers")) b.json["buffers"] = {{{"byteLength", 0}}};
  GltfJson& own = b.json["buffers"][0]["byteLength"];
  own = std::max(own.get<std::size_t>(), b.buffer.size());
  return b.add("buffers", std::move(buffer));
}

void add_view_that_is_too_long(GltfBuilder& b) {
  const std::string eighty_zeros = "data:application/octet-stream;base64," + std::string(107, 'A') + "=";
  const std::size_t buffer = add_buffer(b, {{"byteLength", 80}, {"uri", eighty_zeros}});
  const std::size_t view = b.add("bufferViews", {{"buffer", buffer}, {"byteLength", 1 << 20}});
  primitive(b)["attributes"]["TEXCOORD_2"] = b.add_accessor(view, 0, 5126, "VEC2", 10);
}

/// A compressed view in a buffer that has no bytes, and does not say why.
void add_unmarked_fallback(GltfBuilder& b) {
  const GltfBuilder from = testing::compressed(testing::ribbon(1));
  GltfJson view = from.json["bufferViews"][0];
  GltfJson& said = view["extensions"]["EXT_meshopt_compression"];
  said["byteOffset"] = said.value("byteOffset", std::size_t{0}) + b.buffer.size();
  b.buffer.insert(b.buffer.end(), from.buffer.begin(), from.buffer.end());
  view["buffer"] = add_buffer(b, {{"byteLength", 1000}});
  b.add("bufferViews", view);
  b.json["extensionsUsed"].push_back("EXT_meshopt_compression");
  b.json["extensionsRequired"].push_back("EXT_meshopt_compression");
}

struct Maker {
  const char* code;
  bool is_kept;  ///< in the output as it was, so that the output has the fault, too
  std::function<void(GltfBuilder&)> breaks;
  std::function<Bytes(Bytes)> breaks_file = {};
};

/// In this sequence: what breaks the file comes behind what breaks its content.
const std::vector<Maker>& makers() {
  static const std::vector<Maker> all = {
      {"version-number", false, [](auto& b) { b.json["asset"]["version"] = 2.0; }},
      {"required-extension", true,
       [](auto& b) {
         b.json["extensionsUsed"] = {"ACME_teapots"};
         b.json["extensionsRequired"] = {"ACME_teapots"};
       }},
      {"unused-data", false,
       [](auto& b) {
         b.add("accessors", {{"bufferView", 0}, {"componentType", 5126}, {"count", 1 << 30}, {"type", "VEC3"}});
       }},
      {"view-target", false, [](auto& b) { b.json["bufferViews"][0]["target"] = 7; }},
      {"alignment", true,
       [](auto& b) {
         const std::size_t view = b.add_view(Bytes(10 * 8 + 2));
         primitive(b)["attributes"]["TEXCOORD_1"] = b.add_accessor(view, 2, 5126, "VEC2", 10);
       }},
      {"bounds", false,
       [](auto& b) {
         b.json["accessors"][1]["max"] = {1e300, 0};
       }},
      {"texture", false, [](auto& b) { b.json["textures"][0]["source"] = 7; }},
      {"image", true,
       [](auto& b) {
         b.add("images", {{"name", "nowhere"}});
       }},
      {"material", false, [](auto& b) { b.json["materials"][0]["alphaCutoff"] = "half"; }},
      {"camera", false, [](auto& b) { b.json["nodes"][1]["camera"] = 3; }},
      {"scene", false, [](auto& b) { b.json["scene"] = 9; }},
      {"nothing-to-draw", true,
       [](auto& b) {
         GltfJson other = primitive(b);
         other["indices"] = b.add_values(std::vector<std::uint16_t>{0, 1}, "SCALAR");
         b.json["meshes"][0]["primitives"].push_back(other);
       }},
      {"restart-index", true,
       [](auto& b) {
         std::vector<float> positions(3 * 256);
         for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = static_cast<float>(i % 7);
         const std::size_t places = b.add_values(positions, "VEC3");
         const std::size_t indices = b.add_values(std::vector<std::uint8_t>{0, 1, 255}, "SCALAR");
         b.add_mesh({{"attributes", {{"POSITION", places}}}, {"indices", indices}});
       }},
      {"morph-targets", true,
       [](auto& b) {
         GltfJson other = primitive(b);
         other.erase("targets");
         b.json["meshes"][0]["primitives"].push_back(other);
       }},
      {"restart", true,
       [](auto& b) {
         const std::size_t places = b.add_values(std::vector<float>(3 * 4, 1), "VEC3");
         const std::size_t indices = b.add_values(std::vector<std::uint8_t>{0, 1, 2, 255, 1, 2, 3}, "SCALAR");
         b.add_mesh({{"attributes", {{"POSITION", places}}}, {"indices", indices}, {"mode", 5}});
       }},
      {"quaternion", true,
       [](auto& b) {
         b.json["nodes"][1]["rotation"] = {0, 0, 0, 2};
       }},
      {"joint-twice", true,
       [](auto& b) {
         b.json["skins"][0]["joints"] = {1, 1};
       }},
      {"unused-joint", true,
       [](auto& b) {
         poke<std::uint8_t>(b, 3, 7, 9);
         poke<float>(b, 4, 7, 0);
       }},
      {"key-times", true, [](auto& b) { poke<float>(b, 7, 2, 0.25f); }},
      {"interpolation", false, [](auto& b) { b.json["animations"][0]["samplers"][0]["interpolation"] = 5; }},
      {"buffer-length", false,
       [](auto& b) {
         b.json["buffers"] = {{{"byteLength", b.buffer.size() + 1000}}};
       }},
      {"empty-view", false,
       [](auto& b) {
         b.add("bufferViews", {{"buffer", 0}, {"byteOffset", b.buffer.size()}, {"byteLength", 0}});
       }},
      {"view-length", false, add_view_that_is_too_long},
      {"fallback", false, add_unmarked_fallback},
      {"byte-order-mark",
       false,
       {},
       [](const Bytes& glb) { return with_json(glb, [](auto& text) { text = "\xEF\xBB\xBF " + text; }); }},
      {"chunk-length", false, {}, [](const Bytes& glb) { return with_json(glb, [](auto& text) { text += ' '; }); }},
      {"trailing-bytes",
       false,
       {},
       [](Bytes glb) {
         glb.resize(glb.size() + 7, std::byte{'x'});
         return glb;
       }},
  };
  return all;
}

Bytes broken(const std::vector<const Maker*>& in) {
  GltfBuilder builder = testing::puppet();
  for (const Maker* maker : in) {
    if (maker->breaks) maker->breaks(builder);
  }
  Bytes file = builder.glb();
  for (const Maker* maker : in) {
    if (maker->breaks_file) file = maker->breaks_file(std::move(file));
  }
  return file;
}

std::set<std::string> codes_of(const Diagnostics& diagnostics, Severity severity) {
  std::set<std::string> codes;
  for (const Diagnostic& d : diagnostics.all()) {
    if (d.severity == severity) codes.insert(d.code);
  }
  return codes;
}

void expect_same_triangles(const Scene& a, const Scene& b) {
  const Level& from = a.draws[0].levels[0];
  const Level& to = b.draws[0].levels[0];
  EXPECT_TRUE(std::ranges::equal(from.orders[0].indices.view(), to.orders[0].indices.view()));
  EXPECT_TRUE(
      std::ranges::equal(from.vertices->find("POSITION")->bytes.view(), to.vertices->find("POSITION")->bytes.view()));
}

/// Read with a warning for each; refused where strict; written without those that are mended, and read again.
void expect_mended(const std::vector<const Maker*>& in) {
  std::set<std::string> wanted, kept;
  std::string name;
  for (const Maker* maker : in) {
    wanted.insert(maker->code);
    if (maker->is_kept) kept.insert(maker->code);
    name += std::string(" ") + maker->code;
  }
  SCOPED_TRACE(name);
  const Bytes file = broken(in);
  Diagnostics reading, strict, writing, again;
  const auto scene = read_gltf(file, "broken.glb", {}, reading);
  ASSERT_TRUE(scene) << to_text(reading);
  EXPECT_EQ(codes_of(reading, Severity::warning), wanted) << to_text(reading);
  EXPECT_FALSE(read_gltf(file, "broken.glb", {}, strict, {.strict = true}));
  EXPECT_EQ(codes_of(strict, Severity::error), wanted) << to_text(strict);

  const auto files = encode_gltf(*scene, "out.glb", writing);
  ASSERT_TRUE(files) << to_text(writing);
  if (kept == wanted) {
    EXPECT_EQ(files->front().bytes, file);
  }
  const auto other = read_gltf(files->front().bytes, "again.glb", {}, again);
  ASSERT_TRUE(other) << to_text(again);
  EXPECT_EQ(codes_of(again, Severity::warning), kept) << to_text(again);
  expect_same_triangles(*scene, *other);
  Diagnostics sound;
  expect_same_triangles(*scene, *read_gltf(testing::puppet().glb(), "sound.glb", {}, sound));
}

TEST(GltfFaults, every_kind_of_the_table_is_made_here) {
  std::set<std::string_view> made, listed;
  for (const Maker& maker : makers()) made.insert(maker.code);
  for (const FaultKind& kind : fault_kinds()) {
    if (kind.files == "glTF") listed.insert(kind.code);
  }
  EXPECT_EQ(made, listed);
}

TEST(GltfFaults, each_is_told_refused_where_strict_and_mended_or_kept) {
  for (const Maker& maker : makers()) expect_mended({&maker});
}

TEST(GltfFaults, any_two_go_together) {
  for (std::size_t a = 0; a < makers().size(); ++a) {
    for (std::size_t b = a + 1; b < makers().size(); ++b) expect_mended({&makers()[a], &makers()[b]});
  }
}

TEST(GltfFaults, all_together) {
  std::vector<const Maker*> all;
  for (const Maker& maker : makers()) all.push_back(&maker);
  expect_mended(all);
}

TEST(GltfFaults, seventy_of_a_kind_are_told_once) {
  GltfBuilder builder = testing::puppet();
  for (int i = 0; i < 70; ++i) builder.add("nodes", {{"camera", 5}});
  Diagnostics diagnostics;
  ASSERT_TRUE(read_gltf(builder.glb(), "many.glb", {}, diagnostics)) << to_text(diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1u) << to_text(diagnostics);
  EXPECT_EQ(diagnostics.all()[0].places, 70u);
  EXPECT_NE(to_text(diagnostics).find("nodes[3].camera: is 5, but the file has 0 cameras (and 69 more like it)"),
            std::string::npos)
      << to_text(diagnostics);
}

TEST(GltfFaults, what_somebody_refers_to_is_refused) {
  GltfBuilder builder = testing::puppet();
  const std::size_t wrong =
      builder.add("accessors", {{"bufferView", 0}, {"componentType", 5126}, {"count", 1 << 30}, {"type", "VEC3"}});
  builder.json["extensions"]["ACME_teapots"] = {{"handle", wrong}};  // perhaps this one
  Diagnostics diagnostics;
  EXPECT_FALSE(read_gltf(builder.glb(), "named.glb", {}, diagnostics));
  EXPECT_EQ(codes_of(diagnostics, Severity::error), std::set<std::string>{"accessor-range"});
}

TEST(GltfFaults, a_view_that_nobody_uses_goes) {
  GltfBuilder builder = testing::puppet();
  builder.add("bufferViews", {{"buffer", 0}, {"byteOffset", 1 << 20}, {"byteLength", 1 << 20}});
  Diagnostics diagnostics;
  const auto scene = read_gltf(builder.glb(), "view.glb", {}, diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  EXPECT_EQ(codes_of(diagnostics, Severity::warning), std::set<std::string>{"unused-data"});
  const auto files = encode_gltf(*scene, "out.glb", diagnostics);
  ASSERT_TRUE(files);
  Diagnostics again;
  EXPECT_TRUE(read_gltf(files->front().bytes, "again.glb", {}, again)) << to_text(again);
  EXPECT_TRUE(again.empty()) << to_text(again);
}

TEST(GltfFaults, a_view_goes_with_what_says_how_it_is_compressed) {
  GltfBuilder builder = testing::puppet();
  builder.add("bufferViews",
              {{"buffer", 0},
               {"byteOffset", 1 << 20},
               {"byteLength", 64},
               {"extensions",
                {{"EXT_meshopt_compression",
                  {{"buffer", 0}, {"byteLength", 8}, {"byteStride", 4}, {"count", 16}, {"mode", "ATTRIBUTES"}}}}}});
  Diagnostics diagnostics;
  const auto scene = read_gltf(builder.glb(), "view.glb", {}, diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  const auto files = encode_gltf(*scene, "out.glb", diagnostics);
  ASSERT_TRUE(files) << to_text(diagnostics);
  Diagnostics again;
  EXPECT_TRUE(read_gltf(files->front().bytes, "again.glb", {}, again)) << to_text(again);
}

TEST(GltfFaults, without_bytes_nothing_stands_for_a_view) {
  GltfBuilder builder;
  builder.json["buffers"] = {{{"byteLength", 64}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
  builder.json["bufferViews"] = {{{"buffer", 0}, {"byteOffset", 60}, {"byteLength", 64}}};
  Diagnostics diagnostics;
  EXPECT_FALSE(read_gltf(testing::bytes_of(builder.json.dump()), "fallback.gltf", {}, diagnostics));
  EXPECT_EQ(codes_of(diagnostics, Severity::error), std::set<std::string>{"view-range"});
}

TEST(GltfFaults, a_time_that_falls_is_that_of_the_key_before) {
  GltfBuilder builder = testing::puppet();
  poke<float>(builder, 7, 2, 0.25f);  // 0, 0.5, 0.25
  Diagnostics diagnostics;
  const auto scene = read_gltf(builder.glb(), "times.glb", {}, diagnostics);
  ASSERT_TRUE(scene);
  const auto times = scene->animations[0].channels[0].times.view();
  EXPECT_EQ(std::vector<float>(times.begin(), times.end()), (std::vector<float>{0, 0.5f, 0.5f}));
}

TEST(GltfFaults, a_joint_with_a_weight_must_be_there) {
  GltfBuilder builder = testing::puppet();
  poke<std::uint8_t>(builder, 3, 7, 9);  // weighs a quarter
  Diagnostics diagnostics;
  EXPECT_FALSE(read_gltf(builder.glb(), "joint.glb", {}, diagnostics));
  EXPECT_EQ(codes_of(diagnostics, Severity::error), std::set<std::string>{"joint-range"});
}

TEST(GltfFaults, an_unknown_extension_of_points_may_be_required) {
  GltfBuilder builder = testing::puppet();
  GltfJson splats{{"mode", 0}, {"extensions", {{"KHR_gaussian_splatting", {{"kernel", "ellipse"}}}}}};
  splats["attributes"]["POSITION"] = builder.add_values(std::vector<float>(6, 1), "VEC3");
  splats["attributes"]["KHR_gaussian_splatting:ROTATION"] = builder.add_values(std::vector<float>(8, 0.5f), "VEC4");
  builder.add_mesh(splats);
  builder.json["extensionsRequired"] = {"KHR_gaussian_splatting"};
  Diagnostics diagnostics;
  const auto scene = read_gltf(builder.glb(), "splats.glb", {}, diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  EXPECT_EQ(codes_of(diagnostics, Severity::warning), std::set<std::string>{"required-extension"});
  const auto files = encode_gltf(*scene, "out.glb", diagnostics);
  ASSERT_TRUE(files) << to_text(diagnostics);
  EXPECT_EQ(files->front().bytes, builder.glb());
}

TEST(GltfFaults, an_unknown_extension_of_a_mesh_may_not_be_required) {
  GltfBuilder builder = testing::puppet();
  builder.json["extensionsRequired"] = {"ACME_teapots"};
  primitive(builder)["extensions"]["ACME_teapots"] = {{"lid", true}};
  Diagnostics diagnostics;
  EXPECT_FALSE(read_gltf(builder.glb(), "teapot.glb", {}, diagnostics));
  EXPECT_EQ(codes_of(diagnostics, Severity::error), std::set<std::string>{"unsupported-extension"});
}

}  // namespace
}  // namespace foredraw::faults_test
