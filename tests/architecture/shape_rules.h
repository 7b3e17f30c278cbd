#pragma once
// The folder is the declaration: which files belong to a plugin, and what the corpus may hold.

#include <set>

#include "source_tree.h"

namespace foredraw::architecture {

/// What is missing of plugins/{orderers,clusterers,processors}/<name>/ and evaluators/<name>/: CMakeLists.txt,
/// <name>.h, <name>.cpp, <name>_plugin.cpp, README.md, and tests/<the same place>_test.cpp.
Breaches plugin_shape_breaches(const std::set<std::string>& paths);

/// Plugins that have neither a function for C, <name>_c.cpp, nor a row in the table of those that have none in
/// `page`, the text of docs/reference/c-functions.md; and those that have both.
Breaches c_function_breaches(const std::set<std::string>& paths, const std::string& page);

/// benchmarks/corpus/: at most 25 MB (25,000,000 bytes) in all, no links, names in plain ASCII, every model named in
/// `credits`, the text of its CREDITS.md.
Breaches corpus_breaches(const std::vector<SourceFile>& files, const std::string& credits);

}  // namespace foredraw::architecture
