#pragma once
// The page about rooms shows the rooms that the build has.

#include "include_rules.h"

namespace foredraw::architecture {

/// The picture: a line for each room, floor by floor. A room stands one floor above the highest room that it links.
std::string picture_of(const std::vector<Room>& rooms);

/// Differences between the page's section "## Rooms" and the rooms: its picture is not theirs, or its table does
/// not name each room once in the first column. `runtime` is in the table alone: it is no library.
Breaches room_breaches(const std::string& page, const std::vector<Room>& rooms);

}  // namespace foredraw::architecture
