#pragma once
// Which triangles are walls of closed shells that are right side out, so that nobody outside sees a back first.

#include <foredraw/base/parallel.h>

#include <glm/vec3.hpp>

#include <atomic>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace foredraw::processors::second_depth {

enum class Kind : std::uint8_t {
  closed,      ///< and right side out
  open,        ///< an edge stands more often one way than the other
  flat,        ///< its walls lie on each other
  inside_out,  ///< it shows its backs
  turned,      ///< a part of it shows its back to the outside: it passes through itself, or is partly inside out
};

struct Limits {
  const Executor* executor = nullptr;         ///< null: one thread
  const std::atomic<bool>* cancel = nullptr;  ///< then what is answered means nothing
  std::function<void(double)> progress = {};  ///< 0 to 1, from any thread
};

/// [triangle] what its shell is. Triangles are of one shell where they share an edge that stands once each way among
/// all, and where only together they have an edge as often one way as the other. So shells that touch in a vertex or in
/// an edge are told apart, and boxes that share a wall are one.
///
/// A closed shell winds around every point a whole number of times, and a ray from outside meets its front first if
/// that number is nowhere below 0. That is asked in front of every triangle's centroid: a part that is smaller than all
/// triangles that bound it can be missed.
///
/// `positions` [vertex]; `points` [vertex]: equal ones are one vertex; `indices` three a triangle. Triangles with a
/// position that is not finite are open. O(n log n).
std::vector<Kind> kinds_of(std::span<const glm::vec3> positions, std::span<const std::uint32_t> points,
                           std::span<const std::uint32_t> indices, const Limits& limits = {});

}  // namespace foredraw::processors::second_depth
