#pragma once
// One scene file from reading to writing; folders of them, worked on at once.

#include "session.h"

#include <foredraw/job/job.h>
#include <foredraw/report/batch.h>

namespace foredraw::cli {

/// What every file of a run is worked on with.
struct FileJob {
  const Pipeline& pipeline;
  JobSetup setup;
  std::string folder = {};         ///< that the inputs lie in; empty: there is one input
  std::string pipeline_name = {};  ///< for the page
  TextArguments texts = {};        ///< of the one input
  PictureArguments pictures = {};
  bool keeps_scenes = false;                               ///< for who writes several in one file
  std::vector<std::filesystem::path> pipeline_files = {};  ///< that the pipeline is, and names

  bool is_cancelled() const { return setup.cancel != nullptr && *setup.cancel; }  ///< nothing more is written then
};

struct FileRun {
  Report report;  ///< with everything there is to tell among its diagnostics
  Exit exit = done;
  bool is_lost = false;             ///< nothing was measured or written
  std::optional<Scene> scene = {};  ///< as it was written, where the job keeps scenes
  std::string json = {};            ///< the report's form, where it was made already
  std::string text = {};            ///< and for people; of what comes from a cache, the report itself is empty
  bool from_cache = false;
  std::vector<std::filesystem::path> read = {};    ///< the files that it was made from, where somebody asks
  std::vector<std::filesystem::path> sought = {};  ///< and those that were only looked for, there or not
};

/// All outputs are written or none; there may be none.
FileRun optimize_file(const FileJob& with, const std::string& input, const std::vector<JobOutput>& outputs);
FileRun measure_file(const FileJob& with, const std::string& input);

/// What a build system has to know of the run.
std::string rules_of(const FileJob& with, const FileRun& run, const std::vector<JobOutput>& outputs);

/// One file of several; whatever it throws is its own affair.
FileRun guarded(const std::filesystem::path& input, const std::function<FileRun()>& run);

bool is_folder(const std::string& path);

/// Every scene of the folder that is the input, file by file on all threads; one that is lost does not end the run.
/// Tells what there is to tell in the sequence of the files, then prints the table, to standard error where `optimize`.
Exit optimize_folder(const FileJob& job, const OptimizeArguments& arguments);
Exit measure_folder(const FileJob& job, const MeasureArguments& arguments);

}  // namespace foredraw::cli
