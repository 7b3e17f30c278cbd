#pragma once
// Each vertex's joints and weights in the slots where the vertex before has them, so that a codec of differences sees
// the same joint again and a weight that changes little.

#include <foredraw/scene/vertex_streams.h>

#include <memory>
#include <string>

namespace foredraw {

struct SkinSlotsOptions {
  bool zero_unused = false;  ///< joints of slots without weight are 0; else that of the vertex before
};

struct SlottedSkin {
  std::shared_ptr<const VertexStreams> vertices;
  std::uint32_t moved = 0;  ///< vertices whose influences, those with weight, have other slots than before
  std::string why_not;      ///< why nothing moved, as the rest of a sentence; empty: it could
};

/// All sets JOINTS_n and WEIGHTS_n with each vertex's pairs in other slots. Going through the vertices by number, an
/// influence goes to the slot that had its joint last; those left, the heaviest first, take the first slots that are
/// free. Which joints a vertex has, and with which weights, stays to the bit. O(vertices).
SlottedSkin keep_slots(const VertexStreams& vertices, const SkinSlotsOptions& options = {});

struct Plugin;
Plugin skin_slots_plugin();

}  // namespace foredraw
