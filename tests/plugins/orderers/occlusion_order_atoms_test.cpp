#include "occlusion_order_seen.h"

#include <gtest/gtest.h>

namespace foredraw::occlusion_order_atoms_test {
namespace {

using testing::for_the_cache;
using testing::TestMesh;

/// Vertices that are in the cache on both sides of a cut and used behind it, as the definition says.
std::uint64_t parted(const TestMesh& mesh, std::uint32_t cut) {
  std::uint64_t count = 0;
  FifoCache cache(mesh.positions.size(), 16);
  std::vector<bool> entered_before(mesh.positions.size(), false), is_counted(mesh.positions.size(), false);
  for (std::uint32_t i = 0; i < mesh.indices.size(); ++i) {
    const std::uint32_t vertex = mesh.indices[i];
    const bool missed = cache.misses(vertex);
    if (i / 3 < cut) {
      entered_before[vertex] = true;
    } else if (missed) {
      is_counted[vertex] = true;  // it entered again, behind the cut
    } else if (entered_before[vertex] && !is_counted[vertex]) {
      is_counted[vertex] = true;
      ++count;
    }
  }
  return count;
}

TEST(Atoms, PartFewestVerticesOfAllWaysToCut) {
  const TestMesh mesh = for_the_cache(testing::torus(6, 5));
  const auto triangles = static_cast<std::uint32_t>(mesh.indices.size() / 3);
  const AtomSize size{5, 11};
  std::vector<std::uint64_t> cost(triangles);
  for (std::uint32_t t = 1; t < triangles; ++t) cost[t] = parted(mesh, t);
  std::vector<std::uint64_t> least(triangles + 1, ~std::uint64_t{0} / 2);
  least[0] = 0;
  for (std::uint32_t t = 1; t <= triangles; ++t) {
    for (std::uint32_t n = size.least; n <= std::min(size.most, t); ++n) {
      least[t] = std::min(least[t], least[t - n] + (t < triangles ? cost[t] : 0));
    }
  }
  const Clusters atoms = cut_atoms(mesh.indices, mesh.positions.size(), 16, size);
  ASSERT_TRUE(is_partition(atoms, triangles));
  std::uint64_t found = 0;
  for (std::size_t i = 1; i < atoms.count(); ++i) {
    found += cost[atoms.offsets[i]];
    EXPECT_GE(atoms.offsets[i + 1] - atoms.offsets[i], size.least);
    EXPECT_LE(atoms.offsets[i + 1] - atoms.offsets[i], size.most);
  }
  EXPECT_EQ(found, least[triangles]);
}

TEST(Atoms, AreCutWhereverItCostsNothing) {
  const TestMesh mesh = testing::soup(40, 1);
  EXPECT_EQ(cut_atoms(mesh.indices, mesh.positions.size(), 16, {4, 12}).count(), 40u);
}

TEST(Atoms, OfFewTrianglesAreOne) {
  const TestMesh mesh = testing::grid(1, 2);
  EXPECT_EQ(cut_atoms(mesh.indices, mesh.positions.size(), 16, {4, 12}).offsets, (std::vector<std::uint32_t>{0, 4}));
  EXPECT_EQ(cut_atoms({}, 0, 16, {4, 12}).offsets, (std::vector<std::uint32_t>{0}));
}

TEST(Atoms, KnowWhatCuttingThemOffCosts) {
  // Two strips of a grid: drawn one behind the other the second finds the middle row in the cache.
  const TestMesh mesh = testing::grid(4, 2);
  const Clusters rows{{0, 8, 16}};
  EXPECT_EQ(misses_of_cuts(mesh.indices, mesh.positions.size(), 16, rows), (std::vector<std::uint32_t>{0, 5}));
}

}  // namespace
}  // namespace foredraw::occlusion_order_atoms_test
