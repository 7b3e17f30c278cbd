#include <foredraw/analysis/mesh_facts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace foredraw {

namespace {

using Corners = std::array<std::uint32_t, 3>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

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

}  // namespace

bool is_finite(const glm::vec3& position) {
  return std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z);
}

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
  facts.non_finite_positions =
      static_cast<std::size_t>(std::count_if(positions.begin(), positions.end(), std::not_fn(is_finite)));

  std::vector<char> is_referenced(positions.size(), 0);
  std::vector<Corners> triangles;
  std::vector<Edge> edges;
  for (std::size_t t = 0; t < facts.triangles; ++t) {
    const auto [a, b, c] = Corners{indices[3 * t], indices[3 * t + 1], indices[3 * t + 2]};
    for (const std::uint32_t vertex : {a, b, c}) is_referenced[vertex] = 1;
    if (a == b || b == c || c == a) {
      ++facts.repeated_corners;
      continue;
    }
    triangles.push_back(rotated({a, b, c}));
    edges.insert(edges.end(), {std::minmax(a, b), std::minmax(b, c), std::minmax(c, a)});
    const bool finite = is_finite(positions[a]) && is_finite(positions[b]) && is_finite(positions[c]);
    if (finite && are_collinear(positions[a], positions[b], positions[c])) ++facts.zero_area;
  }
  facts.unreferenced_vertices = static_cast<std::size_t>(std::count(is_referenced.begin(), is_referenced.end(), 0));

  std::sort(triangles.begin(), triangles.end());
  for (std::size_t t = 1; t < triangles.size(); ++t) facts.duplicate_triangles += triangles[t] == triangles[t - 1];

  std::sort(edges.begin(), edges.end());
  for (auto first = edges.begin(); first != edges.end();) {
    const auto end = std::upper_bound(first, edges.end(), *first);
    facts.non_manifold_edges += end - first > 2;
    first = end;
  }
  return facts;
}

std::vector<std::pair<std::string_view, std::size_t>> named_counts(const MeshFacts& facts) {
  return {{"unreferenced-vertices", facts.unreferenced_vertices}, {"non-finite-positions", facts.non_finite_positions},
          {"repeated-corners", facts.repeated_corners},           {"zero-area", facts.zero_area},
          {"duplicate-triangles", facts.duplicate_triangles},     {"non-manifold-edges", facts.non_manifold_edges}};
}

}  // namespace foredraw
