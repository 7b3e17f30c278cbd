#include "all_plugins.h"

#include <foredraw/technique/built_in_plugins.h>
#include <peers.h>

namespace foredraw {

void add_all_plugins(Registry& registry) {
  add_built_in_plugins(registry);
  add_peers(registry);
}

}  // namespace foredraw
