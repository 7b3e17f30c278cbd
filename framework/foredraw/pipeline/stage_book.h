#pragma once
// What one stage came to, written down: figures, notes, attachments, what was left alone, what failed.

#include <foredraw/pipeline/plan.h>
#include <foredraw/technique/run.h>

#include <string>
#include <vector>

namespace foredraw {

/// Places are names of draws or subjects; empty: the scene.
class StageBook {
 public:
  /// `number`: the stage's in the pipeline, from 1. `scene`: as it is while the stage works on it.
  StageBook(const PlannedStage& stage, std::size_t number, const Plan& plan, const Scene& scene, StageRecord& record,
            Diagnostics& diagnostics)
      : stage_(stage), number_(number), plan_(plan), scene_(scene), record_(record), diagnostics_(diagnostics) {}

  void changed_one() { ++record_.changed; }
  /// One more that is left alone; those with the same reason stand together.
  void skip(const std::string& code, const std::string& reason, const std::string& place);
  void failed(const std::string& why, const std::string& place);
  /// Notes and attachments call draws what they were called before the stage; those that it added are in `changed`.
  void found(Findings& findings, const std::string& place, const Scene& changed);
  /// All figures, in the order in which they were found.
  std::vector<Measured>& measured() { return measured_; }

 private:
  std::string name_of_subject(std::uint32_t number) const;

  const PlannedStage& stage_;
  std::size_t number_;
  const Plan& plan_;
  const Scene& scene_;
  StageRecord& record_;
  Diagnostics& diagnostics_;
  std::vector<Measured> measured_;
};

}  // namespace foredraw
