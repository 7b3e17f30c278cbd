#pragma once
// A surface of many triangles as few and their heights: what a tessellator needs to show it.
//
// N. Tatarchuk, J. Barczak, B. Purnomo: Real-Time Tessellation on GPU, SIGGRAPH 2008 course notes, bakes a map from a
// mesh of many triangles onto one of few. Here heights belong to the points that the tessellator makes, so that no
// texture coordinates are needed, no texel is wasted between charts, and nothing can tear along seams; triangles get as
// many of them as their surface needs.

#include "cast_heights.h"

#include <foredraw/displaced/baked_heights.h>

#include <optional>

namespace foredraw {

struct BakeOptions {
  double rms = 0;                     ///< wanted root mean square distance, in units
  std::uint32_t finest = 16;          ///< most parts of an edge, a power of two
  std::optional<std::uint32_t> bits;  ///< of a height, 1 to 16; none: so many that they cost 3 % of the error
  std::size_t samples = 20'000;
  std::uint64_t seed = 0;
};

/// Levels and heights as in DrawHeights, and what comes of them.
struct BakedCage {
  std::vector<std::uint8_t> levels;  ///< [triangle of the cage]
  std::vector<std::uint16_t> heights;
  std::uint32_t bits = 16;
  float factor = 1, offset = 0;
  std::vector<glm::vec3> positions;    ///< of the tessellated, displaced mesh
  std::vector<std::uint32_t> indices;  ///< of it
  double rms = 0, largest = 0;         ///< measured, both ways
};

/// Bakes a surface onto a cage: with the fewest heights that come within the rms, or as near as the cage allows.
BakedCage bake_heights(const processors::displacement_bake::Cage& cage,
                       const processors::displacement_bake::Target& target, const Surface& surface,
                       const BakeOptions& options, const Executor& executor);

/// Bytes on a GPU: positions of 16 bits, indices as narrow as they allow.
std::size_t mesh_bytes(std::size_t vertices, std::size_t triangles);
/// The same of a cage with its levels and heights.
std::size_t baked_bytes(std::size_t vertices, const BakedCage& baked);

struct Plugin;
Plugin displacement_bake_plugin();

}  // namespace foredraw
