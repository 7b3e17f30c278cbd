#pragma once
// What is timed: the draws of the corpus, and single models made larger by midpoint subdivision.

#include "support/meshes.h"

namespace foredraw::bench {

using testing::TestMesh;

/// Meshes that are worked on one after the other, as one run.
struct MeshSet {
  std::string name;
  std::vector<TestMesh> meshes;

  std::size_t triangles() const;
};

/// All triangle draws of the corpus.
MeshSet corpus();

/// The triangle draws of one model of the corpus ("static/spot.glb").
MeshSet draws_of(const std::string& model);

/// A model of the corpus as one mesh, vertices of equal position being one, and subdivided so many
/// times: "spot 6k", "spot 94k". The levels ascend.
std::vector<MeshSet> subdivisions(const std::string& model, const std::vector<int>& levels);

/// The set as it is, with triangles shuffled ("/t"), and with vertices shuffled too ("/tv").
std::vector<MeshSet> arrangements(const MeshSet& set);

/// Each triangle cut in four at the midpoints of its edges, the new ones one behind the other.
TestMesh subdivided(const TestMesh& mesh);

TestMesh with_shuffled_vertices(const TestMesh& mesh, std::uint64_t seed);

/// Triangles in another order; order[new] = old.
std::vector<std::uint32_t> reordered(std::span<const std::uint32_t> indices, std::span<const std::uint32_t> order);

}  // namespace foredraw::bench
