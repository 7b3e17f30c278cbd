#pragma once
// What the viewer of a page shows: geometry, poses, and the orders of every pipeline.

#include <foredraw/base/parallel.h>
#include <foredraw/scene/subject.h>

#include <optional>
#include <span>
#include <string>

namespace foredraw {

/// One file as the script reads it; docs/report.md tells its form.
struct Display {
  std::string scene;  ///< JSON
  std::string buffer_name;
  std::string buffer;  ///< base64
};

/// Subject by subject, as overdraw is measured: every part in at most 64 poses, the input's triangles, and how each
/// pipeline sorts them. Subjects above 200,000 triangles are shown by some of theirs, and the first 24 pipelines alone.
/// `branches`: [pipeline] its scene, nothing where it was lost. `file`: the number by which the page knows it.
Display display(const Scene& input, std::span<const std::optional<Scene>> branches, std::size_t file,
                SubjectUnit unit = SubjectUnit::character);

}  // namespace foredraw
