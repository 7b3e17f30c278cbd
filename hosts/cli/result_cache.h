#pragma once
// What files came to in earlier runs, on this machine or another.

#include "file_runs.h"

#include <foredraw/cache/results.h>

#include <mutex>

namespace foredraw::cli {

class ResultCache {
 public:
  /// In the folder that --cache names. Nothing, with an error, where that can not be one.
  static std::unique_ptr<ResultCache> opened(const Arguments& arguments, const Pipeline& pipeline,
                                             const Registry& registry, Diagnostics& diagnostics);

  /// The run as it was, its outputs written as far as they are not there already. Nothing where there is none.
  std::optional<FileRun> recalled(const FileJob& job, const std::string& input,
                                  const std::vector<Output>& outputs) const;

  /// `files`: of each output those that it is written as. Where they can not be kept, that is told once.
  void keep(const std::string& input, const std::vector<Output>& outputs,
            const std::vector<std::vector<OutputFile>>& files, const WorkRead& read, const Scene& scene,
            const Report& report, const std::string& json) const;

 private:
  ResultCache(Cache cache, std::string how, std::string pipeline, bool is_of_folder)
      : cache_(std::move(cache)), how_(std::move(how)), pipeline_(std::move(pipeline)), is_of_folder_(is_of_folder) {}

  Work work_for(const std::string& input, const std::vector<Output>& outputs) const;
  void tell_once(const std::string& why) const;
  void tell_now(const Diagnostics& diagnostics) const;

  Cache cache_;
  std::string how_;
  std::string pipeline_;
  bool is_of_folder_ = false;  ///< whose files have a line each, and no text of their own
  mutable std::mutex at_the_terminal_;
  mutable bool has_told_ = false;
};

}  // namespace foredraw::cli
