#pragma once
// Reports, pages and tables, which are written beside what the user has.

#include <foredraw/base/diagnostics.h>
#include <foredraw/job/outputs.h>
#include "commands.h"

namespace foredraw::cli {

/// The files that a command was given to read.
std::vector<std::string> files_read(const CommonArguments& arguments, const PipelineArguments& pipelines = {});

/// Whether every text that is to be written has a file of its own: no other output's, none that this run reads, and
/// none that is called as scenes, their buffers and images, and pipelines are: of these a folder may hold many, and a
/// scene names more than were typed. Of scenes that are to be written, whether they leave each other's files alone, and
/// files of sprites what is read.
bool have_files_of_their_own(std::vector<std::string> read, const std::vector<JobOutput>& outputs,
                             const TextArguments& texts, Diagnostics& diagnostics);

}  // namespace foredraw::cli
