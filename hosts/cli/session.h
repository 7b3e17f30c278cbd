#pragma once
// What the commands that run pipelines have in common.

#include "commands.h"

#include <foredraw/io/scene_file.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/platform/files.h>

namespace foredraw::cli {

/// Prints the diagnostics for people, to standard error.
void tell(const Diagnostics& diagnostics);
void tell(const std::vector<Diagnostic>& diagnostics);

/// Tells why, and gives the exit code: for a mistake in what was asked, or for a file that could not be read or written
/// (which is a mistake too where there is none of that name).
Exit refuse(const Diagnostics& diagnostics);
Exit refuse_file(const Diagnostics& diagnostics);

/// The pipeline of an argument with --set and --with put in; evaluators of @default where it names none.
std::optional<Pipeline> pipeline_for(const Arguments& arguments, const std::string& pipeline, Diagnostics& diagnostics);

/// Progress on a terminal, nothing elsewhere.
std::function<void(std::string_view, double)> progress_line();
void end_progress();

/// Writes a text beside its place and renames it.
bool write_text(const std::string& path, const std::string& text, Diagnostics& diagnostics);

}  // namespace foredraw::cli
