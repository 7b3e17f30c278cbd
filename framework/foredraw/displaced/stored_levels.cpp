#include <foredraw/displaced/stored_levels.h>

#include <foredraw/displaced/displaced_mesh.h>

#include <algorithm>

namespace foredraw {

std::vector<TessellationLevels> baked_levels(std::span<const std::uint8_t> logs, std::span<const std::uint32_t> indices,
                                             std::span<const glm::vec3> positions) {
  const auto level = [&](std::size_t t) { return static_cast<float>(1u << std::min(logs[t], most_log_level)); };
  const std::vector<std::uint32_t> first = edges_at_places(indices, positions);
  std::vector<float> sides(first.size(), 1);
  for (std::size_t side = 0; side < first.size(); ++side)
    sides[first[side]] = std::max(sides[first[side]], level(side / 3));
  std::vector<TessellationLevels> levels;
  for (std::size_t t = 0; t < logs.size(); ++t)
    levels.push_back({{sides[first[3 * t]], sides[first[3 * t + 1]], sides[first[3 * t + 2]]}, level(t)});
  return levels;
}

}  // namespace foredraw
