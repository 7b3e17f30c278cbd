#include "averaged_seams.h"

#include "is_cancelled.h"

#include <algorithm>
#include <cmath>

namespace foredraw::processors::displacement_seams {

namespace {

/// The texels of each point, one behind the other.
struct MeetingTexels {
  std::vector<std::size_t> starts{0};
  std::vector<std::uint32_t> texels;

  void add(glm::dvec2 uv, const foredraw_height_map& map) {
    const auto column = static_cast<std::int32_t>(std::floor(uv.x * map.width));
    const auto row = static_cast<std::int32_t>(std::floor(uv.y * map.height));
    const std::uint32_t x = foredraw_height_texel(column, map.width, map.wrap[0]);
    const std::uint32_t y = foredraw_height_texel(row, map.height, map.wrap[1]);
    texels.push_back(y * map.width + x);
  }
  void end_point() { starts.push_back(texels.size()); }
};

constexpr double longest_of_map = 4;

MeetingTexels meeting_texels(const SeamEdges& seams, const foredraw_height_map& map, const std::atomic<bool>* cancel) {
  MeetingTexels all;
  const glm::dvec2 size(map.width, map.height);
  const auto lies_near = [&](glm::vec2 uv) { return std::max(std::abs(uv.x), std::abs(uv.y)) < 4096; };
  for (const UvCorner& corner : seams.corners) {
    for (const glm::vec2 uv : seams.uvs_of(corner)) {
      if (lies_near(uv)) all.add(uv, map);
    }
    all.end_point();
  }
  for (const SharedEdge& edge : seams.edges) {
    if (is_cancelled(cancel)) break;
    const auto sides = seams.sides_of(edge);
    double longest = 1;
    bool is_near = true;
    for (const EdgeSide& side : sides) {
      const glm::dvec2 along = (glm::dvec2(side.uv[1]) - glm::dvec2(side.uv[0])) * size;
      longest = std::max(longest, std::sqrt(along.x * along.x + along.y * along.y));
      is_near = is_near && lies_near(side.uv[0]) && lies_near(side.uv[1]);
    }
    if (edge.kind != EdgeKind::seam || !is_near || longest > longest_of_map * std::max(size.x, size.y)) continue;
    const double steps = std::ceil(longest);
    for (double step = 0; step <= steps; ++step) {
      const double t = step / steps;
      for (const EdgeSide& side : sides) all.add((1 - t) * glm::dvec2(side.uv[0]) + t * glm::dvec2(side.uv[1]), map);
      all.end_point();
    }
  }
  return all;
}

}  // namespace

AveragedMap averaged_seams(const SeamEdges& seams, const foredraw_height_map& map, int iterations,
                           const std::atomic<bool>* cancel) {
  const MeetingTexels points = meeting_texels(seams, map, cancel);
  AveragedMap result;
  result.texels.assign(map.texels, map.texels + std::size_t{map.width} * map.height);
  for (int i = 0; i < iterations; ++i) {
    for (std::size_t p = 0; p + 1 < points.starts.size(); ++p) {
      if (p % 4096 == 0 && is_cancelled(cancel)) return result;
      const auto texels = std::span(points.texels).subspan(points.starts[p], points.starts[p + 1] - points.starts[p]);
      std::uint64_t sum = texels.size() / 2;  // halves are rounded up
      for (const std::uint32_t texel : texels) sum += result.texels[texel];
      for (const std::uint32_t texel : texels) result.texels[texel] = static_cast<std::uint16_t>(sum / texels.size());
    }
  }
  result.changed = points.texels;
  std::ranges::sort(result.changed);
  result.changed.erase(std::unique(result.changed.begin(), result.changed.end()), result.changed.end());
  std::erase_if(result.changed, [&](std::uint32_t texel) { return result.texels[texel] == map.texels[texel]; });
  return result;
}

}  // namespace foredraw::processors::displacement_seams
