#include "tipsify.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace foredraw {

namespace {

// A part is a run of triangles along a Z-curve through space, with vertices numbered anew in the sequence in which they
// first occur: so parts need nothing of each other, and whatever the walk through one touches lies together, in
// whatever sequence the draw's own vertices and triangles are.

constexpr int cell_bits = 5;  // of each axis
constexpr std::size_t cell_count = std::size_t{1} << (3 * cell_bits);
constexpr std::size_t fewest_triangles = 10000;  // below, a part takes longer to cut out than to order

struct Part {
  std::span<const std::uint32_t> triangles;  ///< of the draw
  std::size_t begin;                         ///< where its triangles go in the answer
};

/// The number of each vertex's cell along the Z-curve.
std::vector<std::uint16_t> cells_of(std::span<const float> positions) {
  using Place = std::array<double, 3>;  // double, for differences of floats may overflow
  const auto place = [&](std::size_t v) {
    const auto finite = [](float x) { return std::abs(x) <= std::numeric_limits<float>::max() ? double{x} : 0; };
    return Place{finite(positions[3 * v]), finite(positions[3 * v + 1]), finite(positions[3 * v + 2])};
  };
  const std::size_t vertex_count = positions.size() / 3;
  Place low = vertex_count == 0 ? Place{} : place(0);
  Place high = low;
  for (std::size_t v = 0; v < vertex_count; ++v) {
    const Place p = place(v);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
  const double extent = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  constexpr std::size_t along = 1 << cell_bits;
  const double cells_a_unit = extent > 0 ? along / extent : 0;

  std::array<unsigned, along + 1> spread{};  // a number's bits, two places apart
  for (unsigned i = 0; i < along; ++i) {
    for (int bit = 0; bit < cell_bits; ++bit) spread[i] |= (i >> bit & 1) << (3 * bit);
  }
  spread[along] = spread[along - 1];  // where the extent ends
  std::vector<std::uint16_t> cells(vertex_count);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    const Place p = place(v);
    unsigned cell = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cell |= spread[static_cast<std::size_t>((p[axis] - low[axis]) * cells_a_unit)] << axis;
    }
    cells[v] = static_cast<std::uint16_t>(cell);
  }
  return cells;
}

struct Curve {
  std::vector<std::uint32_t> triangles;  ///< along the Z-curve; in one cell as they came
  std::vector<std::uint32_t> cell_ends;  ///< where each cell's end among them
};

/// A triangle is in the first of its vertices' cells: so neighbouring parts meet along an even line.
Curve along_the_curve(std::span<const std::uint32_t> indices, std::span<const float> positions) {
  const std::vector<std::uint16_t> cell = cells_of(positions);
  std::vector<std::uint16_t> cell_of_triangle(indices.size() / 3);
  Curve curve{std::vector<std::uint32_t>(cell_of_triangle.size()), std::vector<std::uint32_t>(cell_count)};
  for (std::size_t t = 0; t < cell_of_triangle.size(); ++t) {
    cell_of_triangle[t] = std::min({cell[indices[3 * t]], cell[indices[3 * t + 1]], cell[indices[3 * t + 2]]});
    ++curve.cell_ends[cell_of_triangle[t]];
  }
  std::exclusive_scan(curve.cell_ends.begin(), curve.cell_ends.end(), curve.cell_ends.begin(), 0u);
  for (std::uint32_t t = 0; t < cell_of_triangle.size(); ++t) {
    curve.triangles[curve.cell_ends[cell_of_triangle[t]]++] = t;
  }
  return curve;
}

struct LocalMesh {
  std::vector<std::uint32_t> indices;   ///< three a triangle, into `vertices`
  std::vector<std::uint32_t> vertices;  ///< of the draw
};

LocalMesh cut_out(std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> indices,
                  std::size_t vertex_count) {
  constexpr std::uint32_t none = ~std::uint32_t{0};
  LocalMesh local;
  local.indices.resize(3 * triangles.size());
  local.vertices.reserve(triangles.size());
  std::vector<std::uint32_t> number(vertex_count, none);
  auto out = local.indices.begin();
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    __builtin_prefetch(&indices[3 * std::size_t{triangles[std::min(i + 32, triangles.size() - 1)]}]);
    for (const std::uint32_t v : indices.subspan(3 * std::size_t{triangles[i]}, 3)) {
      if (number[v] == none) {
        number[v] = static_cast<std::uint32_t>(local.vertices.size());
        local.vertices.push_back(v);
      }
      *out++ = number[v];
    }
  }
  return local;
}

/// Cuts, and calls work(part, its own mesh) for every part. No cell is cut: its triangles lie in no good order.
void for_each_part(std::span<const std::uint32_t> indices, std::span<const float> positions, std::size_t parts,
                   const ForEach& for_each, const std::function<void(const Part&, const LocalMesh&)>& work) {
  const Curve curve = along_the_curve(indices, positions);
  const auto cut = [&](std::size_t part) -> std::size_t {
    if (part == 0) return 0;
    return *std::ranges::lower_bound(curve.cell_ends, curve.triangles.size() * part / parts);
  };
  for_each(parts, [&](std::size_t part) {
    const std::span triangles = std::span(curve.triangles).subspan(cut(part), cut(part + 1) - cut(part));
    work({triangles, cut(part)}, cut_out(triangles, indices, positions.size() / 3));
  });
}

std::size_t parts_of(std::size_t triangles, int parts) {
  const auto most = static_cast<std::size_t>(std::max(parts, 1));
  return std::clamp(triangles / fewest_triangles, std::size_t{1}, most);
}

}  // namespace

std::vector<std::uint32_t> tipsify_parts(std::span<const std::uint32_t> indices, std::span<const float> positions,
                                         int parts_wanted, const TipsifyOptions& options, const ForEach& for_each) {
  const std::size_t parts = parts_of(indices.size() / 3, parts_wanted);
  if (parts == 1) return tipsify(indices, positions.size() / 3, options);
  std::vector<std::uint32_t> order(indices.size() / 3);
  for_each_part(indices, positions, parts, for_each, [&](const Part& part, const LocalMesh& mesh) {
    const std::span<std::uint32_t> out = std::span(order).subspan(part.begin, part.triangles.size());
    tipsify(out, mesh.indices, mesh.vertices.size(), options, *std::pmr::get_default_resource());
    for (std::uint32_t& triangle : out) triangle = part.triangles[triangle];
  });
  return order;
}

std::vector<std::uint32_t> tipsify_parts_indices(std::span<const std::uint32_t> indices,
                                                 std::span<const float> positions, int parts_wanted,
                                                 const TipsifyOptions& options, const ForEach& for_each) {
  const std::size_t parts = parts_of(indices.size() / 3, parts_wanted);
  if (parts == 1) return tipsify_indices(indices, positions.size() / 3, options);
  std::vector<std::uint32_t> ordered(indices.size());
  for_each_part(indices, positions, parts, for_each, [&](const Part& part, const LocalMesh& mesh) {
    const std::span<std::uint32_t> out = std::span(ordered).subspan(3 * part.begin, mesh.indices.size());
    tipsify_indices(out, mesh.indices, mesh.vertices.size(), options, *std::pmr::get_default_resource());
    for (std::uint32_t& v : out) v = mesh.vertices[v];
  });
  return ordered;
}

}  // namespace foredraw
