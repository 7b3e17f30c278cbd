#pragma once
// Names of files, and of classes and namespaces of plugins; lengths of files.

#include <map>

#include "source_tree.h"

namespace foredraw::architecture {

/// Names that say nothing (utils, common, manager, helper, misc), in files or folders, and C++ files that are not
/// called in lower case with underscores.
Breaches name_breaches(const std::string& path);

/// In a folder of a plugin or an evaluator, names that are not the folder's. Its namespaces are foredraw and
/// foredraw::<kinds>::<folder>. A class of <folder>_plugin.cpp that derives from another carries the folder's name in
/// PascalCase and the last word of the other's: WeldProcessor, TipsifyOrderer.
Breaches plugin_name_breaches(const std::string& path, const std::string& text);

inline constexpr std::size_t long_file = 300;      ///< lines: worth a look
inline constexpr std::size_t too_long_file = 450;  ///< lines: two ideas

/// Test files, of which several are compiled as one: tests/.../x_test.cpp whose tests do not lie in the namespace
/// foredraw::...::x_test, or, where another file is called so too, foredraw::...::<folder>_x_test; and those whose
/// namespace another file has, as `files` holds so far.
Breaches test_namespace_breaches(const std::string& path, const std::string& text,
                                 std::map<std::string, std::string>& files);

/// C++ and JavaScript sources of more than `limit` lines.
Breaches length_breaches(const std::string& path, const std::string& text, std::size_t limit);

}  // namespace foredraw::architecture
