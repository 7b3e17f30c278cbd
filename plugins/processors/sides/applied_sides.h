#pragma once
// What was chosen for a draw, done to the scene.

#include "sides.h"

#include <foredraw/scene/own_material.h>

#include <map>
#include <span>
#include <vector>

namespace foredraw::processors::sides {

/// The single-sided copy of a material, made once.
class SingleSidedMaterials {
 public:
  explicit SingleSidedMaterials(Scene& scene) : scene_(scene) {}

  MaterialId of(MaterialId material) {
    const auto [made, is_new] = made_.try_emplace(material, static_cast<MaterialId>(scene_.materials.size()));
    if (is_new) {
      Material copy = scene_.materials[material];
      copy.double_sided = false;
      copy.copy_of = material;
      change_look(copy, Stamp{0, 1});
      scene_.materials.push_back(std::move(copy));
    }
    return made->second;
  }

 private:
  Scene& scene_;
  std::map<MaterialId, MaterialId> made_;
};

/// `wanted`: [triangle] the sides that are drawn from now on, by copies where both are.
void make_single_sided(Scene& scene, DrawId id, std::span<const Side> wanted, SingleSidedMaterials& materials);

/// Two draws of one: what `stays` ([triangle]) stays double-sided, of the rest the sides in `wanted` are drawn. The new
/// draw is the double-sided one; it is the scene's last, and comes behind the old one in its meshes.
void split(Scene& scene, DrawId id, std::span<const Side> wanted, const std::vector<bool>& stays,
           SingleSidedMaterials& materials);

}  // namespace foredraw::processors::sides
