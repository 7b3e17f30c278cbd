#pragma once
// What an import tells beside its GLB.

#include <set>
#include <string>
#include <vector>

namespace foredraw::import {

struct Told {
  std::set<std::string> read;         ///< files beside the scene
  std::set<std::string> missing;      ///< that were looked for
  std::vector<std::string> left_out;  ///< what glTF does not get, and why; behind a line end, what to do
};

}  // namespace foredraw::import
