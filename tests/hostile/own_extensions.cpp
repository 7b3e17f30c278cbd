#include "own_extensions.h"

#include "whole_way.h"

#include "support/collapses.h"
#include "support/compressed_gltf.h"
#include "support/displaced.h"
#include "support/hostile_wires.h"
#include "support/products.h"
#include "support/staged.h"
#include "support/uv_charts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <stdexcept>

namespace foredraw::testing {

namespace {

Scene torus_scene() { return scene_of(closed_torus(16, 8)); }

Scene displaced() {
  return displaced_grid(
      4, 4, height_image(16, 16, [](auto x, auto y) { return static_cast<std::uint16_t>(4099 * (x * x + 3 * y)); }));
}

/// Cut into six.
Scene charts() {
  const Charts cut = cube_sphere(2, turned_places());
  const Map map = noise_map(64, 64, 3);
  return displaced_scene({cut.positions, cut.indices}, cut.uvs,
                         height_image(64, 64, [&](auto x, auto y) { return map.texels[64 * y + x]; }));
}

/// A rope of 32 rings, closed at both ends, beside a body.
Scene rope_and_body() {
  TestMesh mesh = closed_torus(16, 8);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  HostileWire rope;
  rope.tube(
      32, [](double t) { return glm::dvec3(20 * t, 5, 0); }, 0.1);
  mesh.positions.insert(mesh.positions.end(), rope.positions.begin(), rope.positions.end());
  for (const std::uint32_t index : rope.indices) mesh.indices.push_back(first + index);
  return scene_of(mesh);
}

/// So many triangles that heights pay.
Scene waves() {
  TestMesh mesh = sphere(64, 32);
  for (glm::vec3& p : mesh.positions) p *= 1 + 0.05f * p.x * p.y * (p.z + 0.5f);
  return scene_of(mesh);
}

}  // namespace

void PrintTo(const OwnExtension& extension, std::ostream* out) { *out << extension.name; }

std::vector<OwnExtension> own_extensions() {
  return {
      {"FOREDRAW_levels", "weld, quadric-collapse, levels",
       R"(primitive/levels/\d( is missing|/indices is (missing|a row short)|/error is (missing|4294967296)|)"
       R"(/attributes/POSITION (is (of another kind|noise)|has all bits set))|)"
       R"(primitive/levels/[01]/(indices|attributes/POSITION) is a row too long)",  // it ends in the next level's
       torus_scene},
      {"FOREDRAW_progressive_mesh", "weld, quadric-collapse",
       "file/meshes/0/(places is (missing|noise)|solved is missing)", torus_scene},
      {"FOREDRAW_geomorph", "weld, quadric-collapse, levels(keep-sequences=true), geomorphs", "", torus_scene},
      {"FOREDRAW_progressive_stream", "weld, quadric-collapse(placement=endpoint), progressive-stream", "",
       torus_scene},
      {"FOREDRAW_lod_table", "weld, quadric-collapse, levels, lod-table", "", torus_scene},
      {"FOREDRAW_crowd_levels", "weld, quadric-collapse, levels, crowd-levels",
       R"(primitive/(area|levels/\d/largest) is 4294967296)", torus_scene},
      {"FOREDRAW_tessellation_levels", "tessellation-levels", R"(primitive/scales/1/(rms|largest) is 4294967296)",
       displaced},
      {"FOREDRAW_baked_heights", "weld, quadric-collapse, displacement-bake(rms=0.0005)",
       R"(primitive/(factor|offset) is (-1|4294967296))", waves},
      {"FOREDRAW_packed_vertices", "vertex-pack", "", torus_scene},
      {"FOREDRAW_seam_heights", "displacement-seams(table=true)",
       "primitive/(heights (has all bits set|is noise)|sides is a row short)", charts},
      {"FOREDRAW_wires", "wire-radius", R"(primitive/wires/\d/((length|radius) is 4294967296|closed is missing))",
       rope_and_body},
      {"FOREDRAW_second_depth", "second-depth", "", torus_scene},
  };
}

std::vector<OwnExtension> own_extensions_with_streams() {
  std::vector<OwnExtension> own;
  for (const OwnExtension& extension : own_extensions()) {
    for (const char* name : {"FOREDRAW_levels", "FOREDRAW_progressive_mesh", "FOREDRAW_geomorph",
                             "FOREDRAW_progressive_stream", "FOREDRAW_tessellation_levels", "FOREDRAW_baked_heights",
                             "FOREDRAW_packed_vertices", "FOREDRAW_seam_heights"}) {
      if (extension.name == std::string_view(name)) own.push_back(extension);
    }
  }
  return own;
}

GltfBuilder file_with(const OwnExtension& extension, Compression compression) {
  Diagnostics diagnostics;
  Scene scene = extension.scene();
  if (compression != Compression::none) {  // of a file that is read, so that what is made lies in views of its own
    scene =
        read_gltf(encode_gltf(scene, "in.glb", diagnostics).value().front().bytes, "in.glb", {}, diagnostics).value();
  }
  const Result result = run(extension.stages, scene);
  if (result.failed) throw std::runtime_error(to_text(result.report));
  const auto files =
      encode_gltf(result.scene, "out.glb", diagnostics, {.compression = compression, .products = built_in_products()});
  GltfBuilder builder = builder_of(files.value().front().bytes);
  if (compression == Compression::none) builder.json.erase("buffers");
  return builder;
}

bool is_harmless(const OwnExtension& extension, const Damaged& damaged) {
  return std::regex_match(damaged.what, std::regex(extension.harmless));
}

void expect_to_cost_itself_alone(const OwnExtension& extension, const Damaged& one) {
  SCOPED_TRACE(one.what);
  EXPECT_TRUE(go_the_whole_way(one.glb).empty());
  SceneInput how{.products = built_in_products()};
  Diagnostics diagnostics, strict;
  const auto scene = read_gltf(one.glb, "file", {}, diagnostics, how);
  ASSERT_TRUE(scene);
  const auto tells_of_it = [&](const Diagnostic& d) {
    return d.where.inside == extension.name && d.code.ends_with("-left-out") && !d.hint.empty();
  };
  const auto is_no_left_out = [](const Diagnostic& d) { return !d.code.ends_with("-left-out"); };
  const bool is_harmful = !is_harmless(extension, one);
  EXPECT_EQ(std::ranges::count_if(diagnostics.all(), tells_of_it), is_harmful) << to_text(diagnostics);
  if (is_harmful) {
    EXPECT_TRUE(std::ranges::none_of(diagnostics.all(), is_no_left_out)) << to_text(diagnostics);
  }
  how.strict = true;
  EXPECT_NE(read_gltf(one.glb, "file", {}, strict, how).has_value(), is_harmful) << to_text(strict);
  EXPECT_EQ(std::ranges::count_if(strict.all(), tells_of_it), is_harmful) << to_text(strict);
}

}  // namespace foredraw::testing
