#pragma once
// Milestones of runs, kept in a cache by the content of every file that was read on the way.

#include <foredraw/cache/results.h>
#include <foredraw/pipeline/milestones.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace foredraw {

/// Of a pipeline: all that decides what its stages come to, but for the file that is worked on.
struct MilestoneKeys {
  std::vector<Stamp> stages;  ///< [number] of this stage and all before it; disabled ones have none
  Stamp measures;             ///< of the evaluators, and of how many stages there are, of which their seeds come
};

/// Of one run, on the thread that it began on.
class KeptMilestones final : public Milestones {
 public:
  struct Surroundings {
    const Cache& cache;
    const MilestoneKeys& keys;
    std::filesystem::path input;
    std::shared_ptr<const FilesRead> own;   ///< is told what is read for the input
    std::shared_ptr<const FilesRead> lent;  ///< and for options
    std::function<void(const Diagnostics&)> damaged;
    std::function<void(const std::string&)> not_kept;  ///< why
    /// What is kept has taken so many times the time of a processor that keeping it takes. 0: all is kept.
    double least_gain = 20;
  };

  explicit KeptMilestones(Surroundings surroundings) : surroundings_(std::move(surroundings)) {}

  std::optional<Milestone> furthest(const Plan& plan, const Scene& input) override;
  std::string reached(const Plan& plan, const Milestone& milestone) override;

  /// What was read for the input by the run that left the milestone that this one began at.
  const std::vector<FileRead>& read_before() const { return read_before_; }

 private:
  Work work_behind(std::size_t stages) const;

  Surroundings surroundings_;
  Scene input_;
  std::vector<FileRead> read_before_;
  double kept_last_ = 0;  ///< thread_seconds() then
};

}  // namespace foredraw
