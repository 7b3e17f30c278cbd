#include <foredraw/collapses/collapse_sequences.h>

#include <algorithm>

namespace foredraw {

std::vector<DrawsCollapse> sequences_of(const Scene& scene, std::span<const DrawId> draws) {
  std::vector<DrawsCollapse> found;
  const CollapseSequences* all = scene.products.find<CollapseSequences>();
  if (all == nullptr) return found;
  for (const DrawsCollapse& mesh : all->meshes) {
    const bool are_all_here =
        std::ranges::all_of(mesh.draws, [&](DrawId id) { return std::ranges::binary_search(draws, id); });
    if (are_all_here) found.push_back(mesh);
  }
  return found;
}

void remove_sequences(Scene& scene, std::span<const DrawsCollapse> used_up) {
  const CollapseSequences* all = scene.products.find<CollapseSequences>();
  if (all == nullptr || used_up.empty()) return;
  CollapseSequences left;
  for (const DrawsCollapse& mesh : all->meshes) {
    if (std::ranges::find(used_up, mesh.sequence, &DrawsCollapse::sequence) == used_up.end()) {
      left.meshes.push_back(mesh);
      continue;
    }
    for (const DrawId id : mesh.draws) {
      scene.draws[id].traits.remove(traits::progressive);
      for (Level& level : scene.draws[id].levels) level.made.remove(traits::progressive);
    }
  }
  scene.products.erase(CollapseSequences::product);
  if (!left.meshes.empty()) scene.products.set(std::move(left));
}

}  // namespace foredraw
