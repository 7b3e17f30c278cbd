#pragma once
// Extensions wherever they are in a document. Private to io.

#include <foredraw/io/gltf/private/document.h>

#include <set>
#include <string_view>

namespace foredraw::gltf {

/// Calls visit(name, value) for each extension of each object, those that extensions hold too. What is in extras is
/// none. Documents are walked several times, and mostly hold numbers: these are passed by.
template <class Visit>
void each_extension(const Json& value, const Visit& visit) {
  if (const auto* list = value.get_ptr<const Json::array_t*>()) {
    for (const Json& part : *list) {
      if (part.is_structured()) each_extension(part, visit);
    }
  } else if (const auto* members = value.get_ptr<const Json::object_t*>()) {
    for (const auto& [key, part] : *members) {
      if (!part.is_structured() || key == std::string_view("extras")) continue;
      if (part.is_object() && key == std::string_view("extensions")) {
        for (const auto& [name, held] : *part.template get_ptr<const Json::object_t*>()) visit(name, held);
      }
      each_extension(part, visit);
    }
  }
}

/// Every whole number anywhere in a value: what an extension that we do not know might mean as an accessor.
void collect_numbers(const Json& value, std::set<std::size_t>& numbers);

}  // namespace foredraw::gltf
