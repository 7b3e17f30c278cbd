#include <foredraw/analysis/mesh_facts.h>

#include <foredraw/geometry/finite.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <vector>

namespace foredraw {

namespace {

using Corners = std::array<std::uint32_t, 3>;

/// Values by the vertex that they belong to, each vertex's rising. `each` calls its argument with (vertex, value) for
/// all of them, and is asked twice.
template <class Value, class Each>
class ByVertex {
 public:
  ByVertex(std::size_t vertices, Each each) : first_(vertices + 1, 0) {
    each([&](std::uint32_t vertex, Value) { ++first_[vertex + 1]; });
    for (std::size_t v = 0; v < vertices; ++v) first_[v + 1] += first_[v];
    values_.resize(first_[vertices]);
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    each([&](std::uint32_t vertex, Value value) { values_[next[vertex]++] = value; });
    for (std::size_t v = 0; v < vertices; ++v) std::sort(begin(v), begin(v + 1));
  }

  /// Calls visit(how many) for each run of equal values of one vertex.
  template <class Visit>
  void each_run(Visit visit) {
    for (std::size_t v = 0; v + 1 < first_.size(); ++v) {
      for (auto first = begin(v); first != begin(v + 1);) {
        const auto end = std::find_if(first, begin(v + 1), [&](Value value) { return value != *first; });
        visit(static_cast<std::size_t>(end - first));
        first = end;
      }
    }
  }

 private:
  auto begin(std::size_t v) { return values_.begin() + first_[v]; }

  std::vector<std::uint32_t> first_;
  std::vector<Value> values_;
};

template <class Value, class Each>
ByVertex<Value, Each> by_vertex(std::size_t vertices, Each each) {
  return ByVertex<Value, Each>(vertices, each);
}

/// Whether the numbers sum to exactly 0: each is added to an expansion of numbers that do not overlap, which is 0 only
/// where all of its parts are (Shewchuk 1997, section 2.4).
bool sums_to_zero(const std::array<double, 6>& numbers) {
  std::array<double, 6> expansion = {};
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    double sum = numbers[n];
    for (std::size_t i = 0; i < n; ++i) {
      const double a = sum;
      const double b = expansion[i];
      sum = a + b;
      const double b_rounded = sum - a;
      expansion[i] = (a - (sum - b_rounded)) + (b - b_rounded);
    }
    expansion[n] = sum;
  }
  return std::all_of(expansion.begin(), expansion.end(), [](double part) { return part == 0; });
}

/// The smallest first, the turn kept.
Corners rotated(Corners corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

bool has_repeated_corners(const Corners& corners) {
  return corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
}

}  // namespace

bool are_collinear(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  // The shadow on each coordinate plane has no area. Products of two floats are exact in doubles.
  const auto has_no_shadow = [&](int x, int y) {
    const glm::dvec3 p(a), q(b), r(c);
    return sums_to_zero({p[x] * q[y], -(p[y] * q[x]), q[x] * r[y], -(q[y] * r[x]), r[x] * p[y], -(r[y] * p[x])});
  };
  return has_no_shadow(0, 1) && has_no_shadow(1, 2) && has_no_shadow(2, 0);
}

MeshFacts mesh_facts(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
  MeshFacts facts;
  facts.triangles = indices.size() / 3;
  facts.vertices = positions.size();
  facts.non_finite_positions = static_cast<std::size_t>(
      std::count_if(positions.begin(), positions.end(), [](const glm::vec3& p) { return !is_finite(p); }));

  std::vector<char> is_referenced(positions.size(), 0);
  for (std::size_t t = 0; t < facts.triangles; ++t) {
    const auto [a, b, c] = Corners{indices[3 * t], indices[3 * t + 1], indices[3 * t + 2]};
    for (const std::uint32_t vertex : {a, b, c}) is_referenced[vertex] = 1;
    if (has_repeated_corners({a, b, c})) {
      ++facts.repeated_corners;
      continue;
    }
    const bool finite = is_finite(positions[a]) && is_finite(positions[b]) && is_finite(positions[c]);
    if (finite && are_collinear(positions[a], positions[b], positions[c])) ++facts.zero_area;
  }
  facts.unreferenced_vertices = static_cast<std::size_t>(std::count(is_referenced.begin(), is_referenced.end(), 0));

  const auto each_triangle = [&](auto visit) {
    for (std::size_t t = 0; t < facts.triangles; ++t) {
      const Corners corners{indices[3 * t], indices[3 * t + 1], indices[3 * t + 2]};
      if (!has_repeated_corners(corners)) visit(corners);
    }
  };
  by_vertex<std::uint64_t>(positions.size(), [&](auto put) {
    each_triangle([&](const Corners& corners) {
      const auto [a, b, c] = rotated(corners);
      put(a, std::uint64_t{b} << 32 | c);
    });
  }).each_run([&](std::size_t equal) { facts.duplicate_triangles += equal - 1; });
  by_vertex<std::uint32_t>(positions.size(), [&](auto put) {
    each_triangle([&](const Corners& corners) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
        put(low, high);
      }
    });
  }).each_run([&](std::size_t equal) { facts.non_manifold_edges += equal > 2; });
  return facts;
}

std::vector<std::pair<std::string_view, std::size_t>> named_counts(const MeshFacts& facts) {
  return {{"unreferenced-vertices", facts.unreferenced_vertices}, {"non-finite-positions", facts.non_finite_positions},
          {"repeated-corners", facts.repeated_corners},           {"zero-area", facts.zero_area},
          {"duplicate-triangles", facts.duplicate_triangles},     {"non-manifold-edges", facts.non_manifold_edges}};
}

}  // namespace foredraw
