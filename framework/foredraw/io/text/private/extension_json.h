#pragma once
// Extensions' values, from JSON and to it. Private to io.

#include <foredraw/scene/extension_value.h>

#include <nlohmann/json.hpp>

namespace foredraw {

ExtensionValue value_of(const nlohmann::ordered_json& json);
/// References to accessors are their numbers.
nlohmann::ordered_json json_of(const ExtensionValue& value);

}  // namespace foredraw
