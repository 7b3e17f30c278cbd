#pragma once
#include <foredraw/scene/extension_value.h>

#include <string>

namespace foredraw {

/// The value as JSON. `indent`: spaces a level; -1: all on one line.
std::string json_text(const ExtensionValue& value, int indent = -1);

}  // namespace foredraw
