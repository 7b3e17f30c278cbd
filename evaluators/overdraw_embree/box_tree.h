#pragma once
// Which boxes does a ray meet? Embree's answer.

#include <foredraw/geometry/box.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>

namespace foredraw {

struct Ray {
  glm::vec3 from;
  glm::vec3 direction;  ///< unit length
  float length;
};

/// Boxes sorted into a tree. Any number of threads may ask at once.
class EmbreeBoxTree {
 public:
  /// O(n log n). Shared out over the threads of the Executor that this runs in, over all processors where there is
  /// none. Throws std::runtime_error where Embree refuses.
  explicit EmbreeBoxTree(std::span<const Box<glm::vec3>> boxes);

  /// Calls meet(i) once for each box that the ray meets, in any order. Embree computes in floats: where coordinates are
  /// c or less, a ray that passes within some c / 2^21 of a box's sides may be told of or not.
  template <class Meet>
  void for_each_met(const Ray& ray, Meet&& meet) const {
    trace(ray,
          {&meet, [](void* call, std::uint32_t box) { (*static_cast<std::remove_reference_t<Meet>*>(call))(box); }});
  }

 private:
  struct Call {
    void* call;
    void (*pass_on)(void* call, std::uint32_t box);
  };
  struct Query;
  struct Tree;

  void trace(const Ray& ray, const Call& call) const;

  std::shared_ptr<const Tree> tree_;
};

}  // namespace foredraw
