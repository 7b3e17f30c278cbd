#include "support/collapses.h"

#include <foredraw/analysis/farthest_distance.h>
#include <foredraw/analysis/welded_positions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace foredraw::testing {

namespace {

constexpr double turn = 6.283185307179586;

}  // namespace

TestMesh coarse(const TestMesh& mesh, const CollapseSequence& sequence, std::size_t triangles) {
  const Replay run = replay(sequence, mesh.positions, mesh.indices);
  EXPECT_EQ(run.mistake, "");
  std::size_t n = 0;
  while (n + 1 < run.triangles.size() && run.triangles[n] > triangles) ++n;
  const Collapsed after = collapsed(sequence, n, mesh.positions, mesh.indices);
  return {after.places, after.indices};
}

double distance(const TestMesh& a, const TestMesh& b) {
  const Surface first{a.positions, a.indices}, second{b.positions, b.indices};
  const auto farthest =
      hausdorff_distance({first, ClosestPoints(first)}, {second, ClosestPoints(second)}, {}, Executor(1));
  return farthest ? farthest->bound : std::numeric_limits<double>::infinity();
}

std::map<int, int> edges(const TestMesh& mesh) {
  const std::vector<std::uint32_t> point = welded(mesh.positions);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> count;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    for (int k = 0; k < 3; ++k) {
      ++count[std::minmax(point[mesh.indices[i + k]], point[mesh.indices[i + (k + 1) % 3]])];
    }
  }
  std::map<int, int> by_count;
  for (const auto& [edge, faces] : count) ++by_count[faces];
  return by_count;
}

int euler(const TestMesh& mesh) {
  const std::vector<std::uint32_t> point = welded(mesh.positions);
  std::set<std::uint32_t> points;
  for (const std::uint32_t v : mesh.indices) points.insert(point[v]);
  int number = 0;
  for (const auto& [faces, count] : edges(mesh)) number += count;
  return static_cast<int>(points.size()) - number + static_cast<int>(mesh.indices.size() / 3);
}

TestMesh moved(TestMesh mesh, glm::vec3 by) {
  for (glm::vec3& p : mesh.positions) p += by;
  return mesh;
}

TestMesh closed_torus(std::uint32_t slices, std::uint32_t sides) {
  TestMesh mesh = torus(slices, sides);  // its last row and column lie a rounding beside the first ones
  for (std::uint32_t& v : mesh.indices) v = v / (slices + 1) % sides * (slices + 1) + v % (slices + 1) % slices;
  return mesh;
}

TestMesh flat_ring(std::uint32_t around, std::uint32_t across) {
  TestMesh ring;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j <= across; ++j) {
      const double angle = turn * i / around, radius = 1 + static_cast<double>(j) / across;
      ring.positions.push_back(glm::vec3(radius * std::cos(angle), radius * std::sin(angle), 0));
      if (j == across) continue;
      const std::uint32_t a = i * (across + 1) + j, b = (i + 1) % around * (across + 1) + j;
      ring.indices.insert(ring.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
    }
  }
  return ring;
}

TestMesh spokes(std::uint32_t around) {
  TestMesh cone{{{0, 0, 1}}, {}};
  for (std::uint32_t i = 0; i < around; ++i) {
    const double angle = turn * i / around;
    cone.positions.push_back(glm::vec3(std::cos(angle), std::sin(angle), 0));
    cone.indices.insert(cone.indices.end(), {0, i + 1, (i + 1) % around + 1});
  }
  return cone;
}

TestMesh moebius_strip(std::uint32_t around) {
  TestMesh strip;
  constexpr std::uint32_t across = 4;
  for (std::uint32_t i = 0; i < around; ++i) {
    const double angle = turn * i / around;
    for (std::uint32_t j = 0; j <= across; ++j) {
      const double from_middle = static_cast<double>(j) / across - 0.5;
      const double radius = 2 + from_middle * std::cos(angle / 2);
      strip.positions.push_back(
          glm::vec3(radius * std::cos(angle), radius * std::sin(angle), from_middle * std::sin(angle / 2)));
    }
    const bool is_last = i + 1 == around;
    const auto next = [&](std::uint32_t j) { return is_last ? across - j : (i + 1) * (across + 1) + j; };
    for (std::uint32_t j = 0; j < across; ++j) {
      const std::uint32_t a = i * (across + 1) + j;
      strip.indices.insert(strip.indices.end(), {a, next(j), next(j + 1), a, next(j + 1), a + 1});
    }
  }
  return strip;
}

TestMesh box_of_sides(std::uint32_t cells) {
  TestMesh box;
  const TestMesh side = grid(cells, cells);
  glm::vec3 most(0);
  for (const glm::vec3& p : side.positions) most = glm::max(most, p);
  const auto add = [&](auto place) {
    TestMesh one = side;
    for (glm::vec3& p : one.positions) p = place(p.x / most.x, p.y / most.y);
    box = joined(box, one);
  };
  add([](float u, float v) { return glm::vec3(u, v, 1); });
  add([](float u, float v) { return glm::vec3(v, u, 0); });
  add([](float u, float v) { return glm::vec3(1, u, v); });
  add([](float u, float v) { return glm::vec3(0, v, u); });
  add([](float u, float v) { return glm::vec3(v, 1, u); });
  add([](float u, float v) { return glm::vec3(u, 0, v); });
  return box;
}

std::vector<TestMesh> odd_meshes() {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  std::vector<TestMesh> meshes{{},
                               {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}},
                               {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2, 0, 1, 2, 2, 1, 0, 0, 0, 1}},
                               {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {0, 1, 2}},
                               soup(300, 3),
                               moebius_strip(40)};
  TestMesh fan;  // of which each triangle shares one edge
  for (std::uint32_t i = 0; i < 100; ++i) fan.indices.insert(fan.indices.end(), {0, 1, i + 2});
  for (std::uint32_t i = 0; i < 102; ++i) fan.positions.push_back(glm::vec3(i < 2 ? i : 0.5f, i % 10, i / 10));
  meshes.push_back(fan);
  const TestMesh plate = grid(12, 12);
  meshes.push_back(joined(plate, plate));  // each triangle twice
  TestMesh upright = plate;                // both plates have an edge in common
  for (glm::vec3& p : upright.positions) p = {p.x, 0, p.y};
  meshes.push_back(joined(plate, upright));
  TestMesh crossing = plate;  // and three sheets along one line
  for (glm::vec3& p : crossing.positions) p = {p.x, -p.y, 0};
  meshes.push_back(joined(joined(plate, upright), crossing));
  meshes.push_back(joined(plate, moved(plate, {-plate.positions.back().x, -plate.positions.back().y, 0})));  // a point
  TestMesh broken = torus(16, 8);
  broken.positions[3] = {nan, 0, 0};
  broken.positions[70] = {0, infinity, 0};
  meshes.push_back(broken);
  for (const float scale : {1e-30f, 1e30f, 1e-38f}) {
    TestMesh mesh = torus(16, 8);
    for (glm::vec3& p : mesh.positions) p *= scale;
    meshes.push_back(mesh);
  }
  TestMesh line = grid(10, 10);
  for (glm::vec3& p : line.positions) p.y = p.z = 0;
  meshes.push_back(line);
  TestMesh fine = grid(16, 16);  // T-joints: twice as fine beside a plate
  for (glm::vec3& p : fine.positions) p = {p.x / 2 + 12, p.y * 0.75f, 0};
  meshes.push_back(joined(plate, fine));
  TestMesh flat = spokes(60);  // a fan without area: its rim lies on a line through its hub
  for (glm::vec3& p : flat.positions) p = {p.x, p.x, 0};
  meshes.push_back(flat);
  TestMesh cracked = torus(16, 8);  // each third triangle has corners of its own, beside the others' by one bit
  for (std::size_t i = 0; i < cracked.indices.size(); ++i) {
    if (i / 3 % 3 != 0) continue;
    const glm::vec3 at = cracked.positions[cracked.indices[i]];
    cracked.indices[i] = static_cast<std::uint32_t>(cracked.positions.size());
    cracked.positions.push_back({std::nextafter(at.x, 9.0f), at.y, at.z});
  }
  meshes.push_back(cracked);
  TestMesh strewn = torus(16, 8);  // between vertices that no triangle uses
  for (const float x : {nan, infinity, 0.0f, 1e38f}) strewn.positions.insert(strewn.positions.begin(), {x, x, x});
  for (std::uint32_t& index : strewn.indices) index += 4;
  meshes.push_back(strewn);
  TestMesh far = closed_torus(16, 8);  // as far away as floats know whole numbers alone
  for (glm::vec3& p : far.positions) p = 20.0f * p + glm::vec3(1e7f, -1e7f, 1e7f);
  meshes.push_back(far);
  TestMesh inverted = plate;  // a patch that faces the other way
  for (std::size_t i = 60; i < 120; i += 3) std::swap(inverted.indices[i], inverted.indices[i + 1]);
  meshes.push_back(inverted);
  return meshes;
}

void expect_topology_stays(const Simplify& simplify) {
  const auto left_of = [&](const TestMesh& mesh, std::size_t triangles) {
    const TestMesh left = coarse(mesh, simplify(mesh, triangles), triangles);
    EXPECT_LE(left.indices.size() / 3, triangles);
    return left;
  };
  const TestMesh torus = left_of(closed_torus(32, 16), 200);
  EXPECT_EQ(euler(torus), 0);
  EXPECT_EQ(edges(torus).size(), 1u);  // all of two triangles
  EXPECT_EQ(euler(left_of(flat_ring(48, 6), 150)), 0);
  EXPECT_EQ(euler(left_of(grid(20, 20), 200)), 1);
}

void expect_seams_stay(const Simplify& simplify) {
  const TestMesh box = box_of_sides(8);
  const TestMesh left = coarse(box, simplify(box, 100), 100);
  EXPECT_LE(left.indices.size() / 3, 100u);
  EXPECT_EQ(edges(left).size(), 1u);
  EXPECT_EQ(euler(left), 2);
  const std::size_t of_side = box.positions.size() / 6;
  for (std::size_t i = 0; i < left.indices.size(); i += 3) {
    EXPECT_EQ(left.indices[i] / of_side, left.indices[i + 1] / of_side);
    EXPECT_EQ(left.indices[i] / of_side, left.indices[i + 2] / of_side);
  }
}

void expect_odd_meshes_run(const Simplify& simplify) {
  for (const TestMesh& mesh : odd_meshes()) {
    EXPECT_EQ(replay(simplify(mesh, 0), mesh.positions, mesh.indices).mistake, "");
  }
}

void expect_it_stops(const Simplify& simplify) {
  const TestMesh mesh = closed_torus(16, 8);
  const Replay run = replay(simplify(mesh, 200), mesh.positions, mesh.indices);
  EXPECT_LE(run.triangles.back(), 200u);
  EXPECT_GE(run.triangles.back(), 198u);
}

}  // namespace foredraw::testing
