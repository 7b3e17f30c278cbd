#pragma once
// Surfaces whose layouts are cut, maps for them, and a second opinion on what the maps say along the cuts: neither
// the edges nor the heights come from what is tested.

#include <foredraw/analysis/seam_edges.h>
#include <foredraw/base/random.h>
#include <foredraw/runtime/displaced_height.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace foredraw::testing {

struct Charts {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec2> uvs;
  std::vector<std::uint32_t> indices;

  UvMesh mesh() const { return {positions, uvs, indices}; }
  SeamEdges seams() const { return seam_edges(std::array{mesh()}); }
};

/// Where a chart lies: its middle, and where its two axes lead.
struct ChartPlace {
  glm::vec2 middle, along_u, along_v;
};

/// A sphere from a cube, each face a chart of n x n squares.
inline Charts cube_sphere(int n, const std::array<ChartPlace, 6>& places) {
  Charts charts;
  for (int face = 0; face < 6; ++face) {
    const auto base = static_cast<std::uint32_t>(charts.positions.size());
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) {
        glm::vec3 p(0);
        const int axis = face / 2;
        p[axis] = face % 2 == 0 ? float(n) : float(-n);
        p[(axis + 1) % 3] = float(2 * i - n);
        p[(axis + 2) % 3] = float(2 * j - n);
        charts.positions.push_back(p / std::sqrt(glm::dot(p, p)));
        const glm::vec2 at(float(2 * i - n) / float(n), float(2 * j - n) / float(n));
        charts.uvs.push_back(places[face].middle + at.x * places[face].along_u + at.y * places[face].along_v);
      }
    }
    const auto vertex = [&](int i, int j) { return base + static_cast<std::uint32_t>(j * (n + 1) + i); };
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
        if (face % 2 == 0) {
          charts.indices.insert(charts.indices.end(), {a, b, c, a, c, d});
        } else {
          charts.indices.insert(charts.indices.end(), {a, c, b, a, d, c});
        }
      }
    }
  }
  return charts;
}

/// Turned, mirrored, four times as long one way as the other, at the image's edge.
inline std::array<ChartPlace, 6> turned_places() {
  return {{{{.17f, .17f}, {.12f, .04f}, {-.04f, .12f}},
           {{.5f, .17f}, {-.11f, .03f}, {.03f, .11f}},
           {{.84f, .16f}, {.16f, 0}, {0, .16f}},
           {{.2f, .6f}, {.04f, .01f}, {-.04f, .16f}},
           {{.55f, .55f}, {.05f, .13f}, {.13f, -.05f}},
           {{.8f, .8f}, {.01f, .1f}, {-.12f, .02f}}}};
}

struct Map {
  std::uint32_t width = 1, height = 1;
  std::vector<std::uint16_t> texels;
  std::array<std::uint8_t, 2> wrap{FOREDRAW_HEIGHT_REPEAT, FOREDRAW_HEIGHT_REPEAT};
  bool is_nearest = false;

  foredraw_height_map view() const {
    return {texels.data(), width, height, {wrap[0], wrap[1]}, static_cast<std::uint8_t>(is_nearest)};
  }
};

inline Map noise_map(std::uint32_t width, std::uint32_t height, std::uint64_t seed, std::uint32_t most = 65535) {
  Map map{width, height, {}};
  Random random(seed);
  for (std::size_t i = 0; i < std::size_t{width} * height; ++i) {
    map.texels.push_back(static_cast<std::uint16_t>(random.below(most + 1)));
  }
  return map;
}

/// Rows and columns by walking there.
inline std::int64_t walked(std::int64_t at, std::int64_t size, std::uint8_t wrap) {
  while (at < 0 || at >= size) {
    if (wrap == FOREDRAW_HEIGHT_CLAMPED) return at < 0 ? 0 : size - 1;
    if (wrap == FOREDRAW_HEIGHT_REPEAT) at += at < 0 ? size : -size;
    if (wrap == FOREDRAW_HEIGHT_MIRRORED) at = at < 0 ? -1 - at : 2 * size - 1 - at;
  }
  return at;
}

/// A height by four texels (or one) at a place in texels, 0 to 65535.
inline double height_of(const Map& map, double u, double v) {
  const double shift = map.is_nearest ? 0 : 0.5;
  const double x = std::floor(u - shift), y = std::floor(v - shift);
  const auto texel = [&](double right, double down) -> double {
    const auto column = walked(static_cast<std::int64_t>(x + right), map.width, map.wrap[0]);
    const auto row = walked(static_cast<std::int64_t>(y + down), map.height, map.wrap[1]);
    return map.texels[static_cast<std::size_t>(row * map.width + column)];
  };
  if (map.is_nearest) return texel(0, 0);
  const double fx = u - shift - x, fy = v - shift - y;
  return (texel(0, 0) * (1 - fx) + texel(1, 0) * fx) * (1 - fy) + (texel(0, 1) * (1 - fx) + texel(1, 1) * fx) * fy;
}

using Point = std::array<float, 3>;
inline Point point_of(glm::vec3 p) { return {p.x + 0.f, p.y + 0.f, p.z + 0.f}; }

/// All edges by their ends, with the uvs of all their sides.
inline std::map<std::array<Point, 2>, std::vector<std::array<glm::vec2, 2>>> edges_of(const UvMesh& mesh) {
  std::map<std::array<Point, 2>, std::vector<std::array<glm::vec2, 2>>> edges;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::uint32_t a = mesh.indices[i], b = mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
    const Point p = point_of(mesh.positions[a]), q = point_of(mesh.positions[b]);
    if (p < q) edges[{p, q}].push_back({mesh.uvs[a], mesh.uvs[b]});
    if (q < p) edges[{q, p}].push_back({mesh.uvs[b], mesh.uvs[a]});
  }
  return edges;
}

inline double texel_length(const std::array<glm::vec2, 2>& side, const Map& map) {
  const glm::dvec2 along = (glm::dvec2(side[1]) - glm::dvec2(side[0])) * glm::dvec2(map.width, map.height);
  return std::sqrt(along.x * along.x + along.y * along.y);
}

struct Opinion {
  std::size_t edges = 0;
  std::size_t points = 0, unequal = 0;  ///< at the ends of edges and at their factors, an end once for each edge
  double largest = 0, rms = 0;          ///< at 201 points an edge, as part of 65535
  double at_factors = 0;                ///< the largest at k/factor, of heights that are not rounded
};

/// `bits` of heights at places in 1/256 texel, rounded half up between the ends as exact fractions.
inline Opinion opinion(const UvMesh& mesh, const Map& map, int bits = 14) {
  Opinion result;
  double squares = 0;
  for (const auto& edge : edges_of(mesh)) {
    const std::vector<std::array<glm::vec2, 2>>& sides = edge.second;
    const bool is_seam = std::ranges::any_of(sides, [&](const auto& side) { return side != sides.front(); });
    if (!is_seam) continue;
    ++result.edges;
    int factor = 64;
    for (const auto& side : sides) {
      while (factor > 1 && texel_length(side, map) < 1.5 * factor) factor /= 2;
    }
    for (int k = 0; k <= factor; ++k) {
      std::vector<double> heights;
      for (const auto& side : sides) {
        glm::dvec2 at;
        for (int axis = 0; axis < 2; ++axis) {
          const auto size = static_cast<float>(axis == 0 ? map.width : map.height);
          const double from = std::nearbyint(side[0][axis] * (256 * size)),
                       to = std::nearbyint(side[1][axis] * (256 * size));
          at[axis] = std::floor(from + (to - from) * k / factor + 0.5) / 256;
        }
        heights.push_back(std::floor(height_of(map, at.x, at.y) / (1 << (16 - bits))));
      }
      ++result.points;
      if (std::ranges::any_of(heights, [&](double h) { return h != heights.front(); })) ++result.unequal;
    }
    const auto gap_at = [&](double t) {
      double least = 65535, most = 0;
      for (const auto& side : sides) {
        const glm::dvec2 at = glm::dvec2(side[0]) + (glm::dvec2(side[1]) - glm::dvec2(side[0])) * t;
        const double height = height_of(map, at.x * map.width, at.y * map.height);
        least = std::min(least, height);
        most = std::max(most, height);
      }
      return (most - least) / 65535;
    };
    for (int k = 0; k <= 200; ++k) {
      const double gap = gap_at(k / 200.0);
      squares += gap * gap;
      result.largest = std::max(result.largest, gap);
    }
    for (int k = 0; k <= factor; ++k) result.at_factors = std::max(result.at_factors, gap_at(double(k) / factor));
  }
  result.rms = result.edges == 0 ? 0 : std::sqrt(squares / static_cast<double>(201 * result.edges));
  return result;
}

}  // namespace foredraw::testing
