#pragma once
// How files are called and how long they get.

#include "source_tree.h"

namespace foredraw::architecture {

/// Names that say nothing (utils, common, manager, helper, misc), in files or folders, and C++ files that are not
/// called in lower case with underscores.
Breaches name_breaches(const std::string& path);

inline constexpr std::size_t long_file = 300;      ///< lines: worth a look
inline constexpr std::size_t too_long_file = 450;  ///< lines: two ideas

/// C++ and JavaScript sources of more than `limit` lines.
Breaches length_breaches(const std::string& path, const std::string& text, std::size_t limit);

}  // namespace foredraw::architecture
