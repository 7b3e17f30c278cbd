#include "split_forest.h"

#include <foredraw/analysis/welded_positions.h>

#include <algorithm>
#include <array>
#include <utility>

namespace foredraw {

namespace {

struct Entry {
  std::uint32_t point = 0, value = 0;
};

PointLists lists_of(const std::vector<Entry>& entries, std::size_t points) {
  PointLists lists;
  lists.first.resize(points + 1);
  for (const Entry& entry : entries) ++lists.first[entry.point + 1];
  for (std::size_t p = 0; p < points; ++p) lists.first[p + 1] += lists.first[p];
  lists.entries.resize(entries.size());
  std::vector<std::uint32_t> at(lists.first);
  for (const Entry& entry : entries) lists.entries[at[entry.point]++] = entry.value;
  return lists;
}

/// Runs the sequence, and writes down which triangles each collapse takes away.
void run_collapses(const JoinedMesh& mesh, const CollapseSequence& sequence, SplitForest& forest) {
  std::vector<std::uint32_t> corners;  // points
  for (const std::uint32_t vertex : mesh.indices) corners.push_back(forest.point_of[vertex]);
  std::vector<std::vector<std::uint32_t>> triangles_at(forest.point_of.size());
  for (std::uint32_t t = 0; t < forest.is_proper.size(); ++t) {
    const std::array three{corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]};
    forest.is_proper[t] = three[0] != three[1] && three[1] != three[2] && three[2] != three[0];
    for (std::size_t k = 0; forest.is_proper[t] && k < 3; ++k) triangles_at[three[k]].push_back(t);
  }
  std::vector<bool> is_gone(forest.is_proper.size(), false);
  std::vector<Entry> triangles, wings;
  for (std::uint32_t c = 0; c < sequence.collapses.size(); ++c) {
    const std::uint32_t removed = sequence.collapses[c].removed, kept = sequence.collapses[c].kept;
    forest.parent[removed] = kept;
    forest.collapse[removed] = c;
    for (std::uint32_t i = sequence.first_pair[c]; i < sequence.first_pair[c + 1]; ++i) {
      forest.parent_vertex[sequence.pairs[i].removed] = sequence.pairs[i].kept;
    }
    for (const std::uint32_t t : triangles_at[removed]) {
      if (is_gone[t]) continue;
      const std::span<std::uint32_t> three = std::span(corners).subspan(std::size_t{3} * t, 3);
      if (std::ranges::find(three, kept) == three.end()) {
        std::ranges::replace(three, removed, kept);
        triangles_at[kept].push_back(t);
        continue;
      }
      is_gone[t] = true;
      triangles.push_back({removed, t});
      for (const std::uint32_t point : three) {
        if (point != removed && point != kept) wings.push_back({removed, point});
      }
    }
    std::vector<std::uint32_t>().swap(triangles_at[removed]);
  }
  for (std::uint32_t t = 0; t < is_gone.size(); ++t) {
    if (forest.is_proper[t] && !is_gone[t]) forest.base.push_back(t);
  }
  forest.triangles = lists_of(triangles, forest.point_of.size());
  forest.wings = lists_of(wings, forest.point_of.size());
}

/// Numbers points so that those below one are numbered through.
void number_through(SplitForest& forest) {
  std::uint32_t number = 0;
  std::vector<std::pair<std::uint32_t, std::size_t>> path;  // and how many children have been seen
  for (std::uint32_t root = 0; root < forest.parent.size(); ++root) {
    if (forest.parent[root] != no_point || forest.point_of[root] != root) continue;
    forest.enter[root] = number++;
    path.emplace_back(root, 0);
    while (!path.empty()) {
      const std::uint32_t point = path.back().first;
      const auto children = forest.children.of(point);
      if (path.back().second == children.size()) {
        forest.leave[point] = number;
        path.pop_back();
        continue;
      }
      const std::uint32_t child = children[path.back().second++];
      forest.enter[child] = number++;
      path.emplace_back(child, 0);
    }
  }
}

}  // namespace

SplitForest split_forest(const JoinedMesh& mesh, const CollapseSequence& sequence) {
  SplitForest forest;
  forest.point_of = welded(mesh.positions);
  const std::size_t points = forest.point_of.size();
  forest.is_proper.resize(mesh.indices.size() / 3);
  forest.parent.assign(points, no_point);
  forest.parent_vertex.assign(points, no_point);
  forest.collapse.resize(points);
  forest.enter.resize(points);
  forest.leave.resize(points);
  run_collapses(mesh, sequence, forest);
  std::vector<Entry> children;
  for (std::size_t c = sequence.collapses.size(); c-- > 0;) {
    children.push_back({sequence.collapses[c].kept, sequence.collapses[c].removed});
  }
  forest.children = lists_of(children, points);
  number_through(forest);
  return forest;
}

}  // namespace foredraw
