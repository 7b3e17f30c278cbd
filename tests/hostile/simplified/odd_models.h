#pragma once
// Models whose surfaces, or what their vertices carry, nobody would make on purpose, as files: for what makes them
// coarser.

#include "support/gltf_builder.h"

#include <string>
#include <vector>

namespace foredraw::testing {

struct OddModel {
  std::string name;  ///< of its file, too
  GltfBuilder file;
  bool is_finite = true;  ///< all numbers of its vertices are
};

/// Those of odd_meshes() and more, with normals and texture coordinates, and meshes as others are whose normals,
/// texture coordinates, colours, joint weights, morph targets or nodes are odd.
std::vector<OddModel> odd_models();

/// Whose indices lead out of its vertices: no program reads it.
GltfBuilder model_with_indices_out_of_range();

/// A torus with normals and texture coordinates.
GltfBuilder plain_model(std::uint32_t slices, std::uint32_t sides);

}  // namespace foredraw::testing
