#pragma once
// A sequence of collapses, run for who carries along what vertices carry.

#include <foredraw/collapses/collapse_sequence.h>
#include <foredraw/collapses/wedge_shares.h>

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace foredraw {

/// A vertex of the kept point.
struct JoinedVertex {
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  std::uint32_t vertex = 0;
  std::uint32_t removed = none;         ///< that it stands for from now on; of several the first
  std::vector<WedgeShare> shares = {};  ///< of what it carries then; none: it is blended with the removed one, if any

  bool stands_for_another() const { return removed != none; }
};

/// Of a sequence that runs cleanly (replay()). Without triangles everything is blended.
class AttributeWalk {
 public:
  AttributeWalk(const CollapseSequence& sequence, std::span<const glm::vec3> positions,
                std::span<const std::uint32_t> indices);

  /// Runs the next collapse. All that changes by it, from what vertices carried before; until the next call.
  std::span<const JoinedVertex> next();

 private:
  static constexpr std::uint32_t none = JoinedVertex::none;
  struct WedgeFace {
    std::uint32_t triangle, wedge;  ///< the kept point's vertex that it has, or will have
  };

  std::span<const VertexPair> pairs() const;
  glm::vec3 place() const;
  bool has(std::uint32_t corner, std::uint32_t point) const;
  void put(std::uint32_t vertex, std::uint32_t removed);
  void find_shares();
  void join();

  const CollapseSequence& sequence_;
  std::size_t at_ = 0;                // which collapse is next
  std::vector<JoinedVertex> joined_;  // of which the first `count_` are in use
  std::size_t count_ = 0;
  // The rest only where attributes are solved for.
  std::vector<std::uint32_t> point_of_;             // [vertex]
  std::vector<glm::vec3> places_;                   // [point]
  std::vector<std::uint32_t> corners_;              // [corner] its vertex
  std::vector<std::uint32_t> first_, last_, next_;  // [point], [point], [corner]: the corners at a point
  std::vector<WedgeFace> faces_;
  WedgeShares shares_;
};

}  // namespace foredraw
