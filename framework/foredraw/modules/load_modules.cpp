#include <foredraw/modules/load_modules.h>

#include <foredraw/base/content_hash.h>
#include <foredraw/base/printable.h>
#include <foredraw/modules/description.h>
#include <foredraw/modules/foreign_plugin.h>
#include <foredraw/modules/foreign_technique.h>
#include <foredraw/modules/runs_apart.h>
#include <foredraw/platform/files.h>
#include <foredraw/platform/shared_library.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <stdexcept>

namespace foredraw {

namespace {

namespace fs = std::filesystem;

/// So many modules of a folder may keep the processes that told what they hold, for the calls to come.
constexpr std::size_t most_that_stay = 8;

/// A module's plugins, or why there are none.
struct LoadedModule {
  fs::path path;
  std::shared_ptr<ModuleFile> file;
  std::vector<Plugin> plugins;
  std::shared_ptr<ModuleWorkers> workers;
  Diagnostics diagnostics;

  void refuse(const std::string& why, const std::string& hint = {}) {
    diagnostics.error({.file = path.string()}, "bad-module", why, hint);
  }
};

bool is_module(const fs::path& path) { return path.extension() == ".so" || path.extension() == ".py"; }

std::vector<fs::path> files_in(const std::vector<fs::path>& places, Diagnostics& diagnostics) {
  std::vector<fs::path> files;
  std::set<fs::path> seen;
  std::error_code error;
  const auto add = [&](const fs::path& file) {
    if (seen.insert(fs::weakly_canonical(file, error)).second) files.push_back(file);
  };
  for (const fs::path& place : places) {
    if (!fs::is_directory(place, error)) {
      add(place);
      continue;
    }
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(place, error)) {
      if (is_module(entry.path()) && entry.is_regular_file(error)) found.push_back(entry.path());
    }
    if (found.empty()) {
      diagnostics.error({.file = place.string()}, "no-modules", "holds no module: no file .so or .py",
                        "name the folder that the modules lie in, or a module itself");
    }
    std::ranges::sort(found);
    std::ranges::for_each(found, add);
  }
  return files;
}

/// What is wrong with the names; empty: nothing.
std::string wrong_name(const std::string& vendor, const foredraw_plugin& plugin) {
  const bool good = !vendor.empty() && std::ranges::all_of(vendor, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
  });
  if (!good) return fmt::format("vendor is '{}', but must be lower-case letters and digits", printable(vendor));
  const std::string name = text_from_c(plugin.name);
  if (name.starts_with(vendor + '-')) return "";
  return fmt::format("plugin '{}': its name must begin with the vendor, as '{}-{}'", name, vendor, name);
}

/// Adds a plugin where its description is right.
void take(LoadedModule& module, const foredraw_plugin& described, std::shared_ptr<const ForeignRunner> runner) {
  if (const std::string wrong = wrong_name(module.file->vendor, described); !wrong.empty()) return module.refuse(wrong);
  try {
    module.plugins.push_back(foreign_plugin(described, std::move(runner)));
  } catch (const std::invalid_argument& wrong) {
    module.refuse(fmt::format("plugin '{}': {}", text_from_c(described.name), wrong.what()));
  }
}

std::shared_ptr<ModuleFile> file_of(LoadedModule& module) {
  std::error_code error;
  if (const auto what = fs::status(module.path, error); fs::exists(what) && !fs::is_regular_file(what)) {
    module.refuse("is not a regular file, so it is no module");  // a pipe, say, would be waited for
    return nullptr;
  }
  const auto bytes = read_file(module.path, module.diagnostics);
  if (!bytes) return nullptr;
  return std::make_shared<ModuleFile>(ModuleFile{
      module.path.string(), bytes->size(), to_text(content_hash(std::span<const std::byte>(*bytes))), {}, {}});
}

void load_apart(LoadedModule& module, const ModuleLimits& limits) {
  module.workers = std::make_shared<ModuleWorkers>(module.path, limits);
  const DescribedModule described(module.workers->tables());
  module.file->vendor = described.vendor, module.file->version = printable(described.version);
  for (std::uint32_t i = 0; i < described.plugins.size(); ++i) {
    const bool uses_overdraw = (described.plugins[i].flags & FOREDRAW_USES_OVERDRAW) != 0;
    take(module, described.plugins[i], std::make_shared<RunsApart>(module.workers, i, uses_overdraw));
  }
}

void load_inside(LoadedModule& module) {
  if (module.path.extension() == ".py") {
    return module.refuse("a module in Python runs in a process of its own alone", "leave out --modules inside");
  }
  const LoadedLibrary library(module.path);
  auto* entry = library.function<const foredraw_module*()>("foredraw_module_v1");
  if (entry == nullptr) return module.refuse("it exports no function foredraw_module_v1, so it is no module");
  const foredraw_module* loaded = entry();
  const DescribedModule described(written_down(loaded));
  module.file->vendor = described.vendor, module.file->version = printable(described.version);
  module.file->is_inside = true;
  for (std::uint32_t i = 0; i < described.plugins.size(); ++i) {
    take(module, described.plugins[i], std::make_shared<RunsInside>(*loaded->plugins[i]));
  }
}

/// What Python says of a package that it lacks does not say which Python that is; what loads libraries does not say
/// that it takes what is not Python for one.
std::string hint_for(const fs::path& module, std::string_view wrong) {
  if (!is_module(module)) return "a module is a shared library, .so, or a Python file, .py";
  const bool lacks = module.extension() == ".py" && wrong.find("ModuleNotFoundError") != wrong.npos;
  return lacks
             ? "it runs in the python3 of PATH, which has to have foredraw and numpy: PYTHONPATH says where they are, "
               "or FOREDRAW_PYTHON names another python3"
             : "";
}

void load(LoadedModule& module, const ModuleChoice& choice) {
  try {
    module.file = file_of(module);
    if (!module.file) return;
    choice.inside ? load_inside(module) : load_apart(module, choice.limits);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& problem) {
    module.refuse(problem.what(), hint_for(module.path, problem.what()));
  }
}

}  // namespace

void add_modules(const ModuleChoice& choice, const Executor& executor, Registry& registry, Diagnostics& diagnostics) {
  std::vector<LoadedModule> modules;
  for (fs::path& path : files_in(choice.places, diagnostics)) modules.push_back({.path = std::move(path)});
  executor.for_each(modules.size(), [&](std::size_t i) {
    load(modules[i], choice);
    if (modules.size() > most_that_stay && modules[i].workers) modules[i].workers->rest();
  });
  for (LoadedModule& module : modules) {
    for (Plugin& plugin : module.plugins) {
      try {
        registry.add(std::move(plugin), module.file);
      } catch (const std::invalid_argument& wrong) {
        module.refuse(wrong.what());
      }
    }
    for (const Diagnostic& diagnostic : module.diagnostics.all()) diagnostics.add(diagnostic);
  }
}

std::vector<fs::path> modules_of_environment() {
  const char* named = std::getenv("FOREDRAW_MODULES");
  std::vector<fs::path> places;
  for (std::string_view rest = named == nullptr ? "" : named; !rest.empty();) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    if (end > 0) places.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return places;
}

}  // namespace foredraw
