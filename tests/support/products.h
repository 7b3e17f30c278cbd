#pragma once
#include <foredraw/technique/built_in_plugins.h>

namespace foredraw::testing {

/// The rows of all products that this build's plugins make.
inline ProductRows built_in_products() {
  Registry registry;
  add_built_in_plugins(registry);
  return registry.products();
}

}  // namespace foredraw::testing
