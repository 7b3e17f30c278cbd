#pragma once
// One scene file from reading to writing; folders of them, worked on at once.

#include "outputs.h"
#include "session.h"

#include <foredraw/report/batch.h>

namespace foredraw::cli {

/// What every file of a run is worked on with.
struct FileJob {
  const Arguments& arguments;
  const Pipeline& pipeline;
  const Registry& registry;
  const Executor& executor;
  const Lender& lender;
  std::function<void(std::string_view, double)> progress = {};
  bool keeps_scenes = false;  ///< for who writes several in one file
};

struct FileRun {
  Report report;  ///< with everything there is to tell among its diagnostics
  Exit exit = done;
  bool is_lost = false;             ///< nothing was measured or written
  std::optional<Scene> scene = {};  ///< as it was written, where the job keeps scenes
};

/// All outputs are written or none; there may be none.
FileRun optimize_file(const FileJob& job, const std::string& input, const std::vector<Output>& outputs);
FileRun measure_file(const FileJob& job, const std::string& input);

bool is_folder(const std::string& path);

/// Every scene of the folder that is the input, file by file on all threads; one that is lost does not end the run.
/// Tells what there is to tell in the sequence of the files, then prints the table, to standard error where `optimize`.
Exit optimize_folder(const FileJob& job);
Exit measure_folder(const FileJob& job);

}  // namespace foredraw::cli
