#pragma once
#include <foredraw/technique/registry.h>

namespace foredraw {

/// Adds every plugin that this build was configured with. Link foredraw::built_in_plugins.
void add_built_in_plugins(Registry& registry);

}  // namespace foredraw
