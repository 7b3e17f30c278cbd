#pragma once
// Which way out of a heap of triangles is free: rays against a tree of boxes.

#include <foredraw/analysis/box_tree.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace foredraw {

/// From which sides a triangle blocks what comes at it. Its front is the side from which its corners run
/// counter-clockwise.
enum class Blocks : std::uint8_t { neither, front, back, both };

/// Triangles that block rays, in a tree of boxes. Only + - * / and comparisons of doubles, so that answers are the same
/// on every machine. O(n log n) to make, some 100 bytes a triangle; a question takes about O(log n).
class RayTree {
 public:
  /// Three indices a triangle, each below the number of positions; `blocks`: [triangle]. Triangles that are not finite,
  /// or that block nothing, are left out.
  RayTree(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices, std::span<const Blocks> blocks);

  /// A ray, of which the direction may have any length above 0, and is finite.
  struct Ray {
    glm::dvec3 from, direction;
    double nearest = 0;             ///< times the direction: what is not farther than that does not block
    std::uint32_t except = no_one;  ///< the number of a triangle that does not block: the one that the ray starts on
  };
  static constexpr std::uint32_t no_one = ~std::uint32_t{0};

  struct Hit {
    std::uint32_t triangle = 0;
    bool at_front = false;  ///< it shows its front to where the ray came from
    double way = 0;         ///< times the direction
  };

  /// Whether the ray leaves the heap unblocked, so that a camera out there sees where it began. What blocks at its
  /// front alone is in the way where that camera sees its front: where the ray comes out of it.
  ///
  /// The test is watertight: between two triangles that share an edge nothing passes. Source: Woop, Benthin, Wald,
  /// "Watertight Ray/Triangle Intersection", JCGT 2013.
  bool escapes(const Ray& ray) const;

  /// The nearest triangle in the way of somebody who looks along the ray; what blocks at its front alone is there where
  /// the ray comes in at its front. Of equally near ones that of the lowest number.
  std::optional<Hit> first(const Ray& ray) const;

  /// How many more backs than fronts the ray meets, whatever they block. In a heap of closed shells: how often these
  /// wind around where the ray begins, up to edges that the ray meets exactly.
  int winding(const Ray& ray) const;

 private:
  struct Triangle {
    glm::vec3 corners[3];
    std::uint32_t number;
    Blocks blocks;
  };

  /// Calls visit(triangle, faces the beginning, way) for what the ray meets; the answer is the way from which on
  /// nothing matters any more, below 0 to end.
  template <class Visit>
  void for_each_met(const Ray& ray, Visit visit) const;

  std::vector<BoxTree::Node> nodes_;
  std::vector<Triangle> triangles_;  ///< in the places of the tree's leaves
};

}  // namespace foredraw
