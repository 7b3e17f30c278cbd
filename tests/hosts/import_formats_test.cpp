// Scenes of other formats than FBX; what no glTF may hold, in any of them; and what is refused.

#include "support/image_builder.h"
#include "support/importing.h"

#include <gmock/gmock.h>

namespace foredraw::import_formats_test {
namespace {

using ::testing::HasSubstr;
class ImportedFormats : public testing::Imported {};

std::vector<float> floats_of(const Scene& scene, const char* semantic, std::size_t components) {
  const VertexStreams& vertices = *scene.draws.at(0).full().vertices;
  const VertexStream* stream = vertices.find(semantic);
  std::vector<float> values;
  for (std::size_t i = 0; stream != nullptr && i < vertices.count * components; ++i) {
    values.push_back(decode_component(*stream, i / components, i % components));
  }
  return values;
}

/// Three elements of a list of COLLADA, a number for each letter.
std::string source(const std::string& id, const std::vector<double>& values, const std::string& letters) {
  std::string text, parameters;
  for (const double value : values) text += std::to_string(value) + ' ';
  for (const char letter : letters) parameters += std::string("<param type=\"float\" name=\"") + letter + "\"/>";
  return "<source id=\"" + id + "\"><float_array id=\"" + id + "a\" count=\"" + std::to_string(values.size()) + "\">" +
         text + "</float_array><technique_common><accessor source=\"#" + id + "a\" count=\"3\" stride=\"" +
         std::to_string(letters.size()) + "\">" + parameters + "</accessor></technique_common></source>";
}

/// A triangle of COLLADA with Z up, in centimetres. `sources` and `inputs`: what its corners have beside a place;
/// `asks`: libraries of materials.
std::string collada(const std::string& sources = {}, const std::string& inputs = {}, const std::string& asks = {}) {
  return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="0.01" name="centimeter"/><up_axis>Z_UP</up_axis></asset>)" +
         asks + R"(<library_geometries><geometry id="g" name="leaf"><mesh>)" +
         source("p", {0, 0, 0, 100, 0, 0, 0, 0, 200}, "XYZ") + sources +
         R"(<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1" material="m"><input semantic="VERTEX" source="#v" offset="0"/>)" +
         inputs + R"(<p>0 1 2</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="m" target="#green"><bind_vertex_input semantic="UV" input_semantic="TEXCOORD" input_set="0"/>
</instance_material></technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

std::string input(const std::string& semantic, const std::string& id) {
  return "<input semantic=\"" + semantic + "\" source=\"#" + id + "\" offset=\"0\" set=\"0\"/>";
}

TEST_F(ImportedFormats, Collada) {
  const Scene scene = read("leaf.dae", collada());
  EXPECT_LT(distance(shown(scene), {1, 0, 0}), 1e-5f);
  EXPECT_LT(distance(shown(scene), {0, 2, 0}), 1e-5f);
}

/// glTF has no others.
TEST_F(ImportedFormats, NormalsHaveTheLengthOneAndColoursLieWithinOne) {
  const Scene scene = read("leaf.dae", collada(source("n", {0, 0, 0, 0, 3, 4, 0, 0, 1}, "XYZ") +
                                                   source("c", {2, 0, 0, 1, 0, -1, 0, 1, 0, 0, 0.5, 1}, "RGBA"),
                                               input("NORMAL", "n") + input("COLOR", "c")));
  ASSERT_EQ(scene.draws.size(), 1u);
  const std::vector<float> normals = floats_of(scene, "NORMAL", 3);
  ASSERT_EQ(normals.size(), 9u);
  const std::vector<float> expected{0, -1, 0, 0, 0.6f, 0.8f, 0, 0, 1};  // the first is the triangle's
  for (std::size_t i = 0; i < normals.size(); ++i) EXPECT_NEAR(normals[i], expected[i], 1e-6) << i;
  EXPECT_EQ(floats_of(scene, "COLOR_0", 4), (std::vector<float>{1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0.5f, 1}));
  EXPECT_THAT(told_, HasSubstr("below 0 or above 1"));
}

/// Maya's repeats are put into the texture coordinates, for glTF's core has no others.
TEST_F(ImportedFormats, WhatTilesATextureIsInTheTextureCoordinates) {
  const auto png = testing::png_of({.width = 1, .height = 1, .channels = 3, .bits = 8}, {9, 9, 9});
  testing::put(folder_ / "leaf.png", {reinterpret_cast<const char*>(png.data()), png.size()});
  const std::string asks = R"(<library_images><image id="i"><init_from>leaf.png</init_from></image></library_images>
<library_materials><material id="green" name="green"><instance_effect url="#e"/></material></library_materials>
<library_effects><effect id="e"><profile_COMMON><newparam sid="f"><surface type="2D"><init_from>i</init_from></surface>
</newparam><newparam sid="t"><sampler2D><source>f</source></sampler2D></newparam><technique sid="x"><lambert><diffuse>
<texture texture="t" texcoord="UV"><extra><technique profile="MAYA"><repeatU>3</repeatU><repeatV>1</repeatV></technique>
</extra></texture></diffuse></lambert></technique></profile_COMMON></effect></library_effects>)";
  const Scene scene = read("leaf.dae", collada(source("t", {0, 0, 1, 0, 0, 1}, "ST"), input("TEXCOORD", "t"), asks));
  EXPECT_EQ(told_, "");
  ASSERT_EQ(scene.draws.size(), 1u);
  ASSERT_TRUE(scene.material_of(scene.draws[0])->base_colour);
  const std::vector<float> coordinates = floats_of(scene, "TEXCOORD_0", 2);
  ASSERT_EQ(coordinates.size(), 6u);
  EXPECT_EQ(coordinates[2] - coordinates[0], 3);
  EXPECT_EQ(coordinates[3], coordinates[1]);
}

/// A chunk of a 3DS file: a number, its length, and what it holds.
std::string chunk(unsigned number, const std::string& holds) {
  std::string bytes{static_cast<char>(number), static_cast<char>(number >> 8)};
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((holds.size() + 6) >> shift);
  return bytes + holds;
}

TEST_F(ImportedFormats, ThreeDs) {
  const auto bytes_of = [](const auto& values) {
    return std::string(reinterpret_cast<const char*>(values.data()), sizeof(values[0]) * values.size());
  };
  const std::string points = std::string("\3\0", 2) + bytes_of(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 0, 2});
  const std::string faces = std::string("\1\0", 2) + bytes_of(std::vector<std::uint16_t>{0, 1, 2, 0});
  const std::string mesh = chunk(0x4100, chunk(0x4110, points) + chunk(0x4120, faces));
  const Scene scene = read("leaf.3ds", chunk(0x4d4d, chunk(0x3d3d, chunk(0x4000, std::string("leaf\0", 5) + mesh))));
  ASSERT_EQ(scene.draws.size(), 1u);
  EXPECT_EQ(scene.draws[0].full().stream().triangle_count(), 1u);
}

TEST_F(ImportedFormats, ARefusalSaysWhatTheFileIs) {
  const auto told_of = [&](const std::string& name, const std::string& text) {
    testing::put(folder_ / name, text);
    const auto ended = run("optimize '" + name + "' -o out.glb" + std::string(testing::quick));
    EXPECT_EQ(ended.code, 2) << ended.err;
    EXPECT_TRUE(ended.err.starts_with(name + ": error: ")) << ended.err;
    return ended.err;
  };
  EXPECT_THAT(told_of("old.fbx", "; FBX 6.1.0 project file\nFBXHeaderExtension: {\nFBXVersion: 6100\n}\n"),
              HasSubstr("it is FBX 6.1, and FBX is read from 7.1 (2011) on"));
  EXPECT_THAT(told_of("old binary.fbx", std::string("Kaydara FBX Binary  \0\x1a\0\xd4\x17\0\0", 27)),
              HasSubstr("it is FBX 6.1, and FBX is read from 7.1 (2011) on"));
  EXPECT_THAT(told_of("no.fbx", "a letter"), HasSubstr("it does not begin as FBX files do"));
  EXPECT_THAT(told_of("empty.dae", ""), HasSubstr("it is empty"));
  EXPECT_THAT(told_of("new.blend", "BLENDER-v293 and more"), HasSubstr("Blender 2.93 saved it"));
  EXPECT_THAT(told_of("newer.blend", "\x28\xb5\x2f\xfd packed"), HasSubstr("Blender 3.0 or newer saved it"));
  const std::string whole = collada(), shows = "<instance_geometry url";
  const std::size_t from = whole.find("<library_geometries>"), to = whole.find("<library_visual_scenes>");
  std::string bare = whole.substr(0, from) + whole.substr(to);
  bare.erase(bare.find(shows), bare.find("</node>") - bare.find(shows));
  EXPECT_THAT(told_of("bare.dae", bare), HasSubstr("it holds no meshes"));
}

}  // namespace
}  // namespace foredraw::import_formats_test
