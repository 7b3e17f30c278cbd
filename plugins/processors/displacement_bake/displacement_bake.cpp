#include "displacement_bake.h"

#include "height_levels.h"

#include <foredraw/analysis/surface_distance.h>
#include <foredraw/displaced/displaced_mesh.h>
#include <foredraw/displaced/stored_levels.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

/// As many as keep the rounding of heights (a step over the root of 12, root mean square) below a quarter of the rms:
/// together they are then 3 % more than it alone.
std::uint32_t enough_bits(double range, double rms) {
  std::uint32_t bits = 1;
  while (bits < 16 && range > static_cast<double>((1u << bits) - 1) * std::sqrt(12.0) * rms / 4) ++bits;
  return bits;
}

/// Heights as whole numbers between the least and the greatest.
void quantize(std::span<const float> heights, const BakeOptions& options, BakedCage& baked) {
  const auto [least, most] = std::ranges::minmax(heights);
  baked.bits = options.bits.value_or(enough_bits(static_cast<double>(most) - least, options.rms));
  const double top = static_cast<double>((1u << baked.bits) - 1);
  baked.offset = least;
  baked.factor = most > least ? most - least : 1;
  for (const float height : heights) {
    const double part = (static_cast<double>(height) - baked.offset) / baked.factor;
    baked.heights.push_back(static_cast<std::uint16_t>(std::floor(std::clamp(part, 0.0, 1.0) * top + 0.5)));
  }
}

BakedCage baked_at(const processors::displacement_bake::Cage& cage, std::vector<std::uint8_t> levels,
                   const processors::displacement_bake::Target& target, const Surface& surface,
                   const BakeOptions& options, const Executor& executor) {
  BakedCage baked;
  baked.levels = std::move(levels);
  TessellatedMesh mesh =
      tessellated_mesh(cage.indices, static_cast<std::uint32_t>(cage.positions.size()),
                       baked_levels(baked.levels, cage.indices, cage.positions), TessellationSpacing::equal);
  quantize(processors::displacement_bake::cast_heights(cage, mesh, target, executor), options, baked);
  baked.positions = displaced_positions(mesh, cage.indices, cage.positions, cage.directions,
                                        height_displacements(baked.heights, baked.bits, baked.factor, baked.offset));
  baked.indices = std::move(mesh.indices);
  const auto distance = surface_distance(surface, {baked.positions, baked.indices},
                                         {.samples = options.samples, .seed = options.seed}, executor);
  baked.rms = distance ? distance->rms : INFINITY;
  baked.largest = distance ? distance->largest : INFINITY;
  return baked;
}

}  // namespace

BakedCage bake_heights(const processors::displacement_bake::Cage& cage,
                       const processors::displacement_bake::Target& target, const Surface& surface,
                       const BakeOptions& options, const Executor& executor) {
  const auto uniform = processors::displacement_bake::uniform_heights(cage, target, options.finest, executor);
  // What is predicted is the deviation along directions from the finest level. The true distance is less on slopes, and
  // more where even that level is too coarse; so it is measured, and asked for again.
  double asked = options.rms;
  BakedCage best;
  for (int round = 0; round < 4; ++round) {
    auto levels = processors::displacement_bake::levels_for(cage, uniform, asked);
    if (levels == best.levels) break;
    BakedCage baked = baked_at(cage, std::move(levels), target, surface, options, executor);
    const double times = baked.rms / options.rms;
    const bool is_smaller = times <= 1 && baked.heights.size() < best.heights.size();
    const bool is_better = best.rms > options.rms ? baked.rms < best.rms : is_smaller;
    if (round == 0 || is_better) best = std::move(baked);
    if (times <= 1 && times > 0.97) break;
    asked /= std::clamp(times, 0.25, 4.0);
  }
  return best;
}

std::size_t mesh_bytes(std::size_t vertices, std::size_t triangles) {
  return 6 * vertices + 3 * triangles * (vertices <= 65536 ? 2 : 4);
}

std::size_t baked_bytes(std::size_t vertices, const BakedCage& baked) {
  return mesh_bytes(vertices, baked.levels.size()) + baked.levels.size() + (baked.heights.size() * baked.bits + 7) / 8;
}

}  // namespace foredraw
