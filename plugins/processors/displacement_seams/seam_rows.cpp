#include "seam_rows.h"

#include <algorithm>
#include <cmath>

namespace foredraw::processors::displacement_seams {

namespace {

void add(EqualityRow& row, std::uint32_t texel, double weight) {
  if (weight == 0) return;
  std::uint32_t i = 0;
  while (i < row.count && row.texels[i] != texel) ++i;
  row.texels[i] = texel;
  row.weights[i] += weight;
  row.count = std::max(row.count, i + 1);
}

/// Without texels that both sides weigh alike.
bool is_of_any(EqualityRow& row) {
  std::uint32_t left = 0;
  for (std::uint32_t i = 0; i < row.count; ++i) {
    if (row.weights[i] == 0) continue;
    row.texels[left] = row.texels[i];
    row.weights[left++] = row.weights[i];
  }
  row.count = left;
  return left > 0;
}

void add_footprint(EqualityRow& row, const foredraw_height_map& map, glm::ivec2 place, double sign) {
  const foredraw_height_footprint at = foredraw_height_footprint_at(&map, place.x, place.y);
  for (std::uint32_t i = 0; i < 4; ++i) {
    add(row, at.row[i / 2] * map.width + at.column[i % 2], sign * at.weight[i] / 65536);
  }
}

double squared_gap(const EqualityRow& row, const foredraw_height_map& map) {
  double gap = 0;
  for (std::uint32_t i = 0; i < row.count; ++i) gap += row.weights[i] * map.texels[row.texels[i]];
  return gap * gap;
}

constexpr double wide_gap = 0.01 * 65535, least_strength = 1e-3;

/// Of rows of an edge, by its mean square gap: from 1, where it is wide, down as the gap is.
double strength(double mean_square) { return std::clamp(std::sqrt(mean_square) / wide_gap, least_strength, 1.0); }

void scale(std::span<EqualityRow> rows, double by) {
  for (EqualityRow& row : rows) {
    for (double& weight : row.weights) weight *= by;
  }
}

/// A side of an edge in units of texels, whose middles are at whole numbers.
struct TexelLine {
  glm::dvec2 from, along;

  TexelLine(const std::array<glm::vec2, 2>& uv, glm::dvec2 size)
      : from(glm::dvec2(uv[0]) * size - 0.5), along(glm::dvec2(uv[1]) * size - 0.5 - from) {}

  /// So that its texels have numbers.
  bool is_near() const {
    constexpr double most = 1 << 24;
    const glm::dvec2 to = from + along;
    return std::max({std::abs(from.x), std::abs(from.y), std::abs(to.x), std::abs(to.y)}) < most;
  }

  /// At most so many borders of texels lie on it.
  std::size_t most_crossings() const { return static_cast<std::size_t>(std::abs(along.x) + std::abs(along.y)) + 4; }

  double length() const { return std::sqrt(along.x * along.x + along.y * along.y); }

  /// Where it goes over to the next row or column.
  void add_crossings(std::vector<double>& to) const {
    for (int axis = 0; axis < 2; ++axis) {
      const double begin = from[axis], way = along[axis];
      if (way == 0) continue;
      const double last = std::floor(std::max(begin, begin + way));
      for (double at = std::ceil(std::min(begin, begin + way)); at <= last; ++at) {
        const double t = (at - begin) / way;
        if (t > 0 && t < 1) to.push_back(t);
      }
    }
  }

  /// The four texels at t, those that hold it at `inside`.
  void add_to(EqualityRow& row, const foredraw_height_map& map, double t, double inside, double scale) const {
    const glm::dvec2 cell(std::floor(from.x + inside * along.x), std::floor(from.y + inside * along.y));
    const glm::dvec2 part = from + t * along - cell;
    const auto column = static_cast<std::int32_t>(cell.x), line = static_cast<std::int32_t>(cell.y);
    for (std::int32_t i = 0; i < 4; ++i) {
      const std::uint32_t x = foredraw_height_texel(column + i % 2, map.width, map.wrap[0]);
      const std::uint32_t y = foredraw_height_texel(line + i / 2, map.height, map.wrap[1]);
      const double weight = (i % 2 == 1 ? part.x : 1 - part.x) * (i / 2 == 1 ? part.y : 1 - part.y);
      add(row, y * map.width + x, scale * weight);
    }
  }
};

/// Two sides of a seam: the uvs at the ends of the one, and of the other.
struct SidePair {
  std::array<std::array<glm::vec2, 2>, 2> uv;

  std::array<float, 8> key() const {
    return {uv[0][0].x, uv[0][0].y, uv[0][1].x, uv[0][1].y, uv[1][0].x, uv[1][0].y, uv[1][1].x, uv[1][1].y};
  }
};

/// Each once, whichever side comes first and whichever way round: layouts whose charts lie on each other have the same
/// ones many times.
std::vector<SidePair> side_pairs(const SeamEdges& seams) {
  std::vector<SidePair> pairs;
  for (const SharedEdge& edge : seams.edges) {
    const auto sides = seams.sides_of(edge);
    for (std::size_t side = 1; side < sides.size(); ++side) {
      const auto &a = sides[side - 1].uv, &b = sides[side].uv;
      if (a == b) continue;
      const std::array turned_a{a[1], a[0]}, turned_b{b[1], b[0]};
      const std::array ways{SidePair{{a, b}}, SidePair{{b, a}}, SidePair{{turned_a, turned_b}},
                            SidePair{{turned_b, turned_a}}};
      pairs.push_back(*std::ranges::min_element(ways, {}, &SidePair::key));
    }
  }
  std::ranges::sort(pairs, {}, &SidePair::key);
  pairs.erase(std::unique(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a.uv == b.uv; }),
              pairs.end());
  return pairs;
}

constexpr double most_of_map = 4, long_of_map = 1.0 / 8, most_stretch = 1.25;

constexpr std::array gauss_points{-0.7745966692414834, 0.0, 0.7745966692414834};  // of the square root of 3/5
constexpr std::array gauss_weights{5.0 / 18, 8.0 / 18, 5.0 / 18};

void add_rows_between(const TexelLine& a, const TexelLine& b, const foredraw_height_map& map,
                      std::vector<EqualityRow>& to) {
  std::vector<double> borders{0, 1};
  a.add_crossings(borders);
  b.add_crossings(borders);
  std::ranges::sort(borders);
  const double length = std::max(a.length(), b.length());
  const std::size_t first = to.size();
  double squares = 0, whole = 0;
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    const double half = (borders[i + 1] - borders[i]) / 2, middle = borders[i] + half;
    if (!(half > 1e-9)) continue;
    for (std::size_t g = 0; g < 3; ++g) {
      const double t = middle + gauss_points[g] * half;
      const double part = gauss_weights[g] * 2 * half * length, root = std::sqrt(part);
      EqualityRow row;
      a.add_to(row, map, t, middle, root);
      b.add_to(row, map, t, middle, -root);
      whole += part;
      if (!is_of_any(row)) continue;
      squares += squared_gap(row, map);
      to.push_back(row);
    }
  }
  if (to.size() > first) scale(std::span(to).subspan(first), std::sqrt(strength(squares / whole)));
}

}  // namespace

std::vector<EqualityRow> rows_of_points(const SeamPoints& points, const foredraw_height_map& map) {
  std::vector<EqualityRow> rows;
  rows.reserve(points.places.size() - points.points.size());
  for (const SeamPoint& point : points.points) {
    const auto places = points.places_of(point);
    for (std::size_t side = 1; side < places.size(); ++side) {
      EqualityRow row;
      add_footprint(row, map, places[side - 1], 1);
      add_footprint(row, map, places[side], -1);
      if (is_of_any(row)) rows.push_back(row);
    }
  }
  return rows;
}

std::vector<EqualityRow> rows_of_exact_points(const SeamEdges& seams, std::span<const std::uint32_t> factors,
                                              const foredraw_height_map& map) {
  std::vector<EqualityRow> rows;
  const glm::dvec2 size(map.width, map.height);
  for (std::size_t e = 0; e < seams.edges.size(); ++e) {
    const auto sides = seams.sides_of(seams.edges[e]);
    for (std::size_t side = 1; side < sides.size() && factors[e] > 0; ++side) {
      const TexelLine a(sides[side - 1].uv, size), b(sides[side].uv, size);
      if (!a.is_near() || !b.is_near()) continue;
      const std::size_t first = rows.size();
      double squares = 0;
      for (std::uint32_t step = 0; step <= factors[e]; ++step) {
        const double t = static_cast<double>(step) / factors[e];
        EqualityRow row;
        a.add_to(row, map, t, t, 1);
        b.add_to(row, map, t, t, -1);
        if (!is_of_any(row)) continue;
        squares += squared_gap(row, map);
        rows.push_back(row);
      }
      scale(std::span(rows).subspan(first), strength(squares / (factors[e] + 1)));
    }
  }
  return rows;
}

std::vector<EqualityRow> rows_along_seams(const SeamEdges& seams, const foredraw_height_map& map) {
  const glm::dvec2 size(map.width, map.height);
  std::vector<SidePair> pairs = side_pairs(seams);
  std::size_t most = 0;
  std::erase_if(pairs, [&](const SidePair& pair) {
    const TexelLine a(pair.uv[0], size), b(pair.uv[1], size);
    const auto [shorter, longer] = std::minmax({a.length(), b.length()});
    const double of_map = longer / std::max(size.x, size.y);
    const bool is_used = a.is_near() && b.is_near() && of_map <= most_of_map &&
                         (of_map <= long_of_map || longer <= most_stretch * shorter);
    if (is_used) most += 3 * (a.most_crossings() + b.most_crossings());
    return !is_used;
  });
  std::vector<EqualityRow> rows;
  rows.reserve(most);
  for (const SidePair& pair : pairs) add_rows_between({pair.uv[0], size}, {pair.uv[1], size}, map, rows);
  return rows;
}

std::vector<std::uint32_t> numbered(std::span<EqualityRow> rows, std::span<EqualityRow> more) {
  const auto for_each = [&](auto use) {
    for (const auto part : {rows, more}) {
      for (EqualityRow& row : part) {
        for (std::uint32_t i = 0; i < row.count; ++i) use(row.texels[i]);
      }
    }
  };
  std::vector<bool> is_named;
  for_each([&](std::uint32_t texel) {
    if (texel >= is_named.size()) is_named.resize(std::max<std::size_t>(texel + std::size_t{1}, 2 * is_named.size()));
    is_named[texel] = true;
  });
  std::vector<std::uint32_t> all;
  all.reserve(static_cast<std::size_t>(std::ranges::count(is_named, true)));
  for (std::size_t texel = 0; texel < is_named.size(); ++texel) {
    if (is_named[texel]) all.push_back(static_cast<std::uint32_t>(texel));
  }
  for_each([&](std::uint32_t& texel) {
    texel = static_cast<std::uint32_t>(std::ranges::lower_bound(all, texel) - all.begin());
  });
  return all;
}

}  // namespace foredraw::processors::displacement_seams
