// Triangles and noise that made-up models consist of.
#include "clip.h"
#include "indoor_models.h"
#include "outdoor_models.h"
#include "shapes.h"
#include "solid_noise.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace foredraw::bench::surface_mesh_test {
namespace {

using Place = std::array<float, 3>;
Place key_of(const glm::vec3& v) { return {v.x + 0.f, v.y + 0.f, v.z + 0.f}; }

/// How often edges lie between two places, in one direction more than in the other. All are 0: the mesh is closed.
std::size_t open_edges(const SurfaceMesh& mesh) {
  std::map<std::pair<Place, Place>, int> edges;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Place a = key_of(mesh.places[mesh.indices[i + k]]), b = key_of(mesh.places[mesh.indices[i + (k + 1) % 3]]);
      a < b ? ++edges[{a, b}] : --edges[{b, a}];
    }
  }
  return static_cast<std::size_t>(std::ranges::count_if(edges, [](const auto& edge) { return edge.second != 0; }));
}

double volume(const SurfaceMesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::dvec3 a(mesh.places[mesh.indices[i]]), b(mesh.places[mesh.indices[i + 1]]),
        c(mesh.places[mesh.indices[i + 2]]);
    sum += glm::dot(a, glm::cross(b, c)) / 6;
  }
  return sum;
}

TEST(SurfaceMesh, shapes_are_closed_with_their_outer_side_outwards) {
  SurfaceMesh boulder, cushion, box, turned, ring;
  add_boulder(boulder, {.radii = glm::dvec3(1), .cells = 9, .rough = 0});
  add_cushion(cushion, {1, 2, 3}, {.5, 1, 2}, .2, 7);
  add_box(box, {0, 0, 0}, {1, 2, 3});
  add_turned(turned, {{}, polyline({{0, 0}, {1, 0}, {1, 2}, {0, 2}}), 64, 30});
  add_tube(ring, {[](double t) {
                    const double s = t < .5 ? 1 : -1, x = 4 * (t < .5 ? t : t - .5) - 1;  // two half circles, roughly
                    return glm::dvec3(2 * x * s, 1.2 * s * (1 - x * x), 0);
                  },
                  [](double) { return .1; }, 8, 40, true});
  for (SurfaceMesh* mesh : {&boulder, &cushion, &box, &turned, &ring}) {
    finish(*mesh);
    EXPECT_EQ(open_edges(*mesh), 0u);
    EXPECT_GT(volume(*mesh), 0);
  }
  EXPECT_EQ(boulder.triangles(), 12u * 81);
  EXPECT_NEAR(volume(boulder), 4.1888, .1);
  EXPECT_NEAR(volume(box), 6, 1e-6);
  EXPECT_NEAR(volume(turned), 6.2832, .05);
}

TEST(SurfaceMesh, normals_and_tangents_are_those_of_the_surface) {
  SurfaceMesh ball;
  add_boulder(ball, {.radii = glm::dvec3(2), .cells = 24, .rough = 0});
  finish(ball);
  ASSERT_EQ(ball.normals.size(), ball.places.size());
  for (std::size_t v = 0; v < ball.places.size(); ++v) {
    EXPECT_GT(glm::dot(ball.normals[v], ball.places[v] / 2.f), .995f);
    const glm::vec3 tangent(ball.tangents[v]);
    EXPECT_NEAR(glm::length(tangent), 1, 1e-5);
    EXPECT_NEAR(glm::dot(tangent, ball.normals[v]), 0, 1e-5);
  }
  SurfaceMesh floor;  // u along x, v along -z: seen from above, v is up, and so the bitangent, along -v, goes to +z
  add_grid(floor, 2, 2, [](std::size_t i, std::size_t j) { return glm::dvec3(i, 0, -static_cast<double>(j)); });
  finish(floor);
  for (std::size_t v = 0; v < floor.places.size(); ++v) {
    EXPECT_EQ(floor.normals[v], glm::vec3(0, 1, 0));
    EXPECT_EQ(glm::vec3(floor.tangents[v]), glm::vec3(1, 0, 0));
    const glm::vec3 bitangent = glm::cross(floor.normals[v], glm::vec3(floor.tangents[v])) * floor.tangents[v].w;
    EXPECT_EQ(bitangent, glm::vec3(0, 0, 1));
  }
}

TEST(SurfaceMesh, every_vertex_has_a_triangle_and_no_triangle_is_a_line) {
  std::vector<std::vector<ModelPart>> models = {tree(2, 1), bush(1, 2),   rock(1, 3),   tuft(1, 4),    statue(1, 5),
                                                table(),    chair(1),     sofa(1),      shelf(1),      pedestal(),
                                                vase(1),    floor_lamp(), pot_plant(1), chandelier(1), rug(1)};
  for (std::uint64_t kind = 0; kind < street_kinds; ++kind) models.push_back(street_piece(1, kind));
  for (std::size_t m = 0; m < models.size(); ++m) {
    for (ModelPart& part : models[m]) {
      finish(part.mesh);
      std::vector<bool> used(part.mesh.places.size(), false);
      for (std::size_t i = 0; i < part.mesh.indices.size(); i += 3) {
        const std::uint32_t a = part.mesh.indices[i], b = part.mesh.indices[i + 1], c = part.mesh.indices[i + 2];
        used[a] = used[b] = used[c] = true;
        EXPECT_TRUE(part.mesh.places[a] != part.mesh.places[b] && part.mesh.places[b] != part.mesh.places[c] &&
                    part.mesh.places[c] != part.mesh.places[a]);
      }
      EXPECT_EQ(std::ranges::count(used, false), 0) << "model " << m << ", " << part.material;
    }
  }
}

TEST(SolidNoise, stays_within_its_bounds_and_repeats_where_it_says_so) {
  double least = 1, most = -1;
  for (int i = 0; i < 2000; ++i) {
    const double t = .137 * i;
    const double value = rough_noise({t, 3 - t, .5 * t}, 4, 9);
    least = std::min(least, value);
    most = std::max(most, value);
    const glm::dvec2 place(t - std::floor(t), .618 * t - std::floor(.618 * t));
    const double tile = tiled_noise(place, {5, 3}, 3, 9);
    EXPECT_TRUE(tile >= 0 && tile <= 1);
    EXPECT_NEAR(tile, tiled_noise(place + glm::dvec2(1, 2), {5, 3}, 3, 9), 1e-9);
  }
  EXPECT_GE(least, -1);
  EXPECT_LE(most, 1);
  EXPECT_GT(most - least, .6);
  EXPECT_NE(noise({.5, .5, .5}, 1), noise({.5, .5, .5}, 2));
}

TEST(Clip, speaks_for_times_between_its_keys) {
  const Clip::Track turn{0, "rotation", 4, {0, 1}, {0, 0, 0, 1, 0, -.6f, 0, -.8f}, true};
  std::vector<float> values;
  Clip::add_value(turn, 0, values);
  Clip::add_value(turn, .5, values);
  Clip::add_value(turn, 7, values);
  ASSERT_EQ(values.size(), 12u);
  EXPECT_FLOAT_EQ(values[3], 1);
  EXPECT_FLOAT_EQ(values[5], .3f / std::sqrt(.9f));  // the shorter way
  EXPECT_FLOAT_EQ(values[7], .9f / std::sqrt(.9f));
  EXPECT_FLOAT_EQ(values[9], .6f);
  const Clip::Track place{0, "translation", 3, {1, 3}, {0, 0, 0, 2, 4, 6}, true};
  values.clear();
  Clip::add_value(place, 0, values);
  Clip::add_value(place, 1.5, values);
  EXPECT_EQ(values, (std::vector<float>{0, 0, 0, .5f, 1, 1.5f}));
}

}  // namespace
}  // namespace foredraw::bench::surface_mesh_test
