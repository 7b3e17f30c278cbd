#pragma once
// Extensions' values, from JSON and to it. Private to io.

#include <foredraw/io/text/private/json_tree.h>
#include <foredraw/scene/extension_value.h>

namespace foredraw {

ExtensionValue value_of(const Json& json);
/// References to accessors are their numbers.
Json json_of(const ExtensionValue& value);

}  // namespace foredraw
