#include "odd_scenes.h"

#include "support/displaced.h"
#include "support/meshes.h"
#include "support/sprite_scenes.h"

#include <limits>

namespace foredraw::testing {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

TestMesh one_triangle() { return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}}; }

TestMesh degenerate() {
  TestMesh mesh = grid(3, 3);
  mesh.indices.insert(mesh.indices.end(), {0, 0, 0, 1, 1, 2, 0, 1, 2, 3, 2, 3});
  return mesh;
}

TestMesh fan_on_one_edge(std::uint32_t triangles) {
  TestMesh mesh{{{0, 0, 0}, {0, 1, 0}}, {}};
  for (std::uint32_t i = 0; i < triangles; ++i) {
    mesh.positions.emplace_back(1, 0, static_cast<float>(i));
    mesh.indices.insert(mesh.indices.end(), {0, 1, i + 2});
  }
  return mesh;
}

TestMesh not_finite() {
  TestMesh mesh = sphere(8, 6);
  mesh.positions[5].x = nan;
  mesh.positions[20].y = infinity;
  mesh.positions[33] = {-infinity, nan, infinity};
  return mesh;
}

TestMesh nowhere_finite() { return {{{nan, nan, nan}, {infinity, 0, 0}, {nan, 0, 0}}, {0, 1, 2, 2, 1, 0}}; }

TestMesh all_in_one_point() { return {std::vector<glm::vec3>(9, glm::vec3(2, 3, 4)), {0, 1, 2, 3, 4, 5, 6, 7, 8}}; }

TestMesh huge_and_tiny() {
  return {{{3e38f, 3e38f, 3e38f}, {-3e38f, 0, 0}, {0, -3e38f, 0}, {1e-40f, 0, 0}, {0, 1e-40f, 0}},
          {0, 1, 2, 2, 3, 4, 0, 3, 4}};
}

TestMesh with_duplicates() {
  TestMesh mesh = torus(6, 5);
  const std::vector<std::uint32_t> again(mesh.indices.begin(), mesh.indices.begin() + 30);
  mesh.indices.insert(mesh.indices.end(), again.begin(), again.end());
  return mesh;
}

TestMesh with_unused_vertices() {
  TestMesh mesh = soup(20, 3);
  mesh.positions.resize(mesh.positions.size() + 50, glm::vec3(9));
  return mesh;
}

Draw quantized() {
  const std::int16_t values[] = {-32767, 0, 0, 0, 32767, 0, 0, 0, 0, 0, 32767, 0, 1, 2, 3, 0};
  const auto bytes = std::as_bytes(std::span(values));
  VertexStreams streams;
  streams.count = 4;
  streams.base.push_back(
      {"POSITION", Format{Component::int16, 4, true, 8}, Shared<std::byte>({bytes.begin(), bytes.end()})});
  Draw draw = draw_of({{}, {0, 1, 2, 1, 2, 3}}, "quantized");
  draw.levels[0].vertices = std::make_shared<const VertexStreams>(std::move(streams));
  draw.traits.add(traits::quantized);
  return draw;
}

Draw morphed() {
  const TestMesh mesh = grid(4, 4);
  Draw draw = draw_of(mesh, "morphed");
  VertexStreams streams = *draw.levels[0].vertices;
  streams.morph_targets.push_back({streams.base});
  draw.levels[0].vertices = std::make_shared<const VertexStreams>(std::move(streams));
  draw.traits.add(traits::morphed);
  return draw;
}

Draw points() {
  Draw draw = draw_of({{{0, 0, 0}, {1, 1, 1}}, {0, 1}}, "points");
  draw.topology = Topology::points;
  draw.traits = {};
  return draw;
}

Draw without_positions() {
  Draw draw = draw_of({{}, {}}, "without positions");
  draw.levels[0].vertices = std::make_shared<const VertexStreams>();
  return draw;
}

/// Two blots of unlike size, one of which reaches the edge.
void add_sprite(Scene& scene) {
  const ImageFacts facts{13, 6, 2, 16, false};
  std::vector<std::uint16_t> values;
  for (std::uint32_t y = 0; y < facts.height; ++y) {
    for (std::uint32_t x = 0; x < facts.width; ++x) {
      const bool shows = (x < 4 && y < 5 && x + y > 1) || (x > 6 && x < 12 && y == x / 3);
      values.insert(values.end(), {65535, static_cast<std::uint16_t>(shows ? 5000 * x + 1 : 0)});
    }
  }
  Scene sprite = sprite_scene(texel_image(facts, values));
  sprite.nodes[0].mesh = static_cast<MeshId>(scene.meshes.size());
  sprite.meshes[0].draws = {static_cast<DrawId>(scene.draws.size())};
  scene.nodes.push_back(std::move(sprite.nodes[0]));
  scene.meshes.push_back(std::move(sprite.meshes[0]));
  scene.draws.push_back(std::move(sprite.draws[0]));
  scene.materials = std::move(sprite.materials);
  scene.images = std::move(sprite.images);
}

/// A square on a map of heights, cut in the middle: the right half lies turned by a quarter. One vertex lies nowhere.
void add_displaced(Scene& scene) {
  TestMesh mesh = joined(grid(2, 4), grid(2, 4));
  std::vector<glm::vec2> uv;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    glm::vec3& at = mesh.positions[v];
    const glm::vec2 chart(0.05f + 0.2f * at.x, 0.1f + 0.2f * at.y);
    if (v < 15) {
      uv.push_back(chart);
    } else {
      uv.emplace_back(1 - chart.y, 1 - chart.x);
      at.x += 2;
    }
  }
  uv[3] = {nan, infinity};
  Scene displaced =
      displaced_scene(mesh, uv,
                      height_image(12, 16,
                                   [](std::uint32_t x, std::uint32_t y) {
                                     return static_cast<std::uint16_t>((x * 7919 + y * y * 12345) % 65536);
                                   }),
                      0.5f, -0.1f);
  Draw draw = std::move(displaced.draws[0]);
  draw.name = "displaced";
  draw.material = static_cast<MaterialId>(scene.materials.size());
  Material material = std::move(displaced.materials[0]);
  material.displacement->texture.image = static_cast<ImageId>(scene.images.size());
  scene.nodes.push_back({.name = "displaced", .mesh = static_cast<MeshId>(scene.meshes.size())});
  scene.meshes.push_back({.name = "displaced", .draws = {static_cast<DrawId>(scene.draws.size())}});
  scene.draws.push_back(std::move(draw));
  scene.materials.push_back(std::move(material));
  scene.images.push_back(std::move(displaced.images[0]));
}

}  // namespace

Scene odd_scene() {
  std::vector<Draw> draws{draw_of({{}, {}}, "empty"),
                          draw_of({{{1, 2, 3}}, {}}, "no triangle"),
                          draw_of(one_triangle(), "one triangle"),
                          draw_of(degenerate(), "degenerate"),
                          draw_of(fan_on_one_edge(12), "non-manifold"),
                          draw_of(not_finite(), "not finite"),
                          draw_of(nowhere_finite(), "nowhere finite"),
                          draw_of(all_in_one_point(), "one point"),
                          draw_of(huge_and_tiny(), "huge and tiny"),
                          draw_of(with_duplicates(), "duplicates"),
                          draw_of(with_unused_vertices(), "unused vertices"),
                          draw_of(shuffled(sphere(16, 12), 1), "shuffled sphere"),
                          draw_of(soup(60, 2), "soup"),
                          quantized(),
                          morphed(),
                          points(),
                          without_positions()};
  // Two more that share the sphere's vertices.
  for (const char* name : {"first half", "second half"}) {
    Draw half = draws[11];
    half.name = name;
    const auto all = half.levels[0].orders[0].indices.view();
    const std::size_t middle = all.size() / 6 * 3;
    const auto part = half.name == "first half" ? all.first(middle) : all.subspan(middle);
    half.levels[0].orders[0].indices = Shared<std::uint32_t>({part.begin(), part.end()});
    draws.push_back(std::move(half));
  }
  // Triangles with duplicate vertices whose vertices points draw too: nobody may move them.
  Draw held = draw_of({{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {3, 2, 1, 0, 2, 3}}, "held back");
  Draw holder = points();
  holder.name = "holder";
  holder.levels[0].vertices = held.levels[0].vertices;
  draws.push_back(std::move(held));
  draws.push_back(std::move(holder));
  Draw glass = draw_of(torus(5, 4), "glass");
  glass.traits.add(traits::blended);
  draws.push_back(std::move(glass));
  Scene scene = scene_of(std::move(draws));
  add_sprite(scene);
  add_displaced(scene);
  return scene;
}

}  // namespace foredraw::testing
