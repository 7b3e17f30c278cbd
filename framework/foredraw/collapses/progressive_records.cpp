#include <foredraw/analysis/welded_positions.h>
#include <foredraw/collapses/progressive_records.h>

#include <algorithm>
#include <array>

namespace foredraw {

namespace {

constexpr std::uint32_t never = ~std::uint32_t{0};

/// A corner that another vertex takes in a collapse.
struct Change {
  std::uint32_t corner = 0;
  VertexPair pair;
};

/// What each collapse takes away, and which corners it changes.
struct Run {
  std::vector<std::uint32_t> end_of_vertex;    ///< [vertex] the collapse in which it goes, or `never`
  std::vector<std::uint32_t> end_of_triangle;  ///< [triangle]
  std::vector<Change> changes;
  std::vector<std::size_t> first_change;  ///< [collapse], and the number of changes
};

Run run_of(const CollapseSequence& sequence, const std::vector<std::uint32_t>& point_of,
           std::span<const std::uint32_t> indices, const std::vector<bool>& is_proper) {
  std::vector<std::uint32_t> corners(indices.begin(), indices.end());
  std::vector<std::vector<std::uint32_t>> triangles_at(point_of.size());
  for (std::uint32_t t = 0; t < is_proper.size(); ++t) {
    if (!is_proper[t]) continue;
    for (std::size_t k = 0; k < 3; ++k) triangles_at[point_of[corners[3 * t + k]]].push_back(t);
  }
  Run run{std::vector(point_of.size(), never), std::vector(is_proper.size(), never), {}, {0}};
  for (std::uint32_t c = 0; c < sequence.collapses.size(); ++c) {
    const std::uint32_t removed = sequence.collapses[c].removed, kept = sequence.collapses[c].kept;
    const auto pairs = std::span(sequence.pairs).first(sequence.first_pair[c + 1]).subspan(sequence.first_pair[c]);
    for (const std::uint32_t t : triangles_at[removed]) {
      if (run.end_of_triangle[t] != never) continue;
      const std::span<std::uint32_t> three = std::span(corners).subspan(std::size_t{3} * t, 3);
      if (std::ranges::any_of(three, [&](std::uint32_t v) { return point_of[v] == kept; })) {
        run.end_of_triangle[t] = c;
        continue;
      }
      for (std::uint32_t k = 0; k < 3; ++k) {
        const auto pair = std::ranges::find(pairs, three[k], &VertexPair::removed);
        if (pair == pairs.end()) continue;
        run.changes.push_back({3 * t + k, *pair});
        three[k] = pair->kept;
      }
      triangles_at[kept].push_back(t);
    }
    for (const VertexPair& pair : pairs) run.end_of_vertex[pair.removed] = c;
    std::vector<std::uint32_t>().swap(triangles_at[removed]);
    run.first_change.push_back(run.changes.size());
  }
  return run;
}

/// Of those that are there, what stays longest comes first; what goes together keeps its sequence.
std::vector<std::uint32_t> by_end(const std::vector<std::uint32_t>& end, const std::vector<bool>& is_there) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < end.size(); ++i) {
    if (is_there[i]) order.push_back(i);
  }
  std::ranges::stable_sort(order, std::greater<>(), [&](std::uint32_t i) { return end[i]; });
  return order;
}

std::vector<std::uint32_t> numbers_in(const std::vector<std::uint32_t>& order, std::size_t count) {
  std::vector<std::uint32_t> number(count, never);
  for (std::uint32_t i = 0; i < order.size(); ++i) number[order[i]] = i;
  return number;
}

/// How many of the ordered ones are still there after the collapse.
std::uint32_t left_after(const std::vector<std::uint32_t>& order, const std::vector<std::uint32_t>& end,
                         std::uint32_t collapse) {
  const auto behind = std::ranges::partition_point(order, [&](std::uint32_t i) { return end[i] > collapse; });
  return static_cast<std::uint32_t>(behind - order.begin());
}

}  // namespace

ProgressiveRecords progressive_records(const CollapseSequence& sequence, std::span<const glm::vec3> positions,
                                       std::span<const std::uint32_t> indices) {
  const std::vector<std::uint32_t> point_of = welded(positions);
  std::vector<bool> is_proper(indices.size() / 3), is_used(positions.size(), false);
  for (std::size_t t = 0; t < is_proper.size(); ++t) {
    const auto three = indices.subspan(3 * t, 3);
    const std::array points{point_of[three[0]], point_of[three[1]], point_of[three[2]]};
    is_proper[t] = points[0] != points[1] && points[1] != points[2] && points[2] != points[0];
    for (std::size_t k = 0; is_proper[t] && k < 3; ++k) is_used[three[k]] = true;
  }
  for (const VertexPair& pair : sequence.pairs) is_used[pair.kept] = true;
  const Run run = run_of(sequence, point_of, indices, is_proper);

  ProgressiveRecords made;
  made.vertex = by_end(run.end_of_vertex, is_used);
  made.triangle = by_end(run.end_of_triangle, is_proper);
  const std::vector<std::uint32_t> vertex = numbers_in(made.vertex, positions.size());
  const std::vector<std::uint32_t> triangle = numbers_in(made.triangle, is_proper.size());
  for (const std::uint32_t t : made.triangle) {
    for (std::size_t k = 0; k < 3; ++k) made.indices.push_back(vertex[indices[3 * t + k]]);
  }
  const auto put_split = [&](std::uint32_t vertices, std::uint32_t triangles, float error) {
    made.splits.push_back({vertices, triangles, static_cast<std::uint32_t>(made.patches.size()), error});
  };
  for (auto c = static_cast<std::uint32_t>(sequence.collapses.size()); c-- > 0;) {
    put_split(left_after(made.vertex, run.end_of_vertex, c), left_after(made.triangle, run.end_of_triangle, c),
              sequence.collapses[c].error);
    for (std::size_t i = run.first_change[c]; i < run.first_change[c + 1]; ++i) {
      const auto& [corner, pair] = run.changes[i];
      made.patches.push_back({3 * triangle[corner / 3] + corner % 3, vertex[pair.removed], vertex[pair.kept]});
    }
  }
  put_split(static_cast<std::uint32_t>(made.vertex.size()), static_cast<std::uint32_t>(made.triangle.size()), 0);
  return made;
}

}  // namespace foredraw
