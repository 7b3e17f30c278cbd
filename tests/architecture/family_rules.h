#pragma once
// Names of families of techniques stay in the families' own folders.

#include "source_tree.h"

namespace foredraw::architecture {

/// A row of families.md.
struct Family {
  std::string name;
  std::vector<std::string> words;  ///< in lower case; a text that holds one names the family
  std::vector<std::string> homes;  ///< folders, with '/' at the end
  std::size_t files_elsewhere = 0;
};
std::vector<Family> families_in(const std::string& table);

/// True if the file is a source that is not at home in the family's folders or in runtime/, and names the family.
bool names_from_elsewhere(const Family& family, const std::string& path, const std::string& text);

/// `files` name the family from elsewhere: a breach if their number differs from the table's.
Breaches family_breaches(const Family& family, const std::vector<std::string>& files);

}  // namespace foredraw::architecture
