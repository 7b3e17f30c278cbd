#pragma once
// A sequence of draws for a subject that was seen: found by most of the looks, judged by the others. Source: own.

#include <foredraw/overdraw/draw_sequence.h>
#include <foredraw/overdraw/subject_layers.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// A sequence beside the one there was.
struct JudgedSequence {
  std::vector<std::uint32_t> sequence;  ///< [rank] = part
  /// Of the looks that decided nothing: what draws overdraw of one another. What a draw overdraws of itself is for
  /// whoever orders its triangles, and is left out.
  ViewTally before, after;
};

/// The sequence of the subject's parts that shades least in four looks of five, and what the fifth looks say of it.
/// With less than five looks none judges, and both tallies are empty. Every draw of `seen` is one atom. O(n log n) of
/// what the layers hold, and what draw_sequence() takes.
JudgedSequence judged_sequence(const SubjectLayers& seen, std::uint32_t parts, std::span<const PartGroup> groups,
                               const DrawSequenceOptions& options, const Executor& executor);

struct Plugin;
Plugin draw_sequence_plugin();

}  // namespace foredraw
