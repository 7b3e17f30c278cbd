#pragma once
// What the techniques are timed on: the corpus as a whole, and single meshes made larger by midpoint subdivision.

#include "support/meshes.h"

namespace foredraw::bench {

using testing::TestMesh;

/// Meshes that are worked on one after the other, as one run.
struct MeshSet {
  std::string name;
  std::vector<TestMesh> meshes;

  std::size_t triangles() const;
};

/// The corpus, and spot and head from as they are to 1.5 million triangles: in their own order, with triangles
/// shuffled ("/t"), and with vertices shuffled too ("/tv").
std::vector<MeshSet> mesh_sets();

/// Each triangle cut in four at the midpoints of its edges, the new ones one behind the other.
TestMesh subdivided(const TestMesh& mesh);

TestMesh with_shuffled_vertices(const TestMesh& mesh, std::uint64_t seed);

}  // namespace foredraw::bench
