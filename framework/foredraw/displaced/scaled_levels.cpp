#include <foredraw/displaced/scaled_levels.h>

#include <algorithm>

namespace foredraw {

std::vector<TessellationLevels> scaled_levels(const DrawTessellation& stored, std::uint32_t scale) {
  std::vector<TessellationLevels> levels;
  levels.reserve(stored.levels.size());
  for (const LogLevels& of : stored.levels.view()) {
    const auto parts = [&](std::size_t i) {
      return static_cast<float>(1u << (of[i] - std::min<std::uint32_t>(of[i], scale)));
    };
    levels.push_back({{parts(0), parts(1), parts(2)}, parts(3)});
  }
  return levels;
}

}  // namespace foredraw
