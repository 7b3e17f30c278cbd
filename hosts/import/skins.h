#pragma once
#include "nodes.h"

#include <optional>

namespace foredraw::import {

/// The skin of a mesh with bones. If there are vertices that no bone moves, its last joint is `own`, the node that
/// bears the mesh. nullopt where a bone's node is not there.
std::optional<std::size_t> add_skin(const aiMesh& mesh, std::size_t own, const aiMatrix4x4& of_geometry,
                                    const NodeNumbers& nodes, Glb& glb);

}  // namespace foredraw::import
