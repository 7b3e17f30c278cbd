#pragma once
// What the commands that run pipelines have in common.

#include "commands.h"

#include <foredraw/job/job.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/platform/files.h>
#include <foredraw/report/baseline.h>

#include <new>

namespace foredraw::cli {

/// Prints the diagnostics for people, to standard error.
void tell(const Diagnostics& diagnostics);
void tell(const std::vector<Diagnostic>& diagnostics);

/// Tells why, and gives the exit code: for a mistake in what was asked, or for a file that could not be read or written
/// (which is a mistake too where there is none of that name).
Exit refuse(const Diagnostics& diagnostics);
Exit refuse_file(const Diagnostics& diagnostics);
Exit exit_for_file(const Diagnostics& diagnostics);  ///< the code alone

/// Ctrl-C ended it; `what_is_left` of what it was to do, or nothing.
Exit tell_interrupted(const std::string& what_is_left = "");

/// Prints a result to standard output.
Exit print(const std::string& text);
/// The same of one that is long, piece by piece.
Exit print_pieces(const std::function<void(const OutputFile::Put&)>& write);

/// The pipelines of the texts, of a file with several all of them, with what the arguments change of them (change()).
std::optional<std::vector<NamedPipeline>> pipelines_for(const PipelineArguments& arguments, const Registry& registry,
                                                        const std::vector<std::string>& texts,
                                                        Diagnostics& diagnostics);

/// The one that --pipeline names, or @default. Another one is a mistake, and so is one with branches.
std::optional<Pipeline> one_pipeline(const PipelineArguments& arguments, const Registry& registry,
                                     Diagnostics& diagnostics);

/// The files that the pipeline is read from, and those that its options name.
std::vector<std::filesystem::path> files_of(const PipelineArguments& arguments, const Pipeline& pipeline,
                                            const Registry& registry);

/// What a step that lacks memory is left by; main() tells it in one line.
struct OutOfMemory {
  std::string file;
  std::string doing;  ///< "read it"
};

template <class Step>
auto with_memory(const std::string& file, const char* doing, Step step) {
  try {
    return step();
  } catch (const std::bad_alloc&) {
    throw OutOfMemory{file, doing};
  }
}

/// How the inputs of a command are read.
SceneInput input_of(const ReadingArguments& reading, const CommonArguments& arguments, const Registry& registry);

/// The setup that all jobs of a command share. `how`: as the lender reads.
JobSetup setup_of(const CommonArguments& arguments, const Registry& registry, const Executor& executor,
                  const Lender& lender, SceneInput how);

/// The cache in the folder that --cache names; nullptr: none is named or, with errors, it cannot be one.
std::unique_ptr<ResultCache> cache_of(const std::string& folder, const std::string& input, const Pipeline& pipeline,
                                      const Registry& registry, const SceneInput& how, Diagnostics& diagnostics);

/// Progress on a terminal, nothing elsewhere.
std::function<void(std::string_view, double)> progress_line();
void end_progress();

/// The folder, and those that it lies in, unless they are there.
bool make_folder(const std::filesystem::path& folder, Diagnostics& diagnostics);

/// Whether two paths lead to the same place, there or not.
bool is_same_file(const std::string& a, const std::string& b);

/// What --baseline names. Nothing where it is not given, or, with an error, can not be read.
std::optional<Baseline> baseline_of(const std::string& file, Diagnostics& diagnostics);

/// "foredraw 0.1.0".
std::string program_name();

/// Where texts may wait for a report: where that goes, which has room for it. No report: where temporary files go.
std::filesystem::path spool_folder(const std::string& report);

OutputFile text_file(const std::string& path, const std::string& text);

}  // namespace foredraw::cli
