#include "pivots.h"

#include <string_view>

namespace foredraw::import {

std::optional<StillPivots> still_pivots(const aiNode& first, const std::set<std::string>& moved) {
  constexpr std::string_view mark = "_$AssimpFbx$_";
  const std::string begin = first.mName.C_Str();
  const std::size_t place = begin.rfind(mark);
  if (place == std::string::npos) return std::nullopt;
  const std::string name = begin.substr(0, place);
  StillPivots made;
  for (const aiNode* node = &first;;) {
    const std::string_view now = node->mName.C_Str();
    if (now == name) {
      made.node = node;
      return made;
    }
    const bool is_pivot = now.starts_with(name + std::string(mark)) && node->mNumMeshes == 0;
    if (!is_pivot || node->mNumChildren != 1 || moved.contains(std::string(now))) return std::nullopt;
    const bool is_of_geometry = now.substr(name.size() + mark.size()).starts_with("Geometric");
    (is_of_geometry ? made.of_geometry : made.of_node) *= node->mTransformation;
    node = node->mChildren[0];
  }
}

}  // namespace foredraw::import
