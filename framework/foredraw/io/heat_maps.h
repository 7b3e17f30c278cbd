#pragma once
// Pictures of where the overdraw is.

#include <foredraw/base/diagnostics.h>
#include <foredraw/platform/files.h>
#include <foredraw/technique/overdraw_evaluator.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foredraw {

/// A PNG for each subject of the scene and each chosen view: how often every pixel is shaded, with a legend, and beside
/// it the same view of `after` where there is one (the same subjects, drawn in another order). `which`: worst (of each
/// subject the view with the highest ratio before), all, or the number of a view. Subjects that no view shows are left
/// out. nullopt, with a diagnostic, where there is no such view.
std::optional<std::vector<OutputFile>> heat_maps(const Scene& before, const Scene* after,
                                                 const OverdrawOptions& options, const std::string& which,
                                                 const std::filesystem::path& folder, const Executor& executor,
                                                 Diagnostics& diagnostics);

}  // namespace foredraw
