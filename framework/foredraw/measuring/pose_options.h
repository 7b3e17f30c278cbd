#pragma once
#include <foredraw/technique/options.h>
#include <foredraw/viewing/pose_set.h>

#include <concepts>

namespace foredraw {

/// The rows of a pose set, for options that derive from PoseSet.
template <class Options>
requires std::derived_from<Options, PoseSet>
void add_pose_rows(OptionTable<Options>& table) {
  table.number_or_text(
      &PoseSet::poses, "poses",
      "Which poses: auto (16 spread over the clips, sharing the views), bind (as the nodes of the file stand), all "
      "(every key of every clip), or a number: at most that many, spread over the clips");
  table.template row<std::string>(&PoseSet::clips, "clips", "Names of the clips to take poses from, with * and ?");
  table.template row<std::optional<double>>(&PoseSet::rate, "rate",
                                            "Instead of poses: this many per second, from each clip's first key on",
                                            {0.001, 1000, "poses a second"});
  table.template row<std::string>(
      &PoseSet::moments, "moments",
      "Instead of poses: these seconds of each clip that is long enough, such as '0 0.5 2'");
}

}  // namespace foredraw
