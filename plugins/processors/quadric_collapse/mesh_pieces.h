#pragma once
// A mesh in pieces that lie together, so that each fits a processor's cache, and several can be worked on at once.

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw::processors::quadric_collapse {

/// Points by pieces. The pieces are the leaves of a balanced tree: two neighbours (0 and 1, 2 and 3 ...) are halves of
/// one thing.
struct MeshPieces {
  std::vector<std::uint32_t> points;  ///< by pieces, those of one as they came
  std::vector<std::uint32_t> first;   ///< [piece] in points, and their number behind the last
};

/// Halves the points at the middle of their longest side, until no part has more than `most`; all equally often. Which
/// pieces these are depends on the points alone.
MeshPieces mesh_pieces(std::span<const glm::vec3> points, std::size_t most);

}  // namespace foredraw::processors::quadric_collapse
