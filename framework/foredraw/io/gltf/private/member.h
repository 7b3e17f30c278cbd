#pragma once
// A look into JSON that nobody has checked. Private to io.

#include <foredraw/io/gltf/private/document.h>

namespace foredraw::gltf {

/// Nothing where the value is no object, or has no such member.
inline const Json* member(const Json& json, const char* key) {
  if (!json.is_object()) return nullptr;
  const auto found = json.find(key);
  return found == json.end() ? nullptr : &*found;
}

}  // namespace foredraw::gltf
