#pragma once
// A tree of boxes, four side by side, that searches for triangles descend.

#include <foredraw/geometry/box.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace foredraw {

/// A register, in the words of gcc and clang.
using Four = float __attribute__((vector_size(16)));

inline Four four(const float (&of)[4]) {
  Four result;
  std::memcpy(&result, of, sizeof result);
  return result;
}

struct BoxTree {
  static constexpr std::size_t width = 4;
  /// Children that wait at once, at most, where each node's children wait while one of them is looked at: the tree is
  /// less than 64 nodes deep.
  static constexpr std::size_t most_waiting = (width - 1) * 64;

  using Box = foredraw::Box<glm::vec3>;

  /// Its children side by side: inner nodes, and leaves.
  struct Node {
    float planes[2][3][width];   ///< [low, high][axis][child] of its box; low above high where there is no child
    std::uint32_t first[width];  ///< number of a node; of a leaf its first place in `order`
    std::uint32_t count[width];  ///< places of a leaf, else 0
  };

  std::vector<Node> nodes;           ///< the first one is the root; none where there are no boxes
  std::vector<std::uint32_t> order;  ///< [place] = number of the box
};

/// Half the area of its surface; 0 if it is empty.
inline double half_area(const BoxTree::Box& box) {
  const glm::dvec3 size = glm::dvec3(box.max) - glm::dvec3(box.min);
  return size.x < 0 ? 0 : size.x * size.y + size.y * size.z + size.z * size.x;
}

/// The tree of these finite boxes. O(n log n); the same on every machine.
BoxTree box_tree(std::span<const BoxTree::Box> boxes, std::size_t most_in_leaf);

}  // namespace foredraw
