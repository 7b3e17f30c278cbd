#include <foredraw/displaced/shared_edges.h>
#include <foredraw/displaced/tessellated_mesh.h>

#include <bit>
#include <limits>
#include <stdexcept>
#include <string>
#include <unordered_map>

namespace foredraw {

namespace {

void check(std::span<const std::uint32_t> indices, std::uint32_t vertices, std::size_t levels) {
  if (indices.size() != 3 * levels) {
    throw std::invalid_argument(std::to_string(indices.size()) + " indices for levels of " + std::to_string(levels) +
                                " triangles: expected three for each");
  }
  if (indices.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw std::length_error("more than 2^32 - 1 indices: tessellate the mesh in parts");
  }
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] < vertices) continue;
    throw std::invalid_argument("index " + std::to_string(i) + " names vertex " + std::to_string(indices[i]) +
                                ", but there are " + std::to_string(vertices));
  }
}

/// Patterns of levels that came before.
class KnownPatterns {
 public:
  explicit KnownPatterns(TessellationSpacing spacing) : spacing_(spacing) {}

  /// Of effective levels, valid until the next call.
  const TessellationPattern& of(const TessellationLevels& levels) {
    if (points_ > most_points) {
      patterns_.clear();
      points_ = 0;
    }
    const auto [found, is_new] = patterns_.try_emplace(levels);
    if (is_new) {
      found->second = tessellation_pattern(levels, spacing_);
      points_ += found->second.points.size() + overhead;
    }
    return found->second;
  }

 private:
  static constexpr std::size_t most_points = 4'000'000;  // a point comes with two triangles: 20 bytes
  static constexpr std::size_t overhead = 10;            // in points

  struct Hash {
    std::size_t operator()(const TessellationLevels& levels) const {
      std::uint64_t hash = 0;
      for (const float level : {levels.outer[0], levels.outer[1], levels.outer[2], levels.inner}) {
        hash = (std::rotl(hash, 23) ^ std::bit_cast<std::uint32_t>(level)) * 0x9e3779b97f4a7c15ull;
      }
      return hash ^ (hash >> 32);
    }
  };

  TessellationSpacing spacing_;
  std::unordered_map<TessellationLevels, TessellationPattern, Hash> patterns_;
  std::size_t points_ = 0;
};

std::optional<LevelDisagreement> disagreement(std::span<const std::uint32_t> first_edges,
                                              std::span<const TessellationLevels> levels, TessellationSpacing spacing) {
  for (std::size_t edge = 0; edge < first_edges.size(); ++edge) {
    const std::size_t first = first_edges[edge];
    if (first == edge) continue;
    const float ours = levels[edge / 3].outer[edge % 3], theirs = levels[first / 3].outer[first % 3];
    if (effective_level(ours, spacing) != effective_level(theirs, spacing)) return LevelDisagreement{edge, first};
  }
  return std::nullopt;
}

std::string told(const LevelDisagreement& found, std::span<const TessellationLevels> levels) {
  const auto edge = [&](std::size_t number) {
    return "edge " + std::to_string(number % 3) + " of triangle " + std::to_string(number / 3) + " has level " +
           std::to_string(levels[number / 3].outer[number % 3]);
  };
  return edge(found.edge) + ", but " + edge(found.other) +
         ", and they are the same edge: compute levels from its two vertices alone";
}

class MeshMaking {
 public:
  MeshMaking(std::span<const std::uint32_t> indices, std::uint32_t vertices, std::vector<std::uint32_t> first_edges,
             std::span<const TessellationLevels> levels, TessellationSpacing spacing)
      : indices_(indices),
        levels_(levels),
        spacing_(spacing),
        first_edges_(std::move(first_edges)),
        points_on_(indices.size(), no_points),
        patterns_(spacing) {
    mesh_.kept = vertices;
  }

  TessellatedMesh run() {
    reserve();
    for (std::uint32_t t = 0; t < levels_.size(); ++t) {
      const TessellationLevels levels = effective_levels(levels_[t], spacing_);
      if (levels.inner > 0) add(t, patterns_.of(levels));
    }
    return std::move(mesh_);
  }

 private:
  static constexpr std::uint32_t no_points = ~0u, points_to_come = no_points - 1;

  std::uint32_t parts(std::size_t edge) const {
    return EdgeDivision(effective_level(levels_[edge / 3].outer[edge % 3], spacing_), spacing_).parts();
  }

  void reserve() {
    std::uint64_t samples = 0, triangles = 0;
    for (std::size_t t = 0; t < levels_.size(); ++t) {
      const TessellationCounts counts = tessellation_counts(levels_[t], spacing_);
      triangles += counts.triangles;
      if (counts.triangles < 2) continue;
      samples += counts.points - 3;
      for (std::size_t edge = 3 * t; edge < 3 * t + 3; ++edge) {
        std::uint32_t& points = points_on_[first_edges_[edge]];
        if (points == points_to_come) samples -= parts(edge) - 1;  // counted before
        points = points_to_come;
      }
    }
    if (mesh_.kept + samples >= points_to_come) {
      throw std::length_error("the tessellated mesh would have more vertices than 32 bits number: lower its levels");
    }
    mesh_.samples.reserve(samples);
    mesh_.indices.reserve(3 * triangles);
  }

  std::uint32_t add_sample(std::uint32_t triangle, const TessellationPoint& at) {
    mesh_.samples.push_back({triangle, at});
    return static_cast<std::uint32_t>(mesh_.vertices() - 1);
  }

  /// Numbers the points within an edge, which are `points` seen from where it begins. They are kept in the sequence
  /// from the smaller vertex to the larger one.
  void add_edge(std::size_t edge, std::span<const TessellationPoint> points) {
    const EdgeEnds ends = edge_ends(indices_, edge);
    const bool is_reversed = ends.from > ends.to;
    const auto seen = [&](std::size_t i) { return is_reversed ? points.size() - 1 - i : i; };
    std::uint32_t& first = points_on_[first_edges_[edge]];
    if (first == points_to_come) {
      first = static_cast<std::uint32_t>(mesh_.vertices());
      for (std::size_t i = 0; i < points.size(); ++i) {
        add_sample(static_cast<std::uint32_t>(edge / 3), points[seen(i)]);
      }
    }
    for (std::size_t i = 0; i < points.size(); ++i) numbers_.push_back(first + static_cast<std::uint32_t>(seen(i)));
  }

  void add(std::uint32_t triangle, const TessellationPattern& pattern) {
    const std::size_t first_edge = std::size_t{3} * triangle;
    const std::span points(pattern.points);
    numbers_.assign(indices_.begin() + static_cast<std::ptrdiff_t>(first_edge),
                    indices_.begin() + static_cast<std::ptrdiff_t>(first_edge) + 3);
    if (points.size() > 3) {
      for (std::size_t e = 0; e < 3; ++e)
        add_edge(first_edge + e, points.subspan(numbers_.size(), parts(first_edge + e) - 1));
    }
    while (numbers_.size() < points.size()) numbers_.push_back(add_sample(triangle, points[numbers_.size()]));
    for (const auto& three : pattern.triangles) {
      for (const std::uint16_t point : three) mesh_.indices.push_back(numbers_[point]);
    }
  }

  std::span<const std::uint32_t> indices_;
  std::span<const TessellationLevels> levels_;
  TessellationSpacing spacing_;
  std::vector<std::uint32_t> first_edges_;  ///< [edge] of the source
  std::vector<std::uint32_t> points_on_;    ///< [first edge] the first vertex on it
  KnownPatterns patterns_;
  std::vector<std::uint32_t> numbers_;  ///< [point of a pattern] its vertex
  TessellatedMesh mesh_;
};

}  // namespace

std::optional<LevelDisagreement> level_disagreement(std::span<const std::uint32_t> indices, std::uint32_t vertices,
                                                    std::span<const TessellationLevels> levels,
                                                    TessellationSpacing spacing) {
  check(indices, vertices, levels.size());
  return disagreement(first_edges(indices, vertices), levels, spacing);
}

TessellatedMesh tessellated_mesh(std::span<const std::uint32_t> indices, std::uint32_t vertices,
                                 std::span<const TessellationLevels> levels, TessellationSpacing spacing) {
  check(indices, vertices, levels.size());
  std::vector<std::uint32_t> edges = first_edges(indices, vertices);
  if (const auto found = disagreement(edges, levels, spacing)) throw std::invalid_argument(told(*found, levels));
  return MeshMaking(indices, vertices, std::move(edges), levels, spacing).run();
}

}  // namespace foredraw
