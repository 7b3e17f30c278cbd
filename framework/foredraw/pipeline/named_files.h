#pragma once
// Files that options name.

#include <foredraw/pipeline/pipeline.h>
#include <foredraw/scene/lender.h>
#include <foredraw/technique/registry.h>

#include <vector>

namespace foredraw {

/// The pipeline with the path of every file that an option names as it counts from the working directory. As written,
/// it counts from the folder of the file that it is written in; on a command line that is the same.
Pipeline with_paths_from_here(Pipeline pipeline, const Registry& registry);

/// Borrows what the stage's settings name, which fit these rows. False, with an error at the option, where something
/// can not be had.
bool borrow(const Stage& stage, const std::vector<OptionSpec>& rows, const Settings& settings, const Lender* lender,
            Loans& loans, Diagnostics& diagnostics);

}  // namespace foredraw
