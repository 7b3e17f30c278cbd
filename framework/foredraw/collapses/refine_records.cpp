#include <foredraw/analysis/welded_positions.h>
#include <foredraw/collapses/refine_records.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace foredraw {

namespace {

using Node = foredraw_refine_node;

/// [vertex of the mesh] the split that adds its point; from the number of splits on: a point of the base.
std::vector<std::uint32_t> points_of(const CollapseSequence& sequence, std::span<const glm::vec3> positions) {
  const auto splits = static_cast<std::uint32_t>(sequence.collapses.size());
  const std::vector<std::uint32_t> point_of = welded(positions);
  std::vector<std::uint32_t> number(point_of.size()), points;
  for (std::uint32_t p = 0; p < number.size(); ++p) number[p] = splits + p;
  for (std::uint32_t c = 0; c < splits; ++c) number[sequence.collapses[c].removed] = splits - 1 - c;
  for (const std::uint32_t p : point_of) points.push_back(number[p]);
  return points;
}

/// Everything within `reach` of the place, which is a position or an axis, lies within the reach of the other one then.
void widen(float* reach, const float* place, const float* other, double reach_of_other) {
  double square = 0;
  for (int k = 0; k < 3; ++k) square += (double{place[k]} - other[k]) * (double{place[k]} - other[k]);
  const double wide = (std::sqrt(square) + reach_of_other) * 1.000001;  // as floats round
  *reach = std::max(*reach, static_cast<float>(wide));
}

class Maker {
 public:
  Maker(RefineRecords& made, const CollapseSequence& sequence, std::span<const glm::vec3> positions)
      : made_(made), splits_(static_cast<std::uint32_t>(sequence.collapses.size())) {
    const std::vector<std::uint32_t> points = points_of(sequence, positions);
    for (const std::uint32_t v : made.progressive.vertex) {
      made.point.push_back(points[v]);
      place_.push_back(positions[v]);
    }
    made.points = splits_ + static_cast<std::uint32_t>(positions.size());
    made.nodes.assign(splits_ + std::size_t{1}, Node{splits_, splits_, splits_, 0, {}, 0, {}, 0});
    for (std::uint32_t s = 0; s < splits_; ++s) {
      const Collapse& collapse = sequence.collapses[splits_ - 1 - s];
      made.nodes[s].point = points[collapse.kept];
      for (int k = 0; k < 3; ++k) made.nodes[s].centre[k] = positions[collapse.removed][k];
    }
  }

  void make() {
    find_corners();
    find_surface();
    find_needs();
    count_borders();
    for (std::uint32_t s = splits_; s-- > 0;) put_below_parent(s);
  }

 private:
  const foredraw_split& split(std::uint32_t s) const { return made_.progressive.splits[s]; }
  std::span<const foredraw_patch> patches(std::uint32_t s) const {
    return std::span(made_.progressive.patches)
        .subspan(split(s).first_patch, split(s + 1).first_patch - split(s).first_patch);
  }
  std::array<std::uint32_t, 3> corners(const std::vector<std::uint32_t>& indices, std::uint32_t triangle) const {
    const std::size_t first = std::size_t{3} * triangle;
    return {indices[first], indices[first + 1], indices[first + 2]};
  }

  /// Runs all splits backwards.
  void find_corners() {
    made_.corners = made_.progressive.indices;
    for (std::uint32_t s = splits_; s-- > 0;) {
      for (const foredraw_patch& patch : patches(s)) made_.corners[patch.corner] = patch.coarse;
    }
  }

  void reach(std::uint32_t s, std::uint32_t vertex) {
    Node& node = made_.nodes[s];
    widen(&node.radius, node.centre, &place_[vertex].x, 0);
  }

  /// Balls and normals of the triangles of full detail around each point by itself.
  void find_surface() {
    const std::vector<std::uint32_t>& full = made_.progressive.indices;
    std::vector<glm::dvec3> normal(full.size() / 3), sum(splits_, glm::dvec3(0));
    const auto each_point = [&](auto visit) {
      for (std::uint32_t t = 0; t < normal.size(); ++t) {
        for (const std::uint32_t v : corners(full, t)) {
          if (made_.point[v] < splits_) visit(t, made_.point[v]);
        }
      }
    };
    for (std::uint32_t t = 0; t < normal.size(); ++t) {
      const auto [a, b, c] = corners(full, t);
      const glm::dvec3 ab = glm::dvec3(place_[b]) - glm::dvec3(place_[a]);
      const glm::dvec3 ac = glm::dvec3(place_[c]) - glm::dvec3(place_[a]);
      normal[t] = glm::dvec3(ab.y * ac.z - ab.z * ac.y, ab.z * ac.x - ab.x * ac.z, ab.x * ac.y - ab.y * ac.x);
    }
    const auto unit = [](const glm::dvec3& v) {
      const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
      return length > 0 && std::isfinite(length) ? v / length : glm::dvec3(0);
    };
    each_point([&](std::uint32_t t, std::uint32_t s) { sum[s] += normal[t]; });
    for (std::uint32_t s = 0; s < splits_; ++s) {
      const glm::dvec3 axis = unit(sum[s]);
      for (int k = 0; k < 3; ++k) made_.nodes[s].axis[k] = static_cast<float>(axis[k]);
    }
    each_point([&](std::uint32_t t, std::uint32_t s) {
      for (const std::uint32_t v : corners(full, t)) reach(s, v);
      const glm::vec3 of_triangle(unit(normal[t]));
      widen(&made_.nodes[s].spread, made_.nodes[s].axis, &of_triangle.x, 0);
    });
  }

  /// Runs all splits, so that what each one changes is seen as it is then.
  void find_needs() {
    std::vector<std::uint32_t> now = made_.corners, adds(now.size() / 3, splits_), needs;
    for (std::uint32_t s = 0; s < splits_; ++s) {
      needs = {made_.nodes[s].point};
      for (const foredraw_patch& patch : patches(s)) {
        now[patch.corner] = patch.fine;
        needs.push_back(adds[patch.corner / 3]);
        for (const std::uint32_t v : corners(now, patch.corner / 3)) reach(s, v);
      }
      for (std::uint32_t t = split(s).triangles; t < split(s + 1).triangles; ++t) {
        adds[t] = s;
        for (const std::uint32_t v : corners(now, t)) {
          needs.push_back(made_.point[v]);
          reach(s, v);
        }
      }
      std::erase_if(needs, [&](std::uint32_t need) { return need >= splits_ || need == s; });
      std::ranges::sort(needs);
      needs.erase(std::unique(needs.begin(), needs.end()), needs.end());
      made_.nodes[s].first_need = static_cast<std::uint32_t>(made_.needs.size());
      made_.needs.insert(made_.needs.end(), needs.begin(), needs.end());
    }
    made_.nodes[splits_].first_need = static_cast<std::uint32_t>(made_.needs.size());
  }

  void count_borders() {
    const std::vector<std::uint32_t>& full = made_.progressive.indices;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::size_t i = 0; i < full.size(); ++i) {
      const std::uint32_t next = full[i % 3 == 2 ? i - 2 : i + 1];
      edges.push_back(std::minmax(made_.point[full[i]], made_.point[next]));
    }
    std::ranges::sort(edges);
    for (auto at = edges.begin(); at != edges.end();) {
      const auto end = std::upper_bound(at, edges.end(), *at);
      made_.borders += (end - at) % 2 == 1 ? 1 : 0;
      at = end;
    }
  }

  void put_below_parent(std::uint32_t s) {
    Node& node = made_.nodes[s];
    Node& parent = made_.nodes[std::min(node.point, splits_)];
    node.next_sibling = parent.first_child;
    parent.first_child = s;
    if (node.point >= splits_) return;
    widen(&parent.radius, parent.centre, node.centre, node.radius);
    widen(&parent.spread, parent.axis, node.axis, node.spread);
  }

  RefineRecords& made_;
  std::uint32_t splits_;
  std::vector<glm::vec3> place_;  ///< [vertex of the records]
};

}  // namespace

foredraw_refine_mesh RefineRecords::mesh() const {
  return {progressive.splits.data(),
          nodes.data(),
          static_cast<std::uint32_t>(nodes.size() - 1),
          progressive.patches.data(),
          needs.data(),
          corners.data(),
          static_cast<std::uint32_t>(progressive.triangle.size())};
}

foredraw_refine_arrays RefineRecords::arrays() const {
  return {point.data(),
          static_cast<std::uint32_t>(point.size()),
          points,
          static_cast<std::uint32_t>(progressive.patches.size()),
          static_cast<std::uint32_t>(needs.size()),
          borders};
}

RefineRecords refine_records(const CollapseSequence& sequence, std::span<const glm::vec3> positions,
                             std::span<const std::uint32_t> indices) {
  RefineRecords made{progressive_records(sequence, positions, indices), {}, {}, {}, {}, 0, 0};
  Maker(made, sequence, positions).make();
  return made;
}

}  // namespace foredraw
