#pragma once
// One name, one type: C++ lets two files define different types of one name, and the linker mixes them up unseen.

#include "source_tree.h"

#include <map>
#include <set>

namespace foredraw::architecture {

/// Types with their namespaces, by the files that define them at the outermost level of a namespace with a name.
using TypeFiles = std::map<std::string, std::set<std::string>>;

void add_types(const std::string& path, const std::string& text, TypeFiles& types);

/// Types that several files define.
Breaches type_breaches(const TypeFiles& types);

}  // namespace foredraw::architecture
