#pragma once
// Several sequences for the parts of a subject, and which of them serves where. Looks are given to the sequence that
// shades least there, and each sequence is made anew for the looks that it serves, in turn, as in Han, Sander: Triangle
// Reordering for Reduced Overdraw in Animated Scenes, I3D 2016, section 3. The sequences are draw_sequence()'s.

#include <foredraw/overdraw/draw_sequence.h>
#include <foredraw/overdraw/subject_layers.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

struct KSequences {
  std::vector<std::vector<std::uint32_t>> sequences;  ///< [number][rank] = part
  std::vector<std::uint8_t> serving;                  ///< [look] which one shades least there
  /// Of the looks that decided nothing: as the parts came, and each in the sequence that serves the nearest look of its
  /// pose that decided. What a part overdraws of itself is left out.
  ViewTally before, after;
};

struct KSequencesOptions {
  int k = 2;        ///< 1 to 255
  int starts = 4;   ///< so often looks are parted by other directions to begin with; the best start stays
  int rounds = 20;  ///< of each start, at most
  std::uint64_t seed = 0;
};

/// Made by four looks of five and judged by the fifth. Runs of groups change places, and nothing else. Where there are
/// fewer looks than judge, both tallies are empty. The same at any number of threads. O(starts * rounds * what
/// draw_sequence() takes).
KSequences k_sequences(const SubjectLayers& seen, std::uint32_t parts, std::span<const PartGroup> groups,
                       const KSequencesOptions& options, const Executor& executor);

}  // namespace foredraw
