#pragma once
// Where a mesh is cut into slots.

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw::processors::merge_instances {

struct SlotCuts {
  std::vector<std::uint32_t> first;  ///< [slot] its first index entry in the mesh; and the end
  std::uint64_t fetched = 0;         ///< different vertices of each slot, over all slots
  std::uint64_t fetched_plain = 0;   ///< the same where every slot but the last one is full

  std::size_t slots() const { return first.empty() ? 0 : first.size() - 1; }
};

/// Cuts the triangles, in their sequence, into the fewest slots of at most `frequency` entries (a multiple of 3), so
/// that the slots have the fewest vertices between them: cuts fall where few are shared. The padding that fills the
/// last slot otherwise is what moves them, so nothing is padded more. Exact where each cut may move by all the padding;
/// it moves by 24 triangles at most, and by fewer in meshes of a million. `vertices`: above every index. O(triangles *
/// how far cuts may move).
SlotCuts cut_slots(std::span<const std::uint32_t> indices, std::size_t vertices, std::uint32_t frequency);

/// Every slot full but the last one.
SlotCuts cut_evenly(std::span<const std::uint32_t> indices, std::size_t vertices, std::uint32_t frequency);

}  // namespace foredraw::processors::merge_instances
