#include "draw_sequence.h"

#include <foredraw/overdraw/judging_looks.h>

#include <numeric>

namespace foredraw {

namespace {

/// Of a pixel of each look that judges, or of each that decides; 0 of the others.
std::vector<std::int64_t> weights_of(const SubjectLayers& seen, bool judging) {
  std::vector<std::int64_t> weights = pixel_weights(seen);
  for (std::size_t look = 0; look < weights.size(); ++look) {
    if (judges(look) != judging) weights[look] = 0;
  }
  return weights;
}

/// One fragment for each visible pixel, and those that parts draw where a nearer part comes later.
ViewTally tally_of(const SubjectLayers& seen, const PartLists& lists, std::span<const std::int64_t> weights,
                   std::span<const std::uint32_t> sequence) {
  ViewTally tally;
  for (std::size_t look = 0; look < weights.size(); ++look) {
    tally.visible += static_cast<double>(weights[look]) * static_cast<double>(seen.layers.views[look].always.visible);
  }
  const std::int64_t stay = std::accumulate(lists.weights.begin(), lists.weights.end(), std::int64_t{0});
  tally.shaded = tally.visible + static_cast<double>(fragments_shaded(lists, sequence) - stay);
  return tally;
}

}  // namespace

JudgedSequence judged_sequence(const SubjectLayers& seen, std::uint32_t parts, std::span<const PartGroup> groups,
                               const DrawSequenceOptions& options, const Executor& executor) {
  std::vector<std::uint32_t> part_of;
  for (const LayerOwner& owner : seen.owners) part_of.push_back(owner.part);
  const auto seen_with = [&](std::span<const std::int64_t> weights) {
    return part_lists(seen.layers, part_of, parts, weights);
  };
  JudgedSequence result;
  result.sequence = draw_sequence(seen_with(weights_of(seen, false)), groups, options, executor);
  std::vector<std::uint32_t> as_it_was(parts);
  std::iota(as_it_was.begin(), as_it_was.end(), 0u);
  const std::vector<std::int64_t> judging = weights_of(seen, true);
  const PartLists lists = seen_with(judging);
  result.before = tally_of(seen, lists, judging, as_it_was);
  result.after = tally_of(seen, lists, judging, result.sequence);
  return result;
}

}  // namespace foredraw
