#pragma once
// Links between pages: each leads to a file and a heading that are there, and every page of docs/ can be reached.

#include "source_tree.h"

#include <map>
#include <set>

namespace foredraw::architecture {

using Pages = std::map<std::string, std::string>;  ///< texts of Markdown files by path

/// Links in `pages` to a file or folder that is not among `paths` (which are files), or to a heading that its page does
/// not have. Addresses on the network are not looked at.
Breaches link_breaches(const Pages& pages, const std::set<std::string>& paths);

/// Pages below `folder` to which no chain of links leads from the page `start`.
Breaches unreached_breaches(const Pages& pages, const std::string& start, const std::string& folder);

}  // namespace foredraw::architecture
