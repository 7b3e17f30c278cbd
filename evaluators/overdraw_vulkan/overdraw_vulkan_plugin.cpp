#include "overdraw_vulkan.h"

#include <foredraw/technique/plugin.h>

namespace foredraw { Plugin overdraw_vulkan_plugin() { return {}; } }
