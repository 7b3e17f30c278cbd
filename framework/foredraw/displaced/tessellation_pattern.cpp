#include <foredraw/displaced/tessellation_pattern.h>

#include <algorithm>
#include <bit>
#include <utility>

namespace foredraw {

namespace {

constexpr TessellationPoint centre = {weight_one / 3, weight_one / 3};
constexpr std::uint32_t two_thirds = 2 * weight_one / 3;  // rounded down, as the centre's weights are
constexpr std::uint32_t half_places = 32;

bool is_one_triangle(const TessellationLevels& effective) { return effective == TessellationLevels{}; }

/// Levels grow by splitting parts. Half an edge has 32 places for parts; this is when the one at `place` comes: first
/// the one at the corner, then one in the middle of the others, then those in the middle of what is left, and so on.
std::uint32_t turn_of(std::uint32_t place) {
  return (place | half_places) >> (std::countr_zero(place | half_places) + 1);
}

TessellationPoint point_of(const std::array<std::uint32_t, 3>& weights) { return {weights[0], weights[1]}; }

/// A pattern of more than one triangle: rings around the centre, of which the outermost are the triangle's edges.
class PatternMaking {
 public:
  PatternMaking(const TessellationLevels& levels, TessellationSpacing spacing) : inner_(levels.inner, spacing) {
    for (std::size_t e = 0; e < 3; ++e) outer_[e] = EdgeDivision(levels.outer[e], spacing);
    const TessellationCounts counts = tessellation_counts(levels, spacing);
    pattern_.points.reserve(counts.points);
    pattern_.triangles.reserve(counts.triangles);
  }

  TessellationPattern run() {
    add_outer_points();
    std::uint32_t begin = static_cast<std::uint32_t>(pattern_.points.size());
    add_inner_points();
    for (std::size_t e = 0; e < 3; ++e) add_outer_strip(e, begin);
    std::uint32_t parts = inner_.parts() - 2;  // along a side of the ring that begins at `begin`
    for (; parts > 1; parts -= 2) {
      for (std::uint32_t e = 0; e < 3; ++e) add_inner_strip(e, begin, parts);
      begin += 3 * parts;
    }
    if (parts == 1) add(begin, begin + 1, begin + 2);
    return std::move(pattern_);
  }

 private:
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    pattern_.triangles.push_back(
        {static_cast<std::uint16_t>(a), static_cast<std::uint16_t>(b), static_cast<std::uint16_t>(c)});
  }

  void add_outer_points() {
    pattern_.points.insert(pattern_.points.end(), {{weight_one, 0}, {0, weight_one}, {0, 0}});
    for (std::size_t e = 0; e < 3; ++e) {
      first_[e] = static_cast<std::uint32_t>(pattern_.points.size());
      for (std::uint32_t i = 1; i < outer_[e].parts(); ++i) {
        std::array<std::uint32_t, 3> weights{};
        weights[(e + 1) % 3] = weight_one - outer_[e].place(i);
        weights[(e + 2) % 3] = outer_[e].place(i);
        pattern_.points.push_back(point_of(weights));
      }
    }
  }

  /// Ring by ring, each from corner 1 to 2 to 0.
  void add_inner_points() {
    const std::uint32_t parts = inner_.parts();
    for (std::uint32_t ring = 1; 2 * ring < parts; ++ring) {
      // The weight of the corner across: up to a third at the centre, where the inner division is at its middle.
      const std::uint32_t across = (inner_.place(ring) * two_thirds + weight_one / 2) / weight_one;
      const std::uint32_t aside = (across + 1) / 2;
      for (std::size_t e = 0; e < 3; ++e) {
        for (std::uint32_t i = ring; i < parts - ring; ++i) {
          std::array<std::uint32_t, 3> weights{};
          std::uint32_t &from = weights[(e + 1) % 3], &to = weights[(e + 2) % 3];
          weights[e] = across;
          // The third weight is what the other two leave.
          if (e == 1) {
            to = inner_.place(i) - aside;
            from = weight_one - across - to;
          } else {
            from = inner_.place(parts - i) - aside;
            to = weight_one - across - from;
          }
          pattern_.points.push_back(point_of(weights));
        }
      }
    }
    if (parts % 2 == 0) pattern_.points.push_back(centre);
  }

  /// Point i of edge e of the triangle.
  std::uint32_t on_edge(std::size_t e, std::uint32_t i) const {
    if (i == 0) return static_cast<std::uint32_t>((e + 1) % 3);
    if (i == outer_[e].parts()) return static_cast<std::uint32_t>((e + 2) % 3);
    return first_[e] + i - 1;
  }

  /// Point i of side e of a ring; rings of no parts are the centre.
  static std::uint32_t on_ring(std::uint32_t begin, std::uint32_t parts, std::uint32_t e, std::uint32_t i) {
    return parts == 0 ? begin : begin + (e * parts + i) % (3 * parts);
  }

  /// Between an edge of the triangle and the outermost ring inside, which have different numbers of parts: the parts of
  /// both come in their turn, as if all 64 were there.
  void add_outer_strip(std::size_t e, std::uint32_t begin) {
    const std::uint32_t outer_parts = outer_[e].parts(), inner_parts = inner_.parts();
    std::uint32_t o = 0, i = 0;
    const auto outer = [&](std::uint32_t ahead) { return on_edge(e, o + ahead); };
    const auto inner = [&](std::uint32_t ahead) {
      return on_ring(begin, inner_parts - 2, static_cast<std::uint32_t>(e), i + ahead);
    };
    const auto advance_outer = [&] {
      add(outer(0), outer(1), inner(0));
      ++o;
    };
    const auto advance_inner = [&] {
      add(outer(0), inner(1), inner(0));
      ++i;
    };
    // The ring lacks the parts at the corners.
    const auto outer_has = [&](std::uint32_t place) { return turn_of(place) < outer_parts / 2; };
    const auto inner_has = [&](std::uint32_t place) { return place > 0 && turn_of(place) < inner_parts / 2; };
    for (std::uint32_t place = 0; place < half_places; ++place) {
      if (inner_has(place)) advance_inner();
      if (outer_has(place)) advance_outer();
    }
    if (inner_parts % 2 == 1) advance_inner();
    if (outer_parts % 2 == 1) advance_outer();
    for (std::uint32_t place = half_places; place-- > 0;) {
      if (outer_has(place)) advance_outer();
      if (inner_has(place)) advance_inner();
    }
  }

  /// Between side e of a ring and that of the next one inside, which has two parts less.
  void add_inner_strip(std::uint32_t e, std::uint32_t begin, std::uint32_t parts) {
    const std::uint32_t inner_parts = parts - 2, inner_begin = begin + 3 * parts;
    const auto outer = [&](std::uint32_t i) { return on_ring(begin, parts, e, i); };
    const auto inner = [&](std::uint32_t i) { return on_ring(inner_begin, inner_parts, e, i); };
    add(outer(0), outer(1), inner(0));
    for (std::uint32_t i = 0; i < inner_parts; ++i) {
      if (i < (inner_parts + 1) / 2) {
        add(outer(i + 1), inner(i + 1), inner(i));
        add(outer(i + 1), outer(i + 2), inner(i + 1));
      } else {
        add(outer(i + 1), outer(i + 2), inner(i));
        add(outer(i + 2), inner(i + 1), inner(i));
      }
    }
    add(outer(parts - 1), outer(parts), inner(inner_parts));
  }

  std::array<EdgeDivision, 3> outer_;
  EdgeDivision inner_;
  std::array<std::uint32_t, 3> first_{};  ///< points within the edges
  TessellationPattern pattern_;
};

/// Of a ring with so many parts along a side, and all that lies in it.
TessellationCounts counts_inside(std::uint32_t parts) {
  const std::uint32_t rings = parts / 2;  // but the centre, point or triangle
  return {parts % 2 == 0 ? 1 + 3 * rings * (rings + 1) : 3 * (rings + 1) * (rings + 1), 3 * parts * parts / 2};
}

}  // namespace

TessellationLevels effective_levels(const TessellationLevels& levels, TessellationSpacing spacing) {
  TessellationLevels effective;
  for (std::size_t e = 0; e < 3; ++e) {
    effective.outer[e] = effective_level(levels.outer[e], spacing);
    if (effective.outer[e] == 0) return {{0, 0, 0}, 0};
  }
  effective.inner = effective_level(levels.inner > 0 ? levels.inner : 1, spacing);
  if (effective.inner == 1 && !is_one_triangle(effective)) {
    effective.inner = spacing == TessellationSpacing::equal ? 2 : 1 + 1.0f / weight_one;
  }
  return effective;
}

TessellationPattern tessellation_pattern(const TessellationLevels& levels, TessellationSpacing spacing) {
  const TessellationLevels effective = effective_levels(levels, spacing);
  if (effective.inner == 0) return {};
  if (is_one_triangle(effective)) return {{{weight_one, 0}, {0, weight_one}, {0, 0}}, {{0, 1, 2}}};
  return PatternMaking(effective, spacing).run();
}

TessellationCounts tessellation_counts(const TessellationLevels& levels, TessellationSpacing spacing) {
  const TessellationLevels effective = effective_levels(levels, spacing);
  if (effective.inner == 0) return {};
  if (is_one_triangle(effective)) return {3, 1};
  const std::uint32_t inner_parts = EdgeDivision(effective.inner, spacing).parts() - 2;
  TessellationCounts counts = counts_inside(inner_parts);
  counts.triangles += 3 * inner_parts;
  for (const float level : effective.outer) {
    const std::uint32_t parts = EdgeDivision(level, spacing).parts();
    counts.points += parts;
    counts.triangles += parts;
  }
  return counts;
}

}  // namespace foredraw
