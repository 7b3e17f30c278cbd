// What is left of closed surfaces, judged by CGAL. Where CGAL is not found this is not built.

#include <plugins/processors/quadric_collapse/quadric_collapse.h>

#include "support/collapses.h"

#include <foredraw/analysis/welded_positions.h>
#include <foredraw/collapses/joined_mesh.h>
#include <foredraw/io/gltf/gltf.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <gtest/gtest.h>

#include <map>
#include <ostream>

namespace foredraw::cgal_manifold_test {
namespace {

namespace cgal_meshes = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using testing::TestMesh;

/// How CGAL finds it.
struct Verdict {
  bool is_manifold = false;  ///< each edge of two triangles at most, that run along it in opposite ways; no bow-ties
  bool is_closed = false;
  std::size_t components = 0;
  int genus = 0;  ///< of all components together
  double volume = 0;

  bool is_closed_manifold() const { return is_manifold && is_closed; }
};

std::ostream& operator<<(std::ostream& out, const Verdict& verdict) {
  return out << (verdict.is_manifold ? "a manifold" : "no manifold") << (verdict.is_closed ? ", closed" : ", open")
             << ", of " << verdict.components << " components, genus " << verdict.genus;
}

/// Vertices at one place are one.
Verdict judged(const TestMesh& mesh) {
  const std::vector<std::uint32_t> first = welded(mesh.positions);
  std::map<std::uint32_t, std::size_t> number;  // of those that triangles use
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> triangles;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t point = first[mesh.indices[i + k]];
      const auto [found, is_new] = number.try_emplace(point, points.size());
      const glm::vec3& at = mesh.positions[point];
      if (is_new) points.emplace_back(double{at.x}, double{at.y}, double{at.z});
      triangles.back().push_back(found->second);
    }
  }
  Verdict verdict;
  verdict.is_manifold = cgal_meshes::is_polygon_soup_a_polygon_mesh(triangles);
  if (!verdict.is_manifold) return verdict;
  CGAL::Surface_mesh<Kernel::Point_3> surface;
  cgal_meshes::polygon_soup_to_polygon_mesh(points, triangles, surface);
  verdict.is_manifold = CGAL::is_valid_polygon_mesh(surface) && CGAL::is_triangle_mesh(surface);
  verdict.is_closed = CGAL::is_closed(surface);
  auto component = surface.add_property_map<decltype(surface)::Face_index, std::size_t>("f:component").first;
  verdict.components = cgal_meshes::connected_components(surface, component);
  const int euler = static_cast<int>(surface.number_of_vertices()) - static_cast<int>(surface.number_of_edges()) +
                    static_cast<int>(surface.number_of_faces());
  verdict.genus = (2 * static_cast<int>(verdict.components) - euler) / 2;
  if (verdict.is_closed) verdict.volume = CGAL::to_double(cgal_meshes::volume(surface));
  return verdict;
}

/// Of equal triangles, all of which would do: each side of an octahedron is cut into `cells` squared.
TestMesh closed_sphere(std::uint32_t cells) {
  TestMesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> number;
  const auto vertex = [&](std::array<int, 3> at) {
    const auto [found, is_new] = number.try_emplace(at, static_cast<std::uint32_t>(mesh.positions.size()));
    const glm::dvec3 place(at[0], at[1], at[2]);
    const double length = std::sqrt(place.x * place.x + place.y * place.y + place.z * place.z);
    if (is_new) mesh.positions.push_back(glm::vec3(place / length));
    return found->second;
  };
  const int most = static_cast<int>(cells);
  for (int side = 0; side < 8; ++side) {
    const std::array sign{side & 1 ? -1 : 1, side & 2 ? -1 : 1, side & 4 ? -1 : 1};
    const auto at = [&](int i, int j) { return vertex({sign[0] * i, sign[1] * j, sign[2] * (most - i - j)}); };
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      if (sign[0] * sign[1] * sign[2] < 0) std::swap(b, c);
      mesh.indices.insert(mesh.indices.end(), {a, b, c});
    };
    for (int i = 0; i < most; ++i) {
      for (int j = 0; i + j < most; ++j) {
        add(at(i, j), at(i + 1, j), at(i, j + 1));
        if (i + j + 1 < most) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }
  return mesh;
}

TestMesh spot() {
  Diagnostics diagnostics;
  const auto scene = read_gltf(testing::project_file("benchmarks/corpus/static/spot.glb"), diagnostics);
  std::vector<DrawId> all;
  for (DrawId id = 0; id < scene.value().draws.size(); ++id) all.push_back(id);
  Analyses analyses;
  const JoinedMesh mesh = joined_mesh(*scene, all, analyses).value();
  return {mesh.positions, mesh.indices};
}

/// A tetrahedron's triangles, which are a mesh of nobody's doubt, and what spoils it.
TEST(CgalJudge, KnowsWhatIsNoClosedManifold) {
  const TestMesh good{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}};
  EXPECT_TRUE(judged(good).is_closed_manifold());
  EXPECT_EQ(judged(good).genus, 0);
  EXPECT_NEAR(judged(good).volume, 1.0 / 6, 1e-12);
  TestMesh open = good;
  open.indices.resize(9);
  EXPECT_TRUE(judged(open).is_manifold);
  EXPECT_FALSE(judged(open).is_closed);
  TestMesh turned = good;
  std::swap(turned.indices[0], turned.indices[1]);
  EXPECT_FALSE(judged(turned).is_manifold);
  TestMesh fin = good;
  fin.positions.push_back({5, 5, 5});
  fin.indices.insert(fin.indices.end(), {0, 1, 4});
  EXPECT_FALSE(judged(fin).is_manifold);
  const TestMesh bow = testing::joined(good, testing::moved(good, {1, 0, 0}));  // one corner in common
  EXPECT_FALSE(judged(bow).is_manifold);
  EXPECT_EQ(judged(testing::joined(good, testing::moved(good, {9, 0, 0}))).components, 2u);
  EXPECT_EQ(judged(testing::closed_torus(8, 6)).genus, 1);
}

struct Closed {
  const char* name;
  TestMesh mesh;
  int genus;
};

/// Down to a share of its triangles: at each level a closed manifold of the same genus, with its outside outside.
void expect_it_stays(const Closed& of, CollapsePlacement placement) {
  const Verdict full = judged(of.mesh);
  ASSERT_TRUE(full.is_closed_manifold()) << of.name << ": " << full;
  ASSERT_EQ(full.genus, of.genus) << of.name;
  const std::size_t triangles = of.mesh.indices.size() / 3;
  const CollapseSequence sequence = quadric_collapse(of.mesh.positions, of.mesh.indices, {.placement = placement});
  for (const std::size_t share : {2, 4, 10, 50, 200}) {
    const TestMesh left = testing::coarse(of.mesh, sequence, triangles / share);
    ASSERT_FALSE(left.indices.empty());
    const Verdict verdict = judged(left);
    EXPECT_TRUE(verdict.is_closed_manifold()) << of.name << ", one of " << share << ": " << verdict;
    EXPECT_EQ(verdict.components, full.components) << of.name << ", one of " << share;
    EXPECT_EQ(verdict.genus, of.genus) << of.name << ", one of " << share;
    EXPECT_GT(verdict.volume * full.volume, 0) << of.name << ", one of " << share;
  }
  // And where nothing more may go.
  const TestMesh least = testing::coarse(of.mesh, sequence, 0);
  EXPECT_TRUE(judged(least).is_closed_manifold()) << of.name << ": " << judged(least);
  EXPECT_EQ(judged(least).genus, of.genus) << of.name;
}

/// Of one piece and of several, which collapse on their own.
TEST(QuadricCollapse, CgalFindsClosedManifoldsClosedManifolds) {
  const std::vector<Closed> closed{{"sphere", closed_sphere(24), 0},
                                   {"sphere of pieces", closed_sphere(60), 0},
                                   {"torus", testing::closed_torus(64, 32), 1},
                                   {"torus of pieces", testing::closed_torus(150, 80), 1},
                                   {"spot", spot(), 0}};
  for (const Closed& one : closed) {
    for (const CollapsePlacement placement : {CollapsePlacement::optimal, CollapsePlacement::endpoint}) {
      expect_it_stays(one, placement);
    }
  }
}

}  // namespace
}  // namespace foredraw::cgal_manifold_test
