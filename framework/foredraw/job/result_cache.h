#pragma once
// Results of earlier runs by the files that they were made from, on this machine or another.

#include <foredraw/cache/results.h>
#include <foredraw/io/reading/scene_input.h>
#include <foredraw/job/outputs.h>
#include <foredraw/pipeline/pipeline.h>
#include <foredraw/report/report.h>
#include <foredraw/technique/registry.h>

#include <functional>
#include <memory>
#include <mutex>

namespace foredraw {

/// An earlier run that was found.
struct Recalled {
  std::string json, text;                      ///< the report; the text is empty for a file of a folder
  std::vector<std::vector<OutputFile>> files;  ///< [output]; none if all are written already
  std::vector<std::filesystem::path> read, sought;
};

/// May be used from several threads at once.
class ResultCache {
 public:
  using Told = std::function<void(const Diagnostics&)>;

  /// In `folder`, for runs of the pipeline on `input`, a file or a folder, which is read as `how` says. nullptr, with
  /// an error, if the folder cannot be a cache. `told` is called with what is wrong with the cache, one call at a time.
  static std::unique_ptr<ResultCache> opened(const std::filesystem::path& folder, const Pipeline& pipeline,
                                             const Registry& registry, const SceneInput& how, const std::string& input,
                                             Told told, Diagnostics& diagnostics);

  std::optional<Recalled> recalled(const std::string& input, const std::vector<JobOutput>& outputs) const;

  /// `files`: of each output those that it is written as. Where they can not be kept, that is told once.
  void keep(const std::string& input, const std::vector<JobOutput>& outputs,
            const std::vector<std::vector<OutputFile>>& files, const WorkRead& read, const Scene& scene,
            const Report& report, const std::string& json) const;

 private:
  ResultCache(Cache cache, std::string how, std::string pipeline, bool is_of_folder, Told told)
      : cache_(std::move(cache)),
        how_(std::move(how)),
        pipeline_(std::move(pipeline)),
        is_of_folder_(is_of_folder),
        told_(std::move(told)) {}

  Work work_for(const std::string& input, const std::vector<JobOutput>& outputs) const;
  void tell_once(const std::string& why) const;
  void tell_now(const Diagnostics& diagnostics) const;

  Cache cache_;
  std::string how_;
  std::string pipeline_;
  bool is_of_folder_ = false;  ///< whose files have a line each, and no text of their own
  Told told_;
  mutable std::mutex telling_;
  mutable bool has_told_ = false;
};

}  // namespace foredraw
