#pragma once
#include "nodes.h"

namespace foredraw::import {

/// Every animation, key by key, in seconds from its beginning, with straight lines between keys: Assimp hands on no
/// others. Of keys at the same time the last one counts. `is_cut`: clips end when they say, and not with their last
/// key.
void add_animations(const aiScene& scene, const NodeNumbers& nodes, bool is_cut, Glb& glb, Told& told);

}  // namespace foredraw::import
