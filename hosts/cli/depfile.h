#pragma once
// What a build system has to know: which files an output was made from, as rules of Make. Ninja reads the same.

#include <filesystem>
#include <string>
#include <vector>

namespace foredraw::cli {

struct DependencyRule {
  std::vector<std::filesystem::path> outputs;
  std::vector<std::filesystem::path> inputs;  ///< the main one first
};

/// "out.glb: in.gltf in.bin", and "in.bin:" for each but the main one, so that Make does not stop where it is gone.
/// Blanks, `#`, `$` and `:` in names are written as Make reads them. A name with a line break can not be written in a
/// Makefile; its rule, or it alone, is left out.
std::string rule_text(const DependencyRule& rule);

}  // namespace foredraw::cli
