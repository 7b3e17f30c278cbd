#include "odd_draws.h"

#include <foredraw/base/random.h>
#include <foredraw/image/found_traits.h>
#include <foredraw/scene/triangle_draw.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foredraw::cli {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

struct OddMesh {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
};

/// A square of cells, two triangles each, bent to where `bent` says.
template <class Bent>
OddMesh sheet(std::uint32_t across, std::uint32_t down, Bent bent) {
  OddMesh mesh;
  for (std::uint32_t y = 0; y <= down; ++y) {
    for (std::uint32_t x = 0; x <= across; ++x) {
      mesh.positions.push_back(
          bent(static_cast<float>(x) / static_cast<float>(across), static_cast<float>(y) / static_cast<float>(down)));
    }
  }
  for (std::uint32_t y = 0; y < down; ++y) {
    for (std::uint32_t x = 0; x < across; ++x) {
      const std::uint32_t a = y * (across + 1) + x, b = a + across + 1;
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, b, b, a + 1, b + 1});
    }
  }
  return mesh;
}

OddMesh grid(std::uint32_t across, std::uint32_t down) {
  return sheet(across, down, [](float u, float v) { return glm::vec3(u, v, 0); });
}

/// Round without a sine: points of a cube's face, brought to length 1.
OddMesh sphere(std::uint32_t cells) {
  OddMesh mesh;
  for (int face = 0; face < 6; ++face) {
    OddMesh side = sheet(cells, cells, [&](float u, float v) {
      const float x = 2 * u - 1, y = 2 * v - 1, z = face % 2 == 0 ? 1.0f : -1.0f;
      const glm::vec3 at = face / 2 == 0 ? glm::vec3(x, y, z) : face / 2 == 1 ? glm::vec3(z, x, y) : glm::vec3(y, z, x);
      return at / std::sqrt(at.x * at.x + at.y * at.y + at.z * at.z);
    });
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), side.positions.begin(), side.positions.end());
    for (const std::uint32_t index : side.indices) mesh.indices.push_back(first + index);
  }
  return mesh;
}

OddMesh shuffled(OddMesh mesh) {
  Random random(1);
  for (std::size_t t = mesh.indices.size() / 3; t > 1; --t) {
    const auto other = static_cast<std::ptrdiff_t>(3 * random.below(t));
    std::swap_ranges(mesh.indices.begin() + other, mesh.indices.begin() + other + 3,
                     mesh.indices.begin() + static_cast<std::ptrdiff_t>(3 * (t - 1)));
  }
  return mesh;
}

OddMesh degenerate() {
  OddMesh mesh = grid(3, 3);
  mesh.indices.insert(mesh.indices.end(), {0, 0, 0, 1, 1, 2, 0, 1, 2, 3, 2, 3});
  return mesh;
}

OddMesh fan_on_one_edge() {
  OddMesh mesh{{{0, 0, 0}, {0, 1, 0}}, {}};
  for (std::uint32_t i = 0; i < 12; ++i) {
    mesh.positions.emplace_back(1, 0, static_cast<float>(i));
    mesh.indices.insert(mesh.indices.end(), {0, 1, i + 2});
  }
  return mesh;
}

OddMesh not_finite() {
  OddMesh mesh = sphere(4);
  mesh.positions[5].x = nan;
  mesh.positions[20].y = infinity;
  mesh.positions[33] = {-infinity, nan, infinity};
  return mesh;
}

OddMesh with_twins_and_unused() {
  OddMesh mesh = sphere(3);
  const std::vector<std::uint32_t> again(mesh.indices.begin(), mesh.indices.begin() + 30);
  mesh.indices.insert(mesh.indices.end(), again.begin(), again.end());
  mesh.positions.resize(mesh.positions.size() + 50, glm::vec3(9));
  return mesh;
}

Scene scene_of(std::vector<std::pair<const char*, OddMesh>> meshes) {
  Scene scene;
  scene.name = "odd draws";
  for (auto& [name, mesh] : meshes) {
    const auto id = static_cast<DrawId>(scene.draws.size());
    scene.draws.push_back(triangle_draw(name, mesh.positions, std::move(mesh.indices)));
    scene.meshes.push_back({.name = name, .draws = {id}});
    scene.nodes.push_back({.name = name, .mesh = static_cast<MeshId>(id)});
  }
  find_traits(scene);
  return scene;
}

}  // namespace

Scene odd_draws() {
  return scene_of({{"empty", {}},
                   {"no triangle", {{{1, 2, 3}}, {}}},
                   {"one triangle", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}}},
                   {"degenerate", degenerate()},
                   {"non-manifold", fan_on_one_edge()},
                   {"not finite", not_finite()},
                   {"nowhere finite", {{{nan, nan, nan}, {infinity, 0, 0}, {nan, 0, 0}}, {0, 1, 2, 2, 1, 0}}},
                   {"one point", {std::vector<glm::vec3>(9, glm::vec3(2, 3, 4)), {0, 1, 2, 3, 4, 5, 6, 7, 8}}},
                   {"huge and tiny",
                    {{{3e38f, 3e38f, 3e38f}, {-3e38f, 0, 0}, {0, -3e38f, 0}, {1e-40f, 0, 0}, {0, 1e-40f, 0}},
                     {0, 1, 2, 2, 3, 4, 0, 3, 4}}},
                   {"twins and unused vertices", with_twins_and_unused()},
                   {"grid", grid(20, 10)},
                   {"shuffled sphere", shuffled(sphere(6))}});
}

Scene shuffled_sphere(std::size_t triangles) {
  const double cells = std::sqrt(static_cast<double>(triangles) / 12);
  return scene_of({{"sphere", shuffled(sphere(static_cast<std::uint32_t>(std::max(std::lround(cells), 1l))))}});
}

}  // namespace foredraw::cli
