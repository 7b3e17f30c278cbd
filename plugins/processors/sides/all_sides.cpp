#include "all_sides.h"

#include <algorithm>
#include <deque>

namespace foredraw::sides {

AllSides::AllSides(std::span<const RasterPart> parts) {
  std::deque<std::vector<std::uint32_t>> reversed;
  std::vector<RasterPart> sided;
  const auto add = [&](std::size_t part, Side side, std::span<const std::uint32_t> indices) {
    RasterPart& one = sided.emplace_back(parts[part]);
    one.indices = indices;
    one.culls_back_faces = true;
    what_.emplace_back(part, side);
    first_.push_back(first_.back() + static_cast<std::uint32_t>(indices.size() / 3));
  };
  for (std::size_t part = 0; part < parts.size(); ++part) add(part, front, parts[part].indices);
  fronts_ = parts.size();
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (parts[part].culls_back_faces) continue;
    std::vector<std::uint32_t>& turned = reversed.emplace_back(parts[part].indices.begin(), parts[part].indices.end());
    for (std::size_t i = 0; i + 2 < turned.size(); i += 3) std::swap(turned[i + 1], turned[i + 2]);
    add(part, back, turned);
  }
  prepared_ = prepared(sided);
}

AllSides::Place AllSides::place_of(std::uint32_t number) const {
  const auto after = std::ranges::upper_bound(first_, number);
  const auto at = static_cast<std::size_t>(after - first_.begin()) - 1;
  return {what_[at].first, number - first_[at], what_[at].second};
}

}  // namespace foredraw::sides
