#include "connected.h"

#include <foredraw/analysis/welded_positions.h>
#include <foredraw/geometry/joined_sets.h>

namespace foredraw::processors::hidden {

Connected::Connected(std::span<const RasterPart> parts) {
  std::vector<glm::vec3> positions;
  for (const RasterPart& part : parts) {
    const auto base = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), part.positions.begin(), part.positions.end());
    for (const std::uint32_t index : part.indices.first(part.indices.size() / 3 * 3)) corners_.push_back(base + index);
  }
  vertices_ = positions.size();
  const std::vector<std::uint32_t> first = welded(positions);
  for (std::uint32_t& corner : corners_) corner = first[corner];
  JoinedSets sets(vertices_);
  for (std::size_t i = 0; i < corners_.size(); i += 3) {
    sets.join(corners_[i], corners_[i + 1]);
    sets.join(corners_[i], corners_[i + 2]);
  }
  constexpr std::uint32_t none = ~std::uint32_t{0};
  std::vector<std::uint32_t> number(vertices_, none);
  for (std::size_t i = 0; i < corners_.size(); i += 3) {
    std::uint32_t& its = number[sets.of(corners_[i])];
    if (its == none) its = static_cast<std::uint32_t>(components_++);
    component_.push_back(its);
  }
}

Flags Connected::with_components(const Flags& flags) const {
  Flags is_touched(components_, 0);
  for (std::size_t t = 0; t < component_.size(); ++t) is_touched[component_[t]] |= flags[t];
  Flags result(component_.size());
  for (std::size_t t = 0; t < component_.size(); ++t) result[t] = is_touched[component_[t]];
  return result;
}

Flags Connected::with_rings(Flags flags, int rings) const {
  for (int ring = 0; ring < rings; ++ring) {
    Flags is_touched(vertices_, 0);
    for (std::size_t i = 0; i < corners_.size(); ++i) is_touched[corners_[i]] |= flags[i / 3];
    for (std::size_t i = 0; i < corners_.size(); ++i) flags[i / 3] |= is_touched[corners_[i]];
  }
  return flags;
}

}  // namespace foredraw::processors::hidden
