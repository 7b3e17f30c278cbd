#include "all_sides.h"

#include <algorithm>

namespace foredraw::processors::sides {

AllSides::AllSides(std::span<const RasterPart> parts) : prepared_(prepared(parts)), fronts_(parts.size()) {
  const auto add = [&](std::size_t part, Side side) {
    what_.emplace_back(part, side);
    first_.push_back(first_.back() + static_cast<std::uint32_t>(parts[part].indices.size() / 3));
  };
  for (std::size_t part = 0; part < parts.size(); ++part) add(part, front);
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (parts[part].culls_back_faces) continue;
    prepared_[part].behind = first_.back() - first_[part];
    add(part, back);
  }
}

AllSides::Place AllSides::place_of(std::uint32_t number) const {
  const auto after = std::ranges::upper_bound(first_, number);
  const auto at = static_cast<std::size_t>(after - first_.begin()) - 1;
  return {what_[at].first, number - first_[at], what_[at].second};
}

std::vector<std::uint8_t> AllSides::among(const SidesOfParts& some) const {
  std::vector<std::uint8_t> result(count());
  for (std::size_t run = 0; run < what_.size(); ++run) {
    const auto [part, side] = what_[run];
    for (std::uint32_t t = 0; t < first_[run + 1] - first_[run]; ++t) {
      result[first_[run] + t] = (some[part][t] & side) != 0;
    }
  }
  return result;
}

SidesOfParts sides_of_parts(const Subject& subject, std::span<const RasterPart> parts,
                            const std::map<DrawId, std::vector<Side>>& wanted) {
  SidesOfParts result;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const std::size_t triangles = parts[part].indices.size() / 3;
    const auto of_draw = wanted.find(subject.parts[part].draw);
    if (of_draw != wanted.end() && triangles > 0) {
      result.push_back(of_draw->second);
    } else {
      result.emplace_back(triangles, parts[part].culls_back_faces ? front : both);
    }
  }
  return result;
}

}  // namespace foredraw::processors::sides
