#pragma once
#include <foredraw/scene/scene.h>

namespace foredraw {

/// Adds to every draw the traits that the scene itself shows: all those of the namespace traits that no stage makes,
/// but for `extended`, of which a reader knows. Who makes a scene calls it when everything is in its place.
void find_traits(Scene& scene);

}  // namespace foredraw
