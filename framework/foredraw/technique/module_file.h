#pragma once
#include <cstdint>
#include <string>

namespace foredraw {

/// The file that a plugin was loaded from, where it is not built in.
struct ModuleFile {
  std::string path;
  std::uint64_t bytes = 0;
  std::string hash;  ///< of its content
  std::string vendor;
  std::string version;
  bool is_inside = false;  ///< it runs in this process
};

}  // namespace foredraw
