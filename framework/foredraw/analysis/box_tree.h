#pragma once
// A tree of boxes, four side by side, that searches for triangles descend.

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
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

  struct Box {
    glm::vec3 low = glm::vec3(std::numeric_limits<float>::infinity());
    glm::vec3 high = -low;

    void add(const glm::vec3& point) {
      low = glm::min(low, point);
      high = glm::max(high, point);
    }
    void add(const Box& box) {
      low = glm::min(low, box.low);
      high = glm::max(high, box.high);
    }
    double half_area() const {
      const glm::dvec3 size = glm::dvec3(high) - glm::dvec3(low);
      return size.x < 0 ? 0 : size.x * size.y + size.y * size.z + size.z * size.x;
    }
  };

  /// Its children side by side: inner nodes, and leaves.
  struct Node {
    float planes[2][3][width];   ///< [low, high][axis][child] of its box; low above high where there is no child
    std::uint32_t first[width];  ///< number of a node; of a leaf its first place in `order`
    std::uint32_t count[width];  ///< places of a leaf, else 0
  };

  std::vector<Node> nodes;           ///< the first one is the root; none where there are no boxes
  std::vector<std::uint32_t> order;  ///< [place] = number of the box
};

/// The tree of these finite boxes. O(n log n); the same on every machine.
BoxTree box_tree(std::span<const BoxTree::Box> boxes, std::size_t most_in_leaf);

}  // namespace foredraw
