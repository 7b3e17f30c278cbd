#pragma once
// Pictures of where the overdraw is.

#include <foredraw/base/diagnostics.h>
#include <foredraw/measuring/overdraw_evaluator.h>
#include <foredraw/platform/files.h>

#include <filesystem>
#include <string>
#include <vector>

namespace foredraw {

/// Whether there are such views to draw: worst (of each subject the view with the highest ratio), all, or the number of
/// one. Where not, a diagnostic says so.
bool are_views(const std::string& which, const OverdrawOptions& options, Diagnostics& diagnostics);

/// A PNG for each subject of the scene and each of these views: how often every pixel is shaded, with a legend, and
/// beside it the same view of `after` where there is one (the same subjects, drawn in another order). A subject is
/// shown in the pose, of those of the options, in which the view's ratio is highest; file names tell it. What is worst
/// is decided before. Subjects that a view does not show are left out.
std::vector<OutputFile> heat_maps(const Scene& before, const Scene* after, const OverdrawOptions& options,
                                  const std::string& which, const std::filesystem::path& folder,
                                  const Executor& executor, Analyses& analyses);

}  // namespace foredraw
