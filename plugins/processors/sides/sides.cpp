#include "sides.h"

namespace foredraw {

SingleSided single_sided(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                         std::span<const processors::sides::Side> wanted) {
  constexpr std::uint32_t not_copied = ~std::uint32_t{0};
  SingleSided result;
  for (std::uint32_t t = 0; t < wanted.size(); ++t) {
    if (wanted[t] == processors::sides::back) continue;
    for (std::size_t c = 0; c < 3; ++c) result.indices.push_back(indices[3 * std::size_t{t} + c]);
    result.triangles.push_back(t);
  }
  std::vector<std::uint32_t> copy(vertex_count, not_copied);
  const auto copy_of = [&](std::uint32_t vertex) {
    if (copy[vertex] == not_copied) {
      copy[vertex] = static_cast<std::uint32_t>(vertex_count + result.copies.size());
      result.copies.push_back(vertex);
    }
    return copy[vertex];
  };
  for (std::uint32_t t = 0; t < wanted.size(); ++t) {
    if ((wanted[t] & processors::sides::back) == 0) continue;
    for (const std::size_t c : {0, 2, 1}) result.indices.push_back(copy_of(indices[3 * std::size_t{t} + c]));
    result.triangles.push_back(t);
    (wanted[t] == processors::sides::both ? result.added : result.turned) += 1;
  }
  return result;
}

}  // namespace foredraw
