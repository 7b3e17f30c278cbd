#pragma once
// What may be wrong with a displaced draw, case by case.

#include "displaced_parts.h"

#include <functional>
#include <vector>

namespace foredraw::testing {

struct DisplacedCase {
  const char* name;
  std::function<void(Parts&)> harm;
  const char* pipeline = "";  ///< that tells what is wrong
  const char* says = "";
};

const std::vector<DisplacedCase>& displaced_layouts();   ///< texture coordinates, and how they place the map
const std::vector<DisplacedCase>& displaced_normals();   ///< normals, and what triangles stand on
const std::vector<DisplacedCase>& displaced_numbers();   ///< of the material
const std::vector<DisplacedCase>& displaced_shapes();    ///< folds, slivers, and sizes
const std::vector<DisplacedCase>& displaced_vertices();  ///< tangents and weights

}  // namespace foredraw::testing
