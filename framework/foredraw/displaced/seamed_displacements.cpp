#include <foredraw/displaced/seamed_displacements.h>

#include <foredraw/displaced/height_bits.h>

namespace foredraw {

std::vector<float> seamed_displacements(const TessellatedMesh& mesh, std::span<const std::uint32_t> source,
                                        std::span<const std::array<std::int32_t, 2>> places,
                                        const foredraw_height_map& map, float factor, float offset,
                                        const StoredSeams& seams) {
  const foredraw_seam_table table = seams.table();
  const std::span<const foredraw_seam_side> sides = seams.sides();
  std::vector<float> result;
  result.reserve(mesh.vertices());
  const auto add = [&](std::uint32_t height) {
    result.push_back(offset + factor * foredraw_height_part(height, height_bits));
  };
  for (std::uint32_t v = 0; v < mesh.kept; ++v)
    add(foredraw_displaced_height(&map, places[v][0], places[v][1], height_bits));
  for (const SurfaceSample& sample : mesh.samples) {
    std::int32_t x[3], y[3];
    for (std::size_t c = 0; c < 3; ++c) {
      const std::array<std::int32_t, 2>& place = places[source[3 * std::size_t{sample.triangle} + c]];
      x[c] = place[0];
      y[c] = place[1];
    }
    const std::array<std::uint32_t, 3> weights = sample.at.weights();
    add(foredraw_seamed_height(&map, &table, sides.data(), sides.size(), sample.triangle, x, y, weights.data(),
                               height_bits));
  }
  return result;
}

}  // namespace foredraw
