#pragma once
// In which sequence the parts of a subject shade least: those first that hide others. Source: own; one start is by the
// greedy rule of Eades, Lin, Smyth: A fast and effective heuristic for the feedback arc set problem, 1993.

#include <foredraw/base/parallel.h>
#include <foredraw/overdraw/part_lists.h>
#include <foredraw/scene/part_groups.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

struct DrawSequenceOptions {
  int restarts = 8;  ///< random sequences that the search starts from besides, 0 at least
  std::uint64_t seed = 0;
};

/// The sequence, [rank] = part, that shades least of what the lists hold, as far as a local search finds it. Only runs
/// of groups change places, and none for nothing. The search starts from the sequence as it is, from its reverse, from
/// the one by feedback arcs and from random ones. It moves one run at a time to where least is shaded, until no move
/// saves anything; the best of all starts stays. The same at any number of threads. A round over all runs takes O(what
/// the lists hold * depth of groups + runs^2 of each group), and few rounds do; the arcs take O(lists * length^2 +
/// runs^2) for each group.
std::vector<std::uint32_t> draw_sequence(const PartLists& lists, std::span<const PartGroup> groups,
                                         const DrawSequenceOptions& options, const Executor& executor);

}  // namespace foredraw
