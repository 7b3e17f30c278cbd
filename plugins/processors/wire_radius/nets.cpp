#include "nets.h"

#include <foredraw/geometry/joined_sets.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <map>
#include <optional>

namespace foredraw::processors::wire_radius {

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

struct NetEdge {
  std::uint32_t point, other;
  double length;
  bool operator<(const NetEdge& than) const {
    return point != than.point ? point < than.point : length != than.length ? length < than.length : other < than.other;
  }
};

/// Of the edges of the net's triangles both directions, those of a point together, the shortest first.
std::vector<NetEdge> edges_of(const WeldedMesh& mesh, const Net& net) {
  std::vector<NetEdge> edges;
  for (const std::uint32_t t : net.parts.triangles) {
    for (std::size_t e = 0; e < 3; ++e) {
      const std::uint32_t a = mesh.triangles[t][e], b = mesh.triangles[t][(e + 1) % 3];
      const double length = glm::distance(mesh.points[a], mesh.points[b]);
      edges.push_back({a, b, length});
      edges.push_back({b, a, length});
    }
  }
  std::ranges::sort(edges, [](const NetEdge& a, const NetEdge& b) { return a < b; });
  return edges;
}

/// Across a triangle's ribbon: its shortest edge. Where ribbons cross, and two are as
/// long, the direction decides, so that both triangles of the crossing go with one ribbon.
glm::dvec3 breadth_of(const WeldedMesh& mesh, std::uint32_t triangle) {
  glm::dvec3 best(0);
  for (std::size_t e = 0; e < 3; ++e) {
    const glm::dvec3 edge =
        mesh.points[mesh.triangles[triangle][(e + 1) % 3]] - mesh.points[mesh.triangles[triangle][e]];
    const double length = glm::length(edge), least = glm::length(best);
    bool is_better = e == 0 || length < 0.99 * least;
    if (!is_better && length < 1.01 * least) {
      const glm::dvec3 a = glm::abs(edge) / length, b = glm::abs(best) / least;
      is_better = std::abs(a.x - b.x) > 1e-3 ? a.x > b.x : a.y > b.y;
    }
    if (is_better) best = edge;
  }
  return best;
}

/// A ribbon's centre line beside one of its triangles.
struct RibbonLine {
  glm::dvec3 centre, along, across;  ///< the directions of length 1
  double half_width;
};

/// Of a triangle that is longer than wide: along its border, or else its longest edge, and in the middle of what is cut
/// straight across. However ends are cut, and however many triangles lie side by side, that is the ribbon's own line.
std::optional<RibbonLine> line_beside(const WeldedMesh& mesh, std::uint32_t triangle, Cutter& cutter,
                                      double most_breadth) {
  constexpr double longer = 3;  // than wide
  constexpr std::size_t most_side_by_side = 64;
  const auto& corners = mesh.triangles[triangle];
  glm::dvec3 edges[3], longest(0), border(0);
  for (std::size_t e = 0; e < 3; ++e) {
    edges[e] = mesh.points[corners[(e + 1) % 3]] - mesh.points[corners[e]];
    if (glm::length(edges[e]) > glm::length(longest)) longest = edges[e];
    if (mesh.across[triangle][e] == none && glm::length(edges[e]) > glm::length(border)) border = edges[e];
  }
  const double length = glm::length(longest), doubled_area = glm::length(glm::cross(edges[0], edges[1]));
  if (!(length * length > longer * doubled_area)) return std::nullopt;
  const glm::dvec3 along = glm::normalize(2 * glm::length(border) > length ? border : longest);
  const glm::dvec3 middle = (mesh.points[corners[0]] + mesh.points[corners[1]] + mesh.points[corners[2]]) / 3.0;
  if (!cutter.cut(triangle, {middle, along}, most_side_by_side, most_breadth)) return std::nullopt;
  const Section& section = cutter.section();
  if (!section.is_flat() || !(section.greatest > 0)) return std::nullopt;
  return RibbonLine{section.centre, along, section.across, section.greatest};
}

/// In the middle of an edge that leads across: where ribbons cross.
WirePoint centred_on_edge(const WeldedMesh& mesh, std::uint32_t triangle, std::uint32_t point,
                          const std::vector<NetEdge>& edges) {
  const glm::dvec3 edge_across = breadth_of(mesh, triangle);
  const double least = glm::length(edge_across);
  const glm::dvec3& at = mesh.points[point];
  const auto first =
      std::ranges::lower_bound(edges, NetEdge{point, 0, 0}, [](const NetEdge& a, const NetEdge& b) { return a < b; });
  auto chosen = first;
  for (auto edge = first; edge != edges.end() && edge->point == point; ++edge) {
    const glm::dvec3 way = (mesh.points[edge->other] - at) / edge->length;
    if (edge->length > 2 * least) break;  // no longer across a ribbon
    if (std::abs(glm::dot(way, edge_across)) < 0.7 * least) continue;
    chosen = edge;
    break;
  }
  const glm::dvec3 across = (mesh.points[chosen->other] - at) / chosen->length;
  glm::dvec3 square(0);  // where the ribbon goes
  for (const std::uint32_t other : mesh.triangles[triangle]) {
    const glm::dvec3 way = mesh.points[other] - at;
    const glm::dvec3 aside = way - across * glm::dot(way, across);
    if (glm::dot(aside, aside) > glm::dot(square, square)) square = aside;
  }
  const double length = glm::length(square);
  return {point, across * (chosen->length / 2), length > 0 ? square / length : glm::dvec3(0), chosen->length / 2, true};
}

WirePoint centred_on_line(const WeldedMesh& mesh, std::uint32_t point, const RibbonLine& line) {
  // In the middle so short that nothing moves by it.
  const double across = glm::dot(line.centre - mesh.points[point], line.across), least = line.half_width / 1024;
  return {point, line.across * (std::abs(across) > least ? across : least), line.along, line.half_width, true};
}

/// A point has a centre for each ribbon that it belongs to.
class NetPoints {
 public:
  explicit NetPoints(Net& net) : net_(net) {}

  std::uint32_t number_of(const WirePoint& wanted) {
    std::vector<std::uint32_t>& known = known_[wanted.point];
    for (const std::uint32_t number : known) {
      const WirePoint& point = net_.parts.points[number];
      const bool is_same = std::abs(glm::dot(point.axis, wanted.axis)) > 0.9 &&
                           glm::distance(point.to_centre, wanted.to_centre) < 0.5 * wanted.half_width &&
                           std::abs(point.half_width - wanted.half_width) < 0.25 * wanted.half_width;
      if (is_same) return number;
    }
    known.push_back(static_cast<std::uint32_t>(net_.parts.points.size()));
    net_.parts.points.push_back(wanted);
    return known.back();
  }

 private:
  Net& net_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> known_;
};

void add_points(const WeldedMesh& mesh, Cutter& cutter, Net& net) {
  const std::vector<NetEdge> edges = edges_of(mesh, net);
  net.parts.corners.resize(net.parts.triangles.size());
  NetPoints points(net);
  std::vector<std::size_t> crossings;  // which follow the ribbons beside them
  for (std::size_t i = 0; i < net.parts.triangles.size(); ++i) {
    const std::uint32_t t = net.parts.triangles[i];
    const auto line = line_beside(mesh, t, cutter, 8 * net.half_width);
    if (!line) crossings.push_back(i);
    for (std::size_t c = 0; c < 3 && line; ++c) {
      net.parts.corners[i][c] = points.number_of(centred_on_line(mesh, mesh.triangles[t][c], *line));
    }
  }
  for (const std::size_t i : crossings) {
    const std::uint32_t t = net.parts.triangles[i];
    for (std::size_t c = 0; c < 3; ++c) {
      net.parts.corners[i][c] = points.number_of(centred_on_edge(mesh, t, mesh.triangles[t][c], edges));
    }
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
  Cutter cutter(mesh);
  for (Net& net : nets) add_points(mesh, cutter, net);
  std::erase_if(nets, [](const Net& net) { return !is_made_of_ribbons(net); });
  return nets;
}

}  // namespace foredraw::processors::wire_radius
