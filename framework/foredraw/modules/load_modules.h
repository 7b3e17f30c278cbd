#pragma once
#include <foredraw/base/diagnostics.h>
#include <foredraw/base/parallel.h>
#include <foredraw/modules/worker_process.h>
#include <foredraw/technique/registry.h>

#include <filesystem>
#include <vector>

namespace foredraw {

/// Modules, and how they run.
struct ModuleChoice {
  std::vector<std::filesystem::path> places;  ///< files, and folders of them
  bool inside = false;                        ///< in this process, which then trusts them
  ModuleLimits limits = {};
};

/// Adds the plugins of the modules to the registry: of a folder those of every .so and .py in it, by name. A file that
/// holds none, or one of whose plugins is wrong, is an error among the diagnostics; the others are added all the same.
void add_modules(const ModuleChoice& choice, const Executor& executor, Registry& registry, Diagnostics& diagnostics);

/// What the environment variable FOREDRAW_MODULES names, with ':' between.
std::vector<std::filesystem::path> modules_of_environment();

}  // namespace foredraw
