#pragma once
// From where a subject is looked at.

#include <glm/vec3.hpp>

#include <string_view>
#include <vector>

namespace foredraw {

/// One way to look at a subject, in the subject's own space.
struct View {
  glm::dvec3 direction{0, 0, 1};  ///< unit length, from the bounding sphere's centre to the camera
  double distance = 0;            ///< from the centre to the camera in bounding-sphere radii; 0: orthographic
  double weight = 1;              ///< above 0; how much the view counts beside the others

  friend bool operator==(const View&, const View&) = default;
};

struct Views {
  std::vector<View> views;
  int size = 256;  ///< pixels along each edge of the square picture that just holds the bounding sphere

  friend bool operator==(const Views&, const Views&) = default;
};

/// True if the word of a view set is the path of a file: it has a dot or a slash.
inline bool is_view_list(std::string_view views) { return views.find_first_of("./") != std::string_view::npos; }

}  // namespace foredraw
