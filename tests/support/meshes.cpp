#include "support/meshes.h"

#include <foredraw/scene/triangle_draw.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace foredraw::testing {

namespace {

/// Two triangles for every cell of a lattice of columns + 1 by rows + 1 vertices.
void add_lattice(TestMesh& mesh, std::uint32_t columns, std::uint32_t rows) {
  for (std::uint32_t y = 0; y < rows; ++y) {
    for (std::uint32_t x = 0; x < columns; ++x) {
      const std::uint32_t a = y * (columns + 1) + x;
      const std::uint32_t c = a + columns + 1;
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, c, c, a + 1, c + 1});
    }
  }
}

glm::vec3 unit_cube(Random& random) {
  return {random.unit(), random.unit(), random.unit()};  // braces: left to right in every compiler
}

}  // namespace

TestMesh grid(std::uint32_t columns, std::uint32_t rows) {
  TestMesh mesh;
  for (std::uint32_t y = 0; y <= rows; ++y) {
    for (std::uint32_t x = 0; x <= columns; ++x) mesh.positions.emplace_back(x, y, 0);
  }
  add_lattice(mesh, columns, rows);
  return mesh;
}

TestMesh sphere(std::uint32_t slices, std::uint32_t stacks, float radius, glm::vec3 centre) {
  TestMesh mesh;
  for (std::uint32_t y = 0; y <= stacks; ++y) {
    const float theta = std::numbers::pi_v<float> * static_cast<float>(y) / static_cast<float>(stacks);
    for (std::uint32_t x = 0; x <= slices; ++x) {
      const float phi = 2 * std::numbers::pi_v<float> * static_cast<float>(x) / static_cast<float>(slices);
      mesh.positions.push_back(centre + radius * glm::vec3(std::sin(theta) * std::cos(phi), std::cos(theta),
                                                           std::sin(theta) * std::sin(phi)));
    }
  }
  add_lattice(mesh, slices, stacks);
  return mesh;
}

TestMesh torus(std::uint32_t slices, std::uint32_t sides, float radius, float tube) {
  TestMesh mesh;
  for (std::uint32_t y = 0; y <= sides; ++y) {
    const float v = 2 * std::numbers::pi_v<float> * static_cast<float>(y) / static_cast<float>(sides);
    for (std::uint32_t x = 0; x <= slices; ++x) {
      const float u = 2 * std::numbers::pi_v<float> * static_cast<float>(x) / static_cast<float>(slices);
      const float r = radius + tube * std::cos(v);
      mesh.positions.emplace_back(r * std::cos(u), -tube * std::sin(v), r * std::sin(u));
    }
  }
  add_lattice(mesh, slices, sides);
  return mesh;
}

TestMesh soup(std::uint32_t triangles, std::uint64_t seed) {
  Random random(seed);
  TestMesh mesh;
  for (std::uint32_t t = 0; t < triangles; ++t) {
    const glm::vec3 centre = unit_cube(random);
    for (int corner = 0; corner < 3; ++corner) {
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      mesh.positions.push_back(centre + 0.2f * unit_cube(random));
    }
  }
  return mesh;
}

TestMesh shuffled(TestMesh mesh, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t t = mesh.indices.size() / 3; t > 1; --t) {
    const std::size_t other = random.below(t);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::swap(mesh.indices[3 * (t - 1) + corner], mesh.indices[3 * other + corner]);
    }
  }
  return mesh;
}

TestMesh joined(const TestMesh& a, const TestMesh& b) {
  TestMesh mesh = a;
  const auto first = static_cast<std::uint32_t>(a.positions.size());
  mesh.positions.insert(mesh.positions.end(), b.positions.begin(), b.positions.end());
  for (std::uint32_t index : b.indices) mesh.indices.push_back(first + index);
  return mesh;
}

std::shared_ptr<const VertexStreams> vertex_streams(const std::vector<glm::vec3>& positions) {
  VertexStreams streams;
  streams.count = static_cast<std::uint32_t>(positions.size());
  streams.base.push_back(float_stream("POSITION", positions));
  return std::make_shared<const VertexStreams>(std::move(streams));
}

Draw draw_of(const TestMesh& mesh, std::string name) {
  Draw draw;
  draw.name = std::move(name);
  draw.traits = {traits::triangles};
  Level level;
  level.vertices = vertex_streams(mesh.positions);
  IndexStream stream;
  stream.indices = Shared<std::uint32_t>(mesh.indices);
  level.orders.push_back(std::move(stream));
  draw.levels.push_back(std::move(level));
  return draw;
}

Scene scene_of(std::vector<Draw> draws) {
  Scene scene;
  scene.name = "test scene";
  scene.draws = std::move(draws);
  for (DrawId id = 0; id < scene.draws.size(); ++id) {
    Mesh mesh;
    mesh.name = scene.draws[id].name;
    mesh.draws = {id};
    scene.meshes.push_back(std::move(mesh));
    Node node;
    node.mesh = id;
    scene.nodes.push_back(std::move(node));
  }
  return scene;
}

Scene scene_of(const TestMesh& mesh) { return scene_of({draw_of(mesh)}); }

std::filesystem::path project_file(const std::string& name) {
  return std::filesystem::path(FOREDRAW_SOURCE_DIR) / name;
}

}  // namespace foredraw::testing
