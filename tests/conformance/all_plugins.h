#pragma once
#include <foredraw/technique/registry.h>

namespace foredraw {

/// Every plugin that has to conform: those of the program that is tested.
void add_all_plugins(Registry& registry);

}  // namespace foredraw
