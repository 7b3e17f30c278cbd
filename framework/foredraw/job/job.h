#pragma once
// One scene from its file to the files of its outputs: read, plan, run, encode. The command line, the C library and, by
// it, Python work through this; what they add is how they are asked and how they answer.

#include <foredraw/io/reading/scene_input.h>
#include <foredraw/job/outputs.h>
#include <foredraw/job/result_cache.h>
#include <foredraw/measuring/overdraw_evaluator.h>
#include <foredraw/pipeline/contest.h>
#include <foredraw/pipeline/plan.h>
#include <foredraw/pipeline/runner.h>

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace foredraw {

enum class JobStatus {
  done,
  in_part,     ///< a stage failed somewhere; the result is the work of the others
  mistake,     ///< the pipeline cannot be planned for the scene
  unreadable,  ///< the input cannot be read
  unwritable,  ///< an output cannot be encoded
  cancelled,   ///< there is no result
};

/// Shared by jobs, any number of which may run at once.
struct JobSetup {
  const Registry& registry;
  const Executor& executor;
  const Lender* lender = nullptr;      ///< reads the files that options name; null: such an option is a mistake
  SceneInput input = {};               ///< how files are read; its `files`, unless null, lists what the lender reads
  const ResultCache* cache = nullptr;  ///< of optimize; null: none
  const std::atomic<bool>* cancel = nullptr;
  std::function<void(std::string_view, double)> progress = {};  ///< as of Surroundings
  bool keeps_input = false;                                     ///< the input is held beyond the run, for pictures
};

enum class JobKind { optimize, measure, compare };

class Job {
 public:
  /// `input`: the path of the scene, which diagnostics and the report name. `found`: what was reported before.
  Job(const JobSetup& setup, JobKind kind, std::string input, Diagnostics found = {});

  // Steps. Each returns false if the job has ended; then status() and report() say why.

  /// Finds what an earlier run with these outputs made: files() and report_json() are that run's. If there is none, the
  /// other steps follow.
  bool recall(const std::vector<JobOutput>& outputs);
  bool read();
  /// Takes a scene that was read before. `file`: its own, for the report.
  void take(const FileRecord& file, Scene scene);
  bool plan(const Pipeline& pipeline);
  /// Optimises or measures.
  bool run();
  /// Encodes the result by the pipeline's [output], and keeps it in the cache. Nothing is written here.
  bool encode(const std::vector<JobOutput>& outputs);
  /// Ends the job with a mistake that its host found.
  bool refuse(const Diagnostics& why);
  /// Instead of plan() and run(): all pipelines side by side, stages in so many rounds.
  Contest compare(std::span<const NamedPipeline> pipelines, int rounds);

  JobStatus status() const { return status_; }
  bool is_cancelled() const { return setup_.cancel != nullptr && *setup_.cancel; }
  const Diagnostics& diagnostics() const { return diagnostics_; }
  Report& report() { return report_; }
  /// True if there is no result: nothing was measured or encoded.
  bool is_lost() const { return status_ != JobStatus::done && status_ != JobStatus::in_part; }

  const Plan& plan() const { return *plan_; }
  const Scene& input() const { return before_; }  ///< if the setup keeps it
  Scene& scene() { return scene_; }               ///< as the last step left it
  Analyses& analyses() { return *analyses_; }
  /// The options of the plan's first evaluator of overdraw, or the defaults of all.
  OverdrawOptions overdraw_options() const;

  std::vector<std::vector<OutputFile>>& files() { return files_; }  ///< [output]; none: they are written already
  bool is_recalled() const { return is_recalled_; }
  const std::string& report_json() const { return json_; }  ///< if the job was recalled or kept
  const std::string& report_text() const { return text_; }  ///< if it was recalled
  std::vector<std::filesystem::path> files_read() const;    ///< for the input, if the setup lists files
  std::vector<std::filesystem::path> files_sought() const;  ///< those that were only looked for, there or not

 private:
  bool end(JobStatus status);

  const JobSetup& setup_;
  JobKind kind_;
  std::string path_;
  std::shared_ptr<FilesRead> own_;  ///< files of the input; null: nobody asks
  Diagnostics diagnostics_;
  JobStatus status_ = JobStatus::done;
  Report report_;
  Scene before_, scene_;
  std::optional<Plan> plan_;
  std::optional<Analyses> analyses_;
  std::vector<std::vector<OutputFile>> files_;
  bool is_recalled_ = false;
  std::string json_, text_;
  std::vector<std::filesystem::path> recalled_read_, recalled_sought_;
};

}  // namespace foredraw
