#pragma once
// What the files of a watched folder are worked on with.

#include "file_runs.h"

#include <foredraw/io/file_lender.h>

#include <memory>

namespace foredraw::cli {

/// Made anew when a file changes that the pipeline is read from, or that it names.
struct Workshop {
  /// Nothing, with errors, where the pipeline or the cache is not as it should be.
  static std::unique_ptr<Workshop> opened(const WatchArguments& arguments, const Registry& registry,
                                          const Executor& executor, Diagnostics& diagnostics);
  ~Workshop();

  Pipeline pipeline;
  SceneInput how;
  FileLender lender;
  std::unique_ptr<ResultCache> cache;
  FileJob job;

 private:
  Workshop(const WatchArguments& arguments, const Registry& registry, const Executor& executor, Pipeline read,
           SceneInput input);
};

}  // namespace foredraw::cli
