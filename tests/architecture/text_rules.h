#pragma once
// What no text of the project may hold.

#include "source_tree.h"

namespace foredraw::architecture {

/// Notes of unfinished work, and paths that mean something on one machine only.
Breaches text_breaches(const std::string& path, const std::string& text);

}  // namespace foredraw::architecture
