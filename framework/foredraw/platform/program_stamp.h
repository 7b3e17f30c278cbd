#pragma once
#include <foredraw/base/content_hash.h>

namespace foredraw {

/// Of the program that runs and every library that was loaded with it: what one build has made, another may make
/// otherwise. By the stamps that linkers leave in them (build ids), or their content where there is none. Libraries
/// that are loaded later do not count, so ask early.
Stamp program_stamp();

}  // namespace foredraw
