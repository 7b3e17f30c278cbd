#include "surface.h"

#include <foredraw/analysis/closed_surfaces.h>
#include <foredraw/analysis/welded_positions.h>
#include <foredraw/geometry/joined_sets.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace foredraw::processors::sides {

namespace {

/// [number] the first entry that has it; and the end. `of` gives the number of an entry.
template <class Number>
std::vector<std::uint32_t> first_entries(std::size_t numbers, std::size_t entries, Number of) {
  std::vector<std::uint32_t> first(numbers + 1, 0);
  for (std::size_t i = 0; i < entries; ++i) ++first[of(i) + 1];
  for (std::size_t n = 0; n < numbers; ++n) first[n + 1] += first[n];
  return first;
}

std::vector<std::uint32_t> triangles_at_vertices(const Surface& surface) {
  std::vector<std::uint32_t> triangles(surface.indices.size());
  std::vector<std::uint32_t> to(surface.first_at.begin(), surface.first_at.end() - 1);
  for (std::uint32_t i = 0; i < surface.indices.size(); ++i) triangles[to[surface.indices[i]]++] = i / 3;
  return triangles;
}

std::vector<Surface::Edge> sorted_edges(std::span<const std::uint32_t> indices) {
  std::vector<Surface::Edge> edges;
  for (std::uint32_t i = 0; i < indices.size(); ++i) {
    const std::uint32_t from = indices[i], to = indices[i % 3 == 2 ? i - 2 : i + 1];
    if (from != to) edges.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1, i / 3});
  }
  std::ranges::sort(edges, {}, [](const Surface::Edge& e) { return std::tuple(e.low, e.high, e.triangle, e.way); });
  return edges;
}

/// Calls visit(edges, ends) for all that lie between the same two vertices; `ends`: the surface ends there.
template <class Visit>
void for_each_edge(const Surface& surface, Visit visit) {
  const std::span<const Surface::Edge> edges = surface.edges;
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    std::int32_t sum = 0;
    for (; end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high; ++end) {
      sum += edges[end].way;
    }
    visit(edges.subspan(begin, end - begin), sum != 0);
  }
}

void find_components(Surface& surface, std::size_t vertices) {
  JoinedSets bodies(vertices), holes(vertices);
  for (std::size_t i = 0; i < surface.indices.size(); ++i) {
    bodies.join(surface.indices[i], surface.indices[i - i % 3]);
  }
  std::vector<std::uint32_t> number(vertices, 0);  // [lowest vertex of a component]
  std::uint32_t components = 0;
  for (std::uint32_t v = 0; v < vertices; ++v) {
    if (bodies.of(v) == v) number[v] = components++;
  }
  for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
    surface.component.push_back(number[bodies.of(surface.indices[i])]);
  }
  for_each_edge(surface, [&](std::span<const Surface::Edge> same, bool ends) {
    if (!ends) return;
    surface.rims.push_back({same[0].low, same[0].high, 0});
    holes.join(same[0].low, same[0].high);
  });
  const auto body_of = [&](const Surface::Rim& rim) { return number[bodies.of(rim.low)]; };
  const auto hole_of = [&](const Surface::Rim& rim) { return holes.of(rim.low); };
  std::ranges::stable_sort(surface.rims, {},
                           [&](const Surface::Rim& rim) { return std::pair(body_of(rim), hole_of(rim)); });
  std::uint32_t opening = 0;
  for (std::size_t i = 0; i < surface.rims.size(); ++i) {
    opening += i > 0 && hole_of(surface.rims[i]) != hole_of(surface.rims[i - 1]);
    surface.rims[i].opening = opening;
  }
  const std::size_t count = surface.rims.size();
  surface.first_rim = first_entries(components, count, [&](std::size_t i) { return body_of(surface.rims[i]); });
  surface.first_of_hole =
      first_entries(std::size_t{opening} + 1, count, [&](std::size_t i) { return surface.rims[i].opening; });
}

}  // namespace

Surface surface_of(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
  Surface surface;
  const std::vector<std::uint32_t> at = welded(positions);
  for (std::size_t i = 0; i < indices.size() / 3 * 3; ++i) surface.indices.push_back(at[indices[i]]);
  surface.is_closed = closed_outwards(positions, indices);
  surface.first_at =
      first_entries(positions.size(), surface.indices.size(), [&](std::size_t i) { return surface.indices[i]; });
  surface.at_vertex = triangles_at_vertices(surface);
  surface.edges = sorted_edges(surface.indices);
  find_components(surface, positions.size());
  return surface;
}

void add_neighbours(const Surface& surface, std::span<Side> sides) {
  const std::vector<Side> before(sides.begin(), sides.end());
  for_each_edge(surface, [&](std::span<const Surface::Edge> same, bool) {
    std::uint8_t any = neither;
    for (const Surface::Edge& edge : same) any |= before[edge.triangle];
    for (const Surface::Edge& edge : same) sides[edge.triangle] = static_cast<Side>(sides[edge.triangle] | any);
  });
}

void smooth(const Surface& surface, std::span<double> values) {
  const std::vector<double> before(values.begin(), values.end());
  std::vector<double> count(values.size(), 1);
  for_each_edge(surface, [&](std::span<const Surface::Edge> same, bool) {
    double sum = 0;
    for (const Surface::Edge& edge : same) sum += before[edge.triangle];
    for (const Surface::Edge& edge : same) {
      values[edge.triangle] += sum - before[edge.triangle];
      count[edge.triangle] += static_cast<double>(same.size() - 1);
    }
  });
  for (std::size_t t = 0; t < values.size(); ++t) values[t] /= count[t];
}

void add_rims(const Surface& surface, std::span<Side> sides) {
  for_each_edge(surface, [&](std::span<const Surface::Edge> same, bool ends) {
    for (const Surface::Edge& edge : same) {
      if (ends) sides[edge.triangle] = both;
    }
  });
}

}  // namespace foredraw::processors::sides
