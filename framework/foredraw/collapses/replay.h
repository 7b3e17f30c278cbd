#pragma once
// What becomes of a mesh as a sequence of collapses runs, and whether it may run at all.

#include <foredraw/collapses/collapse_sequence.h>

#include <glm/vec3.hpp>

#include <span>
#include <string>

namespace foredraw {

struct Replay {
  std::string mistake;                   ///< as the rest of a sentence; empty: it runs cleanly
  std::vector<std::uint32_t> triangles;  ///< [n] how many are left after n collapses; of a clean one
};

/// Runs all of it. `part[vertex]` says which vertices may take each other's place; none: all may. Sequences are refused
/// that name a point twice or one that is gone, that leave a corner without a vertex, whose errors fall or are not
/// finite, whose places are not finite, or whose points gather so many triangles that to run it would take for ever.
Replay replay(const CollapseSequence& sequence, std::span<const glm::vec3> positions,
              std::span<const std::uint32_t> indices, std::span<const std::uint32_t> part = {});

/// The mesh after some collapses.
struct Collapsed {
  std::vector<std::uint32_t> vertex;   ///< [vertex] = the one that stands for it; itself where it still stands
  std::vector<glm::vec3> places;       ///< [vertex] where it lies, if it still stands
  std::vector<std::uint32_t> indices;  ///< of the triangles that are left, in their sequence
  std::vector<std::uint32_t> origin;   ///< [triangle left] = which triangle it was
};

/// Of a clean sequence, after `collapses` of it, at most all.
Collapsed collapsed(const CollapseSequence& sequence, std::size_t collapses, std::span<const glm::vec3> positions,
                    std::span<const std::uint32_t> indices);

}  // namespace foredraw
