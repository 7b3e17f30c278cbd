#pragma once
// Which split makes which point, what it adds, and what must be there before.

#include <foredraw/collapses/collapse_sequence.h>
#include <foredraw/collapses/joined_mesh.h>

#include <span>
#include <vector>

namespace foredraw {

inline constexpr std::uint32_t no_point = ~std::uint32_t{0};

/// Lists of numbers, one for each point, one behind the other.
struct PointLists {
  std::vector<std::uint32_t> first;  ///< [point], and the number of entries
  std::vector<std::uint32_t> entries;

  std::span<const std::uint32_t> of(std::uint32_t point) const {
    return std::span(entries).subspan(first[point], first[point + 1] - first[point]);
  }
};

/// Points are known by their first vertices, as in a CollapseSequence. A collapse makes the removed point a child of
/// the kept one. So what stands for a point in a coarse mesh is the nearest of its ancestors that is there.
struct SplitForest {
  std::vector<std::uint32_t> point_of;       ///< [vertex]
  std::vector<bool> is_proper;               ///< [triangle] of three points
  std::vector<std::uint32_t> parent;         ///< [point]; no_point: it is there from the beginning, or is none
  std::vector<std::uint32_t> parent_vertex;  ///< [vertex] that takes its place
  std::vector<std::uint32_t> collapse;       ///< [point] in which it goes
  std::vector<std::uint32_t> enter, leave;   ///< [point]: b lies below a if enter[a] <= enter[b] < leave[a]
  PointLists children;                       ///< as they split off, one after the other
  PointLists triangles;                      ///< [point] that come with it
  PointLists wings;                          ///< [point] between which it splits: the third points of these triangles
  std::vector<std::uint32_t> base;           ///< triangles that are there from the beginning

  bool is_below(std::uint32_t point, std::uint32_t ancestor) const {
    return enter[ancestor] <= enter[point] && enter[point] < leave[ancestor];
  }
};

/// Of a sequence that runs cleanly.
SplitForest split_forest(const JoinedMesh& mesh, const CollapseSequence& sequence);

}  // namespace foredraw
