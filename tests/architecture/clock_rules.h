#pragma once
// No test asserts time: machines are slow, and other programs want the processor too.

#include "source_tree.h"

namespace foredraw::architecture {

/// Clocks that files below tests/ read, but for those few that have a reason.
Breaches clock_breaches(const std::string& path, const std::string& text);

}  // namespace foredraw::architecture
