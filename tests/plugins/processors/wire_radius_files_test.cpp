// Wires through stages and files: what is written, what comes back, what is refused, and what stays as it was.
#include "plugins/processors/wire_radius/wires_product.h"

#include "benchmarks/wire_radius/wire_sets.h"
#include "support/edit_product.h"
#include "support/gltf_builder.h"
#include "support/staged.h"

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/side_files.h>
#include <foredraw/scene/second_depth.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <cstring>
#include <functional>

namespace foredraw {
namespace {

using testing::GltfJson;
using ::testing::HasSubstr;

bench::KnownMesh made(const std::string& name) {
  for (bench::KnownMesh& mesh : bench::made_meshes(201)) {
    if (mesh.name == name) return std::move(mesh);
  }
  throw std::invalid_argument(name);
}

std::vector<float> floats_of(const bench::KnownMesh& mesh) {
  std::vector<float> values;
  for (const glm::vec3& at : mesh.positions) values.insert(values.end(), {at.x, at.y, at.z});
  return values;
}

/// With a floor below the body.
bench::KnownMesh closed_antenna() {
  bench::KnownMesh mesh = made("antenna on a body");
  const auto n = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.indices.insert(mesh.indices.end(), {n - 4, n - 2, n - 3, n - 4, n - 1, n - 2});
  return mesh;
}

/// The meshes in one draw, its triangles in this sequence: first a triangle of each, then the next of each.
testing::GltfBuilder mixed(const std::vector<std::string>& names) {
  std::vector<float> positions;
  std::vector<std::vector<std::uint32_t>> parts;
  for (const std::string& name : names) {
    const bench::KnownMesh mesh = name == "closed antenna" ? closed_antenna() : made(name);
    parts.push_back(mesh.indices);
    for (std::uint32_t& index : parts.back()) index += static_cast<std::uint32_t>(positions.size() / 3);
    const std::vector<float> values = floats_of(mesh);
    positions.insert(positions.end(), values.begin(), values.end());
  }
  std::vector<std::uint32_t> indices;
  for (std::size_t t = 0; indices.size() < 3'000'000; t += 3) {
    const std::size_t before = indices.size();
    for (const auto& part : parts) {
      if (t < part.size())
        indices.insert(indices.end(), part.begin() + static_cast<std::ptrdiff_t>(t),
                       part.begin() + static_cast<std::ptrdiff_t>(t) + 3);
    }
    if (indices.size() == before) break;
  }
  testing::GltfBuilder builder;
  const std::size_t at = builder.add_values(positions, "VEC3");
  builder.json["accessors"][at]["min"] = {-100, -100, -100};
  builder.json["accessors"][at]["max"] = {100, 100, 100};
  builder.add_mesh({{"attributes", {{"POSITION", at}}}, {"indices", builder.add_values(indices, "SCALAR")}});
  return builder;
}

std::optional<Scene> read(const std::vector<std::byte>& file, Diagnostics& diagnostics) {
  return read_gltf(file, "scene.glb", {}, diagnostics, {.products = {wires_product()}});
}

Scene scene_of(const testing::GltfBuilder& builder) {
  Diagnostics diagnostics;
  auto scene = read(builder.glb(), diagnostics);
  if (!scene) throw std::runtime_error(to_text(diagnostics));
  return std::move(*scene);
}

std::vector<std::byte> written(const Scene& scene) {
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, "out.glb", diagnostics, {.products = {wires_product()}});
  if (!files || diagnostics.has_errors()) throw std::runtime_error(to_text(diagnostics));
  return files->front().bytes;
}

/// A rope, a lamp post and a body, triangle by triangle in turn.
const Scene& plain() {
  static const Scene scene = scene_of(mixed({"flat rope", "lamp post", "egg"}));
  return scene;
}

const Scene& with_wires() {
  static const Scene scene = testing::run("wire-radius", plain()).scene;
  return scene;
}

/// All triangles by their corners' positions, begun at the smallest corner, in order.
std::vector<std::array<float, 9>> triangles_of(const Scene& scene, std::size_t first = 0) {
  const Level& level = scene.draws[0].full();
  const std::vector<glm::vec3> positions = decode_vec3(*level.vertices->find("POSITION"));
  std::vector<std::array<float, 9>> all;
  const auto indices = level.stream().indices.view();
  for (std::size_t t = 3 * first; t < indices.size(); t += 3) {
    std::array<float, 9> triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      for (int axis = 0; axis < 3; ++axis)
        triangle[3 * i + static_cast<std::size_t>(axis)] = positions[indices[t + i]][axis];
    }
    all.push_back(triangle);
  }
  std::ranges::sort(all);
  return all;
}

TEST(WireRadiusFiles, AReportTellsOnceWhatWasFoundInTheWordsOfTheProduct) {
  const Result result = testing::run("wire-radius", plain());
  std::vector<std::string> found;
  for (const NoteRecord& note : result.report.stages[0].notes) {
    if (note.message.find("1 ribbon") != std::string::npos) found.push_back(note.message);
  }
  EXPECT_EQ(found, wires_product()->told(result.scene).lines);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0], HasSubstr("1 tube, 1 ribbon and 0 nets, together "));
}

TEST(WireRadiusFiles, WiresAreTheLastTriangles) {
  const Wires* wires = with_wires().products.find<Wires>();
  ASSERT_NE(wires, nullptr);
  ASSERT_EQ(wires->draws.size(), 1u);
  EXPECT_EQ(wires->draws[0].wires.size(), 2u);
  EXPECT_GT(wires->draws[0].first_triangle, 0u);
  EXPECT_EQ(wires_product()->difference(with_wires()), "");
}

/// A ribbon is marked, and says in which direction it is broad; a tube is round.
TEST(WireRadiusFiles, FlatOnesAreMarked) {
  for (const auto& [name, mark] : {std::pair{"flat rope", 1.0f}, {"net", 1.0f}, {"lamp post", 0.0f}}) {
    const Scene scene = testing::run("wire-radius", scene_of(mixed({name}))).scene;
    const VertexStreams& vertices = *scene.draws[0].full().vertices;
    const VertexStream *wires = vertices.find(wire_semantic), *axes = vertices.find(wire_axis_semantic);
    ASSERT_TRUE(wires != nullptr && axes != nullptr) << name;
    std::size_t marked = 0;
    for (std::size_t v = 0; v < vertices.count; ++v) {
      if (decode_component(*wires, v, 3) == 0) continue;
      ++marked;
      EXPECT_EQ(decode_component(*axes, v, 3), mark) << name;
      glm::dvec3 to_centre, axis;
      for (int c = 0; c < 3; ++c) {
        to_centre[c] = decode_component(*wires, v, static_cast<std::size_t>(c));
        axis[c] = decode_component(*axes, v, static_cast<std::size_t>(c));
      }
      EXPECT_NEAR(glm::length(axis), 1, 1e-5);
      EXPECT_GT(glm::length(to_centre), 0) << name;
      if (mark == 1) {
        EXPECT_NEAR(glm::dot(to_centre, axis), 0, 0.2 * glm::length(to_centre)) << name;
      }
    }
    EXPECT_GT(marked, 0u);
  }
}

/// What does not know wires draws the same triangles of the same vertices with the same material.
TEST(WireRadiusFiles, NothingElseChanges) {
  EXPECT_EQ(triangles_of(with_wires()), triangles_of(plain()));
  const VertexStreams &before = *plain().draws[0].full().vertices, &after = *with_wires().draws[0].full().vertices;
  ASSERT_EQ(after.base.size(), before.base.size() + 2);
  EXPECT_TRUE(after.find("POSITION")->bytes == before.find("POSITION")->bytes);
  EXPECT_EQ(with_wires().draws[0].material, plain().draws[0].material);
}

/// Without its extension, and then without its attributes: the same picture, for the rest of the file is as it was.
TEST(WireRadiusFiles, StrippedItIsTheSameScene) {
  Scene scene = with_wires();
  wires_product()->leave_out(scene);
  EXPECT_FALSE(scene.products.has(Wires::product));
  EXPECT_EQ(scene.draws[0].full().vertices->base.size(), plain().draws[0].full().vertices->base.size());
  EXPECT_EQ(triangles_of(scene), triangles_of(plain()));
  const std::string json = testing::json_of(written(scene)).dump();
  EXPECT_EQ(json.find("FOREDRAW"), std::string::npos);
}

TEST(WireRadiusFiles, ComeBack) {
  Diagnostics diagnostics;
  const auto again = read(written(with_wires()), diagnostics);
  ASSERT_TRUE(again);
  EXPECT_TRUE(diagnostics.empty()) << to_text(diagnostics);
  EXPECT_EQ(*again->products.find<Wires>(), *with_wires().products.find<Wires>());
  EXPECT_EQ(written(*again), written(with_wires()));
}

TEST(WireRadiusFiles, TheSameBytesAtAnyThreadCount) {
  const auto bytes = [](int threads) {
    Registry registry;
    add_built_in_plugins(registry);
    Diagnostics diagnostics;
    const auto plan = foredraw::plan(*parse_line("wire-radius", diagnostics), registry, plain(), diagnostics);
    const Executor executor(threads);
    Analyses analyses;
    return written(optimize(*plan, plain(), {executor, analyses}).scene);
  };
  EXPECT_EQ(bytes(1), bytes(4));
}

/// Ranges keep their triangles; wires are the same after weld, orders, and reading again.
TEST(WireRadiusFiles, LaterStagesKeepThem) {
  Diagnostics diagnostics;
  const Scene moved = testing::run("weld, tipsify, vertex-fetch", with_wires()).scene;
  const auto again = read(written(moved), diagnostics);
  ASSERT_TRUE(again);
  const Wires* wires = again->products.find<Wires>();
  ASSERT_NE(wires, nullptr);
  EXPECT_EQ(*wires, *with_wires().products.find<Wires>());
  const std::uint32_t first = wires->draws[0].first_triangle;
  EXPECT_EQ(triangles_of(*again, first), triangles_of(with_wires(), first));
  const Scene found_again = testing::run("wire-radius", *again).scene;
  ASSERT_NE(found_again.products.find<Wires>(), nullptr);
  EXPECT_EQ(triangles_of(found_again, first), triangles_of(with_wires(), first));
}

TEST(WireRadiusFiles, AreLeftOutWhereTrianglesGo) {
  const Result result = testing::run("wire-radius, quadric-collapse, simplify(ratio=0.5)", plain());
  EXPECT_FALSE(result.scene.products.has(Wires::product));
  EXPECT_EQ(result.scene.draws[0].full().vertices->find(wire_semantic), nullptr);
}

TEST(WireRadiusFiles, SomethingShorterStaysAndSaysSo) {
  const Result result = testing::run("wire-radius(slender=500)", plain());
  EXPECT_FALSE(result.scene.products.has(Wires::product));
}

struct Wrong {
  const char* name;
  std::function<void(GltfJson& json, GltfJson& primitive)> make;
  const char* why;
};
void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }

class WrongWires : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongWires, AreLeftOutWithAWarning) {
  const std::vector<std::byte> glb = written(with_wires());
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, 4);
  GltfJson json = testing::json_of(glb);
  GetParam().make(json, json["meshes"][0]["primitives"][0]);
  const std::vector<std::byte> bin(glb.begin() + 20 + length + 8, glb.end());
  Diagnostics diagnostics;
  const auto scene = read(testing::glb_of(json.dump(), bin), diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1u) << to_text(diagnostics);
  EXPECT_EQ(diagnostics.all()[0].code, "wires-left-out");
  EXPECT_THAT(diagnostics.all()[0].message, HasSubstr(GetParam().why));
  EXPECT_FALSE(scene->products.has(Wires::product));
}

GltfJson& extension(GltfJson& primitive) { return primitive["extensions"]["FOREDRAW_wires"]; }

INSTANTIATE_TEST_SUITE_P(
    Files, WrongWires,
    ::testing::Values(
        Wrong{"NoFirst", [](GltfJson&, GltfJson& p) { extension(p).erase("firstTriangle"); }, "has no 'firstTriangle'"},
        Wrong{"FirstBeyond", [](GltfJson&, GltfJson& p) { extension(p)["firstTriangle"] = 4000000000u; },
              "number of triangles"},
        Wrong{"FirstTooEarly",
              [](GltfJson&, GltfJson& p) {
                extension(p)["firstTriangle"] = extension(p)["firstTriangle"].get<int>() - 1;
                extension(p)["wires"][0]["triangles"] = extension(p)["wires"][0]["triangles"].get<int>() + 1;
              },
              "its vertices are not"},
        Wrong{"NoWires", [](GltfJson&, GltfJson& p) { extension(p)["wires"] = GltfJson::array(); },
              "number of triangles"},
        Wrong{"NoKind", [](GltfJson&, GltfJson& p) { extension(p)["wires"][0]["kind"] = "rod"; }, "wire 0"},
        Wrong{"NoRadius", [](GltfJson&, GltfJson& p) { extension(p)["wires"][1]["radius"] = 0; }, "wire 1"},
        Wrong{"NoStream", [](GltfJson&, GltfJson& p) { p["attributes"].erase("_FOREDRAW_WIRE"); },
              "lacks one of their streams"},
        Wrong{"OldAxis",
              [](GltfJson& json, GltfJson& p) {
                json["accessors"][p["attributes"]["_FOREDRAW_WIRE_AXIS"].get<std::size_t>()]["type"] = "VEC3";
              },
              "lacks one of their streams"},
        Wrong{"WrongStream",
              [](GltfJson&, GltfJson& p) { p["attributes"]["_FOREDRAW_WIRE"] = p["attributes"]["POSITION"]; },
              "lacks one of their streams"},
        Wrong{
            "OtherStream",
            [](GltfJson&, GltfJson& p) { p["attributes"]["_FOREDRAW_WIRE"] = p["attributes"]["_FOREDRAW_WIRE_AXIS"]; },
            "its vertices are not"}),
    [](const auto& test) { return std::string(test.param.name); });

/// Where ribbons of a net cross, vertices are there for each of them, alike in all but their wire; triangles stay.
TEST(WireRadiusFiles, CrossingsHaveVerticesForEachRibbon) {
  const Scene before = scene_of(mixed({"net"})), after = testing::run("wire-radius", before).scene;
  ASSERT_TRUE(after.products.has(Wires::product));
  EXPECT_GT(after.draws[0].full().vertices->count, before.draws[0].full().vertices->count);
  EXPECT_EQ(triangles_of(after), triangles_of(before));
  EXPECT_EQ(wires_product()->difference(after), "");
  Diagnostics diagnostics;
  const auto again = read(written(after), diagnostics);
  ASSERT_TRUE(again && diagnostics.empty()) << to_text(diagnostics);
  EXPECT_EQ(again->products.find<Wires>()->draws, after.products.find<Wires>()->draws);
}

/// An antenna is torn from its body, which leaves the closed ones with it: the rest of the second depth stays.
TEST(WireRadiusFiles, SecondDepthKeepsWholeShells) {
  const Scene both = scene_of(mixed({"closed antenna", "egg", "plank", "sail hem"}));
  const Result alone = testing::run("second-depth", both), result = testing::run("second-depth, wire-radius", both);
  ASSERT_TRUE(alone.scene.products.has(SecondDepth::product));
  const auto* closed = result.scene.products.find<SecondDepth>();
  ASSERT_NE(closed, nullptr);
  ASSERT_NE(result.scene.products.find<Wires>(), nullptr);
  const std::uint32_t plank = static_cast<std::uint32_t>(made("plank").indices.size() / 3);
  const std::uint32_t egg = static_cast<std::uint32_t>(made("egg").indices.size() / 3);
  EXPECT_GT(alone.scene.products.find<SecondDepth>()->triangles_of(0), plank + egg) << "the antenna's body was closed";
  EXPECT_EQ(closed->triangles_of(0), plank + egg);
  const Result other = testing::run("wire-radius, second-depth", both);
  ASSERT_NE(other.scene.products.find<SecondDepth>(), nullptr);
  EXPECT_EQ(other.scene.products.find<SecondDepth>()->triangles_of(0), closed->triangles_of(0));
}

/// Of a draw with both, shells come first and wires last, whichever stage ran first, and later orders keep it so.
TEST(WireRadiusFiles, ShellsComeFirstAndWiresLastInEitherSequence) {
  const Scene both = scene_of(mixed({"closed antenna", "egg", "flat rope", "plank", "sail hem"}));
  for (const char* stages : {"second-depth, wire-radius", "wire-radius, second-depth"}) {
    const Scene made = testing::run(stages, both).scene;
    for (const char* later : {"tipsify, vertex-fetch", "lookahead(quality=fast)", "weld, forsyth, vertex-fetch"}) {
      SCOPED_TRACE(std::string(stages) + ", " + later);
      const Scene ordered = testing::run(later, made).scene;
      const auto *closed = ordered.products.find<SecondDepth>(), *was = made.products.find<SecondDepth>();
      const auto *wires = ordered.products.find<Wires>(), *wires_before = made.products.find<Wires>();
      ASSERT_TRUE(closed != nullptr && was != nullptr && wires != nullptr && wires_before != nullptr);
      EXPECT_EQ(closed->triangles_of(0), was->triangles_of(0));
      EXPECT_EQ(wires->draws, wires_before->draws);
      const std::uint32_t first = wires->draws[0].first_triangle;
      EXPECT_LE(closed->triangles_of(0), first);
      EXPECT_EQ(triangles_of(ordered, first), triangles_of(made, first));
      EXPECT_EQ(wires_product()->difference(ordered), "");
    }
  }
}

/// A stream that another tool left, of any type, gives way to ours.
TEST(WireRadiusFiles, StaleStreamsGiveWay) {
  testing::GltfBuilder builder = mixed({"flat rope"});
  const bench::KnownMesh mesh = made("flat rope");
  const std::vector<float> stale(mesh.positions.size(), 7);
  builder.json["meshes"][0]["primitives"][0]["attributes"]["_FOREDRAW_WIRE"] = builder.add_values(stale, "SCALAR");
  const Scene scene = testing::run("wire-radius", scene_of(builder)).scene;
  EXPECT_EQ(wires_product()->difference(scene), "");
  const VertexStreams& vertices = *scene.draws[0].full().vertices;
  EXPECT_EQ(std::ranges::count(vertices.base, std::string(wire_semantic), &VertexStream::semantic), 1);
}

TEST(WireRadiusFiles, BlendedMaskedAndLinesAreLeftAlone) {
  for (const char* mode : {"BLEND", "MASK"}) {
    testing::GltfBuilder builder = mixed({"flat rope"});
    builder.json["meshes"][0]["primitives"][0]["material"] = builder.add("materials", {{"alphaMode", mode}});
    EXPECT_FALSE(testing::run("wire-radius", scene_of(builder)).scene.products.has(Wires::product)) << mode;
  }
  testing::GltfBuilder lines = mixed({"flat rope"});
  lines.json["meshes"][0]["primitives"][0]["mode"] = 1;
  EXPECT_FALSE(testing::run("wire-radius", scene_of(lines)).scene.products.has(Wires::product));
}

/// For importers that know no other attributes: the same numbers, in the next free sets of texture coordinates.
TEST(WireRadiusFiles, GoIntoTextureCoordinates) {
  testing::GltfBuilder builder = mixed({"flat rope", "lamp post", "egg"});
  const std::size_t count = scene_of(builder).draws[0].full().vertices->count;
  builder.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] =
      builder.add_values(std::vector<float>(2 * count, 0.5f), "VEC2");
  const Scene before = scene_of(builder);
  const Result result = testing::run("wire-radius(as=texcoords)", before);
  const Scene& found = result.scene;
  const Wires* wires = found.products.find<Wires>();
  ASSERT_NE(wires, nullptr);
  EXPECT_EQ(wires->draws[0].texcoords, 1u);
  const auto says = [](const NoteRecord& note) { return note.message == "its wires are in TEXCOORD_1 to TEXCOORD_4"; };
  EXPECT_TRUE(std::ranges::any_of(result.report.stages[0].notes, says));
  const Scene usual = testing::run("wire-radius", before).scene;
  const auto as_usual = decoded_wires(*usual.draws[0].full().vertices, std::nullopt);
  const auto is = decoded_wires(*found.draws[0].full().vertices, 1);
  ASSERT_TRUE(as_usual && is);
  EXPECT_EQ(is->wires, as_usual->wires);
  EXPECT_EQ(is->axes, as_usual->axes);

  const GltfJson json = testing::json_of(written(found));
  const GltfJson& primitive = json["meshes"][0]["primitives"][0];
  EXPECT_EQ(primitive["attributes"].size(), 6u);
  EXPECT_FALSE(primitive["attributes"].contains("_FOREDRAW_WIRE"));
  for (const char* set : {"TEXCOORD_1", "TEXCOORD_2", "TEXCOORD_3", "TEXCOORD_4"}) {
    const GltfJson& accessor = json["accessors"][primitive["attributes"][set].get<std::size_t>()];
    EXPECT_EQ(accessor["type"], "VEC2");
    EXPECT_EQ(accessor["componentType"], 5126);
  }
  EXPECT_EQ(primitive["extensions"]["FOREDRAW_wires"]["texcoords"], 1);

  // Later stages and files keep them; found again they are in the same sets, or back in attributes.
  Diagnostics diagnostics;
  const auto again = read(written(testing::run("weld, tipsify, vertex-fetch", found).scene), diagnostics);
  ASSERT_TRUE(again);
  EXPECT_TRUE(diagnostics.empty()) << to_text(diagnostics);
  EXPECT_EQ(*again->products.find<Wires>(), *wires);
  EXPECT_EQ(testing::run("wire-radius(as=texcoords)", *again).scene.products.find<Wires>()->draws[0].texcoords, 1u);
  const Scene back = testing::run("wire-radius", *again).scene;
  EXPECT_EQ(back.draws[0].full().vertices->find("TEXCOORD_1"), nullptr);
  EXPECT_NE(back.draws[0].full().vertices->find(wire_semantic), nullptr);

  // What leaves them out takes the sets away, and no other.
  const Scene out = testing::run("quadric-collapse, simplify(ratio=0.5)", found).scene;
  EXPECT_FALSE(out.products.has(Wires::product));
  EXPECT_EQ(out.draws[0].full().vertices->find("TEXCOORD_4"), nullptr);
  EXPECT_NE(out.draws[0].full().vertices->find("TEXCOORD_0"), nullptr);
}

TEST(WireRadiusFiles, WrongTextureCoordinatesAreLeftOut) {
  const std::vector<std::byte> glb = written(testing::run("wire-radius(as=texcoords)", plain()).scene);
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, 4);
  const std::vector<std::byte> bin(glb.begin() + 20 + length + 8, glb.end());
  for (const auto& [value, why] : {std::pair<GltfJson, const char*>{1, "lacks one of their streams"},
                                   {4000000000u, "no set's number"},
                                   {"x", "no set's number"},
                                   {-1, "no set's number"}}) {
    GltfJson json = testing::json_of(glb);
    json["meshes"][0]["primitives"][0]["extensions"]["FOREDRAW_wires"]["texcoords"] = value;
    Diagnostics diagnostics;
    const auto scene = read(testing::glb_of(json.dump(), bin), diagnostics);
    ASSERT_TRUE(scene) << to_text(diagnostics);
    EXPECT_THAT(to_text(diagnostics), HasSubstr(why)) << value;
    EXPECT_FALSE(scene->products.has(Wires::product));
  }
}

TEST(WireRadiusFiles, ShadersAreWritten) {
  for (const char* kind : {".glsl", ".hlsl"}) {
    const SideFile file = wires_product()->side_file(with_wires(), kind, "");
    EXPECT_THAT(std::get<std::string>(file.content), HasSubstr("WIRE_VERTEX"));
  }
}

}  // namespace
}  // namespace foredraw
