#pragma once
#include <foredraw/base/diagnostics.h>
#include <foredraw/technique/registry.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foredraw {

/// A module that a pipeline wants to be there. Nothing loads it for that: who runs the pipeline names its file.
struct ModuleDemand {
  std::string vendor;   ///< "acme"
  std::string version;  ///< the least, "1.2"; empty: any
  Where where = {};     ///< in the text
  friend bool operator==(const ModuleDemand& a, const ModuleDemand& b) {
    return a.vendor == b.vendor && a.version == b.version;
  }
};

/// "acme" or "acme >= 1.2"; nothing where it is neither.
std::optional<ModuleDemand> module_demand(std::string_view text);
std::string to_text(const ModuleDemand& demand);

/// Tells of those that no module of the registry's meets.
void check_demands(const std::vector<ModuleDemand>& demands, const Registry& registry, Diagnostics& diagnostics);

}  // namespace foredraw
