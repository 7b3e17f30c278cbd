#include "wire_radius.h"

#include <foredraw/technique/plugin.h>
namespace foredraw {
Plugin wire_radius_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {.name = "wire-radius", .summary = "stub", .reference = "own"};
  return plugin;
}
}  // namespace foredraw
