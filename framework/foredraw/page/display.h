#pragma once
// What the viewer of a page shows: the subjects of the input, and what every pipeline made of them.

#include <foredraw/scene/subject.h>

#include <optional>
#include <span>
#include <string>

namespace foredraw {

/// One file as the page's script reads it (script/subject.js).
struct Display {
  std::string scene;  ///< JSON
  std::string buffer_name;
  std::string buffer;  ///< base64
  bool has_wires = false;
};

/// Subject by subject, as overdraw is measured, in at most 64 poses. Each state, the input or a pipeline, has the parts
/// that its own scene draws, with their sides, in its own sequence, and the same of its coarser levels of detail, with
/// what vertices become from one to the next; what several states have alike is held once. A state shows at most
/// 200,000 triangles of a subject, and the first 24 pipelines alone are shown. `branches`: [pipeline] its scene,
/// nothing where it was lost. `file`: the number by which the page knows it.
Display display(const Scene& input, std::span<const std::optional<Scene>> branches, std::size_t file,
                SubjectUnit unit = SubjectUnit::character);

}  // namespace foredraw
