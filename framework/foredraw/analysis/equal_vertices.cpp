#include <foredraw/analysis/equal_vertices.h>

#include <foredraw/analysis/vertex_rows.h>

#include <algorithm>
#include <bit>

namespace foredraw {

namespace {

/// Kept, so that draws that share their vertices share the work.
struct EqualVertices {
  static constexpr std::string_view name = "equal-vertices";
  std::vector<std::uint32_t> first;
  std::size_t bytes() const { return first.size() * sizeof(std::uint32_t); }
};

}  // namespace

std::vector<std::uint32_t> first_of_equals(const VertexStreams& vertices) {
  constexpr std::uint32_t none = ~std::uint32_t{0};
  const VertexRows rows(vertices);
  std::vector<std::uint32_t> slots(std::bit_ceil(2 * rows.size() + 1), none);  // open addressing, at most half full
  const std::size_t mask = slots.size() - 1;
  std::vector<std::uint32_t> first(rows.size());
  for (std::uint32_t v = 0; v < first.size(); ++v) {
    std::size_t at = content_hash(rows[v]).low & mask;
    while (slots[at] != none && !std::ranges::equal(rows[slots[at]], rows[v])) at = (at + 1) & mask;
    if (slots[at] == none) slots[at] = v;
    first[v] = slots[at];
  }
  return first;
}

std::size_t count_equal_vertices(const VertexStreams& vertices, std::span<const std::uint32_t> indices,
                                 Analyses& analyses) {
  const auto equals =
      analyses.get<EqualVertices>(vertices.stamp(), [&]() -> EqualVertices { return {first_of_equals(vertices)}; });
  std::vector<bool> is_used(vertices.count), stands(vertices.count);
  std::size_t used = 0, different = 0;
  for (const std::uint32_t v : indices) {
    const std::uint32_t first = equals->first[v];
    used += is_used[v] ? 0 : 1;
    different += stands[first] ? 0 : 1;
    is_used[v] = stands[first] = true;
  }
  return used - different;
}

}  // namespace foredraw
