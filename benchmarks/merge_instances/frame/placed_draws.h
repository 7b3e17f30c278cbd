#pragma once
// Everything that a scene shows, one by one.

#include <foredraw/instances/merged_instances.h>
#include <foredraw/scene/scene.h>

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw::bench {

/// A triangle list where a node puts it.
struct PlacedDraw {
  MergedPlace place;
  DrawId draw = 0;
  std::uint32_t group = 0;   ///< of merged draws, numbered through all of Scene::merged from 1 on; 0: of none
  bool is_mirrored = false;  ///< its placement turns it inside out, so that its front faces wind the other way
  glm::mat4 world{1};
};

/// Of all nodes, sorted by place, not by group. What has no indices or draws no triangles is left out.
std::vector<PlacedDraw> placed_draws(const Scene& scene);

/// The same in another sequence. Throws std::runtime_error where a place is not among `placed`, which are sorted by
/// place.
std::vector<PlacedDraw> in_sequence(std::span<const PlacedDraw> placed, std::span<const MergedPlace> sequence);

/// 12 bytes hashed to 4: for pictures that tell one placed primitive from all others.
std::uint32_t hash_of(const MergedPlace& place);

/// [material] a hash of how it looks, and one more at the end, for what has no material. Materials that look alike have
/// the same.
std::vector<std::uint32_t> hashes_of_looks(const Scene& scene);

/// Its place in hashes_of_looks().
std::uint32_t look_of(const Scene& scene, DrawId draw);

MergedTransform rows_of(const glm::mat4& world);

}  // namespace foredraw::bench
