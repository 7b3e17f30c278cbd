#include "nets.h"

#include <foredraw/analysis/welded_positions.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <set>

namespace foredraw::wiring {

namespace {

/// Of a net: how often longer than wide all of it is, at least. A single rope is a ribbon.
constexpr double least_slenderness = 100;
constexpr std::size_t least_borders = 3;

struct Borders {
  double length = 0;
  std::vector<std::array<std::uint32_t, 2>> edges;
};

std::vector<Borders> borders_of(const WeldedMesh& mesh) {
  std::vector<Borders> borders(mesh.shell_area.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t e = 0; e < 3; ++e) {
      if (mesh.across[t][e] != none) continue;
      const std::uint32_t a = mesh.triangles[t][e], b = mesh.triangles[t][(e + 1) % 3];
      Borders& of = borders[mesh.shell[t]];
      of.length += glm::distance(mesh.points[a], mesh.points[b]);
      of.edges.push_back({a, b});
    }
  }
  return borders;
}

std::size_t loops_of(const Borders& borders) {
  std::vector<std::uint32_t> points;
  for (const auto& edge : borders.edges) points.insert(points.end(), edge.begin(), edge.end());
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto number = [&](std::uint32_t point) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(points, point) - points.begin());
  };
  JoinedSets sets(points.size());
  for (const auto& [a, b] : borders.edges) sets.join(number(a), number(b));
  std::size_t loops = 0;
  for (std::uint32_t i = 0; i < points.size(); ++i) loops += sets.of(i) == i;
  return loops;
}

void add_points(const WeldedMesh& mesh, Net& net) {
  struct Edge {
    std::uint32_t point, other;
    double length;
    bool operator<(const Edge& than) const {
      return point != than.point     ? point < than.point
             : length != than.length ? length < than.length
                                     : other < than.other;
    }
  };
  std::vector<Edge> edges;
  for (const std::uint32_t t : net.parts.triangles) {
    for (std::size_t e = 0; e < 3; ++e) {
      const std::uint32_t a = mesh.triangles[t][e], b = mesh.triangles[t][(e + 1) % 3];
      const double length = glm::distance(mesh.points[a], mesh.points[b]);
      edges.push_back({a, b, length});
      edges.push_back({b, a, length});
    }
  }
  std::ranges::sort(edges, [](const Edge& a, const Edge& b) { return a < b; });
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].point == edges[i].point) ++end;
    const glm::dvec3 &at = mesh.points[edges[i].point], &other = mesh.points[edges[i].other];
    const glm::dvec3 across = (other - at) / edges[i].length;
    glm::dvec3 square(0);  // where its ribbon goes, or one of those that cross here
    for (std::size_t e = i; e < end; ++e) {
      const glm::dvec3 way = mesh.points[edges[e].other] - at;
      const glm::dvec3 aside = way - across * glm::dot(way, across);
      if (glm::dot(aside, aside) > glm::dot(square, square)) square = aside;
    }
    const double length = glm::length(square);
    net.parts.points.push_back(
        {edges[i].point, (other - at) / 2.0, length > 0 ? square / length : glm::dvec3(0), edges[i].length / 2});
    i = end;
  }
}

/// Nearly all edges across are as short as a ribbon is wide.
bool is_made_of_ribbons(const Net& net) {
  const auto narrow = std::ranges::count_if(net.parts.points, [&](const WirePoint& p) {
    return p.half_width <= 2 * net.half_width && p.axis != glm::dvec3(0);
  });
  return 10 * static_cast<std::size_t>(narrow) >= 9 * net.parts.points.size();
}

}  // namespace

std::vector<Net> find_nets(const WeldedMesh& mesh) {
  const std::vector<Borders> borders = borders_of(mesh);
  std::vector<Net> nets;
  std::vector<std::uint32_t> net_of(borders.size(), none);
  for (std::uint32_t s = 0; s < borders.size(); ++s) {
    const double length = borders[s].length / 2, area = mesh.shell_area[s];
    if (!(area > 0) || !(length * length > least_slenderness * area) || loops_of(borders[s]) < least_borders) continue;
    net_of[s] = static_cast<std::uint32_t>(nets.size());
    nets.push_back({.shell = s, .length = length, .half_width = area / length / 2});
  }
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (const std::uint32_t n = net_of[mesh.shell[t]]; n != none) nets[n].parts.triangles.push_back(t);
  }
  for (Net& net : nets) add_points(mesh, net);
  std::erase_if(nets, [](const Net& net) { return !is_made_of_ribbons(net); });
  return nets;
}

}  // namespace foredraw::wiring
