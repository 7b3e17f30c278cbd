#include <foredraw/analysis/welded_positions.h>
#include <foredraw/collapses/collapse_recorder.h>
#include <foredraw/geometry/finite.h>

#include <algorithm>
#include <limits>

namespace foredraw {

float blend_of(glm::vec3 kept, glm::vec3 removed, glm::vec3 place) {
  const auto dot = [](const glm::dvec3& a, const glm::dvec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
  const glm::dvec3 edge = glm::dvec3(removed) - glm::dvec3(kept), to = glm::dvec3(place) - glm::dvec3(kept);
  const double length = dot(edge, edge);
  return length > 0 ? static_cast<float>(std::clamp(dot(to, edge) / length, 0.0, 1.0)) : 0.0f;
}

CollapseRecorder::CollapseRecorder(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices)
    : triangles_at_(positions.size()),
      changes_(positions.size(), 0),
      marks_(positions.size(), 0),
      is_finite_(positions.size()) {
  const std::vector<std::uint32_t> point_of = welded(positions);
  for (std::size_t p = 0; p < positions.size(); ++p) {
    is_finite_[p] = foredraw::is_finite(positions[p]);
  }
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const Corners vertices{indices[i], indices[i + 1], indices[i + 2]};
    const Corners points{point_of[vertices[0]], point_of[vertices[1]], point_of[vertices[2]]};
    if (points[0] == points[1] || points[1] == points[2] || points[2] == points[0]) continue;
    for (const std::uint32_t p : points) triangles_at_[p].push_back(static_cast<std::uint32_t>(points_.size()));
    points_.push_back(points);
    vertices_.push_back(vertices);
  }
  left_ = points_.size();
  sequence_.first_pair.push_back(0);
}

bool CollapseRecorder::has(const Corners& corners, std::uint32_t point) {
  return corners[0] == point || corners[1] == point || corners[2] == point;
}

int CollapseRecorder::corner_of(const Corners& points, std::uint32_t point) {
  return points[0] == point ? 0 : points[1] == point ? 1 : 2;
}

std::size_t CollapseRecorder::triangles_of_edge(std::uint32_t p, std::uint32_t q) const {
  const bool from_p = triangles_at_[p].size() <= triangles_at_[q].size();
  const std::uint32_t other = from_p ? q : p;
  return static_cast<std::size_t>(
      std::ranges::count_if(triangles_at_[from_p ? p : q], [&](std::uint32_t t) { return has(points_[t], other); }));
}

void CollapseRecorder::find_shared(std::uint32_t p, std::uint32_t q) {
  shared_.clear();
  const bool from_p = triangles_at_[p].size() <= triangles_at_[q].size();
  const std::uint32_t other = from_p ? q : p;
  for (const std::uint32_t t : triangles_at_[from_p ? p : q]) {
    if (has(points_[t], other)) shared_.push_back(t);
  }
}

/// Whether some edge at p is of one triangle, or of more than two.
bool CollapseRecorder::is_border(std::uint32_t p) {
  // Each look counts one more, from a mark that no point has yet.
  const std::uint64_t none = mark_;
  mark_ += triangles_at_[p].size() + 1;
  for (const std::uint32_t t : triangles_at_[p]) {
    for (const std::uint32_t q : points_[t]) marks_[q] = std::max(marks_[q], none) + 1;
  }
  for (const std::uint32_t t : triangles_at_[p]) {
    for (const std::uint32_t q : points_[t]) {
      if (q != p && marks_[q] != none + 2) return true;
    }
  }
  return false;
}

bool CollapseRecorder::keeps_topology(std::uint32_t p, std::uint32_t q) {
  if (!is_finite_[p] || !is_finite_[q]) return false;
  find_shared(p, q);
  if (shared_.empty() || triangles_at_[p].size() + triangles_at_[q].size() == 2 * shared_.size()) return false;
  // Two borders that an edge of the inside joins would become one point of both.
  if (shared_.size() == 2 && is_border(p) && is_border(q)) return false;
  // What both points neighbour are the third corners of the triangles between them, and nothing else.
  const std::uint64_t of_p = ++mark_;
  for (const std::uint32_t t : triangles_at_[p]) {
    for (const std::uint32_t one : points_[t]) marks_[one] = of_p;
  }
  const std::uint64_t third = ++mark_;
  for (const std::uint32_t t : shared_) {
    for (const std::uint32_t one : points_[t]) marks_[one] = third;
  }
  for (const std::uint32_t t : triangles_at_[q]) {
    for (const std::uint32_t one : points_[t]) {
      if (marks_[one] == of_p) return false;
    }
  }
  // A triangle of q whose other corners p has too, as in a tetrahedron, would lie on one of p.
  for (const std::uint32_t t : triangles_at_[q]) {
    if (has(points_[t], p)) continue;
    const int k = corner_of(points_[t], q);
    const std::uint32_t a = points_[t][(k + 1) % 3], b = points_[t][(k + 2) % 3];
    if (marks_[a] != third || marks_[b] != third) continue;
    const auto lies_there = [&](std::uint32_t other) { return has(points_[other], a) && has(points_[other], b); };
    if (std::ranges::any_of(triangles_at_[p], lies_there)) return false;
  }
  return true;
}

bool CollapseRecorder::pairs_up(std::uint32_t removed, std::uint32_t kept) {
  pairs_.clear();
  find_shared(removed, kept);
  for (const std::uint32_t t : shared_) {
    const VertexPair pair{vertices_[t][corner_of(points_[t], removed)], vertices_[t][corner_of(points_[t], kept)]};
    bool is_new = true;
    for (const VertexPair& known : pairs_) {
      const bool same = known.removed == pair.removed, onto_same = known.kept == pair.kept;
      if (same != onto_same) return false;
      is_new = is_new && !same;
    }
    if (is_new) pairs_.push_back(pair);
  }
  return std::ranges::all_of(triangles_at_[removed], [&](std::uint32_t t) {
    const std::uint32_t vertex = vertices_[t][corner_of(points_[t], removed)];
    return std::ranges::find(pairs_, vertex, &VertexPair::removed) != pairs_.end();
  });
}

void CollapseRecorder::collapse(std::uint32_t removed, std::uint32_t kept, const JoinedPoint& joined) {
  const float before = sequence_.collapses.empty() ? 0.0f : sequence_.collapses.back().error;
  const double most = std::numeric_limits<float>::max();  // an error beyond floats is that
  const float error = std::max(before, static_cast<float>(std::min(joined.error, most)));
  sequence_.collapses.push_back({removed, kept, joined.blend, error});
  sequence_.pairs.insert(sequence_.pairs.end(), pairs_.begin(), pairs_.end());
  sequence_.first_pair.push_back(static_cast<std::uint32_t>(sequence_.pairs.size()));
  if (joined.place) {
    for (int k = 0; k < 3; ++k) sequence_.places.push_back((*joined.place)[k]);
  }
  for (const std::uint32_t t : triangles_at_[removed]) {
    if (has(points_[t], kept)) {
      --left_;
      for (const std::uint32_t p : points_[t]) {
        if (p != removed) std::erase(triangles_at_[p], t);
        ++changes_[p];
      }
      continue;
    }
    const int corner = corner_of(points_[t], removed);
    vertices_[t][corner] = std::ranges::find(pairs_, vertices_[t][corner], &VertexPair::removed)->kept;
    points_[t][corner] = kept;
    triangles_at_[kept].push_back(t);
  }
  std::vector<std::uint32_t>().swap(triangles_at_[removed]);
  for (const std::uint32_t t : triangles_at_[kept]) {
    for (const std::uint32_t p : points_[t]) ++changes_[p];
  }
}

CollapseSequence CollapseRecorder::take() { return std::move(sequence_); }

}  // namespace foredraw
