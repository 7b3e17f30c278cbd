#pragma once
#include "nodes.h"

namespace foredraw::import {

/// Every animation, key by key, in seconds. Of keys at the same time the last one counts.
void add_animations(const aiScene& scene, const NodeNumbers& nodes, Glb& glb, Told& told);

}  // namespace foredraw::import
