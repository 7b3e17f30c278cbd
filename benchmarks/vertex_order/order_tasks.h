#pragma once
// What the orderers are given: meshes from a few triangles to 1.5 million, in three arrangements each.

#include "bench_meshes.h"

namespace foredraw::bench {

struct OrderTask {
  std::string size;         ///< of each mesh: "below 10k", "10k to 300k" or "above 800k" triangles; or "grid"
  std::string arrangement;  ///< "own"; "t": triangles shuffled; "tv": vertices too
  MeshSet set;
};

/// The grids among the tasks, by the names of their sets.
struct Grid {
  std::uint32_t columns, rows;
  std::string name() const;
};
inline constexpr Grid grids[] = {{100, 100}, {420, 420}};

/// The draws of the corpus in two size classes, four of its models subdivided, and the grids; without those above
/// `most_triangles`.
std::vector<OrderTask> order_tasks(std::size_t most_triangles);

}  // namespace foredraw::bench
