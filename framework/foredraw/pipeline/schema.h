#pragma once
#include <foredraw/technique/registry.h>

#include <string>

namespace foredraw {

/// A JSON Schema (draft 2020-12) of the TOML pipeline format with every registered plugin's options, for editors.
std::string pipeline_schema(const Registry& registry);

}  // namespace foredraw
