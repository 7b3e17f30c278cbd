#pragma once
#include <foredraw/scene/views.h>

#include <string>
#include <variant>
#include <vector>

namespace foredraw {

/// Reads views from a text file, one a line, empty lines and what follows # left out:
///   direction x y z [weight]   from the centre to the camera, of any length
///   position x y z [weight]    of the camera, in bounding-sphere radii from the centre; outside of the sphere
/// Views by direction take `distance`. Or says what is wrong: "cameras.txt:3: ...".
std::variant<std::vector<View>, std::string> read_view_list(const std::string& path, double distance);

}  // namespace foredraw
