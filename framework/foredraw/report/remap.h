#pragma once
#include <foredraw/scene/scene.h>

#include <string>

namespace foredraw {

/// The remap tables that engines ask for, as JSON. For each draw that came from the file, by mesh and primitive:
///   "triangles": {"new-to-old": [...]}   [number now] = number in the file
///   "vertices":  {"old-to-new": [...]}   [number in the file] = number now, null where it was left out
/// and null in place of a table where nothing moved. Coarser levels of detail have tables of their own, in "levels",
/// with mesh and primitive where the file has them as such.
std::string remap_json(const Scene& scene);

}  // namespace foredraw
