#include <foredraw/scene/moves.h>

#include <algorithm>
#include <numeric>

namespace foredraw {

std::optional<std::vector<std::uint32_t>> vertex_moves(const Level& before, const Level& after) {
  std::vector<std::uint32_t> moves(before.vertices->count, no_vertex);
  const auto was = before.vertex_destination.view();  // both begin with the numbers in the file
  const auto is = after.vertex_destination.view();
  if (after.vertex_destination.is(before.vertex_destination)) {
    if (before.vertices->count != after.vertices->count) return std::nullopt;
    std::iota(moves.begin(), moves.end(), 0u);
    return moves;
  }
  if (is.empty() || (!was.empty() && was.size() != is.size()) || (was.empty() && is.size() != moves.size()))
    return std::nullopt;
  for (std::size_t file = 0; file < is.size(); ++file) {
    const std::uint32_t old = was.empty() ? static_cast<std::uint32_t>(file) : was[file];
    if (old == no_vertex) continue;
    if (old >= moves.size() || (is[file] != no_vertex && is[file] >= after.vertices->count)) return std::nullopt;
    moves[old] = is[file];
  }
  return moves;
}

std::optional<std::vector<std::uint32_t>> triangle_moves(const IndexStream& before, const IndexStream& after) {
  const std::size_t count = before.triangle_count();
  const auto was = before.triangle_origin.view(), is = after.triangle_origin.view();
  const bool are_known = (was.empty() || was.size() == count) && (is.empty() || is.size() == count);
  if (after.triangle_count() != count || !are_known) return std::nullopt;
  std::vector<std::uint32_t> number_after(count);  // [number in the file]
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!is.empty() && is[i] >= count) return std::nullopt;
    number_after[is.empty() ? i : is[i]] = i;
  }
  std::vector<std::uint32_t> moves(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!was.empty() && was[i] >= count) return std::nullopt;
    moves[i] = number_after[was.empty() ? i : was[i]];
  }
  return moves;
}

std::optional<std::vector<std::uint32_t>> moved_bounds(std::span<const std::uint32_t> bounds, const IndexStream& before,
                                                       const IndexStream& after) {
  constexpr std::uint32_t unknown = ~std::uint32_t{0};
  const auto was = before.triangle_origin.view(), is = after.triangle_origin.view();
  if (is.empty() && after.triangle_count() != before.triangle_count()) return std::nullopt;
  const std::size_t in_file = was.empty() ? before.triangle_count() : std::size_t{std::ranges::max(was)} + 1;
  std::vector<std::uint32_t> range_of(in_file, unknown);  // [number in the file]
  for (std::uint32_t i = 0; i < before.triangle_count(); ++i) {
    range_of[was.empty() ? i : was[i]] =
        static_cast<std::uint32_t>(std::ranges::upper_bound(bounds, i) - bounds.begin());
  }
  std::vector<std::uint32_t> moved;
  for (std::uint32_t i = 0; i < after.triangle_count(); ++i) {
    const std::uint32_t file = is.empty() ? i : is[i];
    const std::uint32_t range = file < in_file ? range_of[file] : unknown;
    if (range == unknown || range < moved.size()) return std::nullopt;
    moved.resize(range, i);
  }
  moved.resize(bounds.size(), static_cast<std::uint32_t>(after.triangle_count()));
  return moved;
}

std::uint32_t kept_first(std::uint32_t count, const IndexStream& before, const IndexStream& after) {
  const auto was = before.triangle_origin.view(), is = after.triangle_origin.view();
  if (is.empty() && after.triangle_count() != before.triangle_count()) return 0;
  std::vector<std::uint32_t> first;  // numbers in the file
  for (std::uint32_t i = 0; i < std::min<std::size_t>(count, before.triangle_count()); ++i) {
    first.push_back(was.empty() ? i : was[i]);
  }
  std::ranges::sort(first);
  std::uint32_t kept = 0;
  while (kept < after.triangle_count() && std::ranges::binary_search(first, is.empty() ? kept : is[kept])) ++kept;
  return kept;
}

}  // namespace foredraw
