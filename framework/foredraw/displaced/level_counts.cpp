#include <foredraw/displaced/level_counts.h>

namespace foredraw {

std::uint64_t count_triangles(std::span<const TessellationLevels> levels, TessellationSpacing spacing) {
  std::uint64_t count = 0;
  for (const TessellationLevels& of : levels) count += tessellation_counts(of, spacing).triangles;
  return count;
}

std::vector<std::uint32_t> sources_of(std::span<const TessellationLevels> levels, TessellationSpacing spacing) {
  std::vector<std::uint32_t> sources;
  for (std::uint32_t t = 0; t < levels.size(); ++t)
    sources.insert(sources.end(), tessellation_counts(levels[t], spacing).triangles, t);
  return sources;
}

}  // namespace foredraw
