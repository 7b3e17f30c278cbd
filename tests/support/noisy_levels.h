#pragma once
// Meshes with noise on them, and levels chosen for them.

#include "plugins/processors/tessellation_levels/tessellation_levels.h"
#include "support/noisy.h"

#include <foredraw/displaced/tessellation_pattern.h>

namespace foredraw::testing {

inline HeightPart part_of(const NoisyMesh& mesh, float factor = 1) {
  return {mesh.mesh.positions, mesh.mesh.indices, mesh.places, mesh.sampled, factor};
}

inline ChosenLevels chosen(const NoisyMesh& mesh, const TessellationLimits& limits,
                           LevelMethod method = LevelMethod::content, int threads = 2) {
  const HeightPart part = part_of(mesh);
  return tessellation_levels({&part, 1}, method, limits, Executor(threads));
}

inline NoisyMesh noisy_grid(std::uint32_t cells, std::uint32_t texels, std::uint64_t seed = 3) {
  TestMesh mesh = grid(cells, cells);
  auto uv = square_uv(mesh, static_cast<float>(cells), static_cast<float>(cells));
  return {std::move(mesh), uv, {texels, texels, noise(texels, seed)}};
}

inline NoisyMesh noisy_sphere(std::uint32_t slices = 24, std::uint32_t stacks = 16) {
  SeamedSphere sphere = seamed_sphere(slices, stacks);
  return {std::move(sphere.mesh), sphere.uv, {256, 256, noise(256, 9)}};
}

inline TessellationLevels parts_of(const LogLevels& levels) {
  const auto parts = [&](std::size_t i) { return static_cast<float>(1u << levels[i]); };
  return {{parts(0), parts(1), parts(2)}, parts(3)};
}

}  // namespace foredraw::testing
