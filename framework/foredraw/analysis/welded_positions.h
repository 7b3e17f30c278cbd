#pragma once
// What hangs together: vertices at the same position are one, whatever else they have.

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// [vertex] the first one at the same position, bit by bit; of the two zeros one. O(n log n).
std::vector<std::uint32_t> welded(std::span<const glm::vec3> positions);

/// Sets that are joined one by one. Each is known by its smallest member.
class JoinedSets {
 public:
  explicit JoinedSets(std::size_t count);

  std::uint32_t of(std::uint32_t one);
  void join(std::uint32_t a, std::uint32_t b);

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace foredraw
