#pragma once
// The fewest slots that given frequencies need where padding has a limit.

#include "frequency.h"

#include <optional>

namespace foredraw::processors::merge_instances {

struct LimitedSlots {
  std::uint64_t slots = 0;
  std::vector<std::uint8_t> size_class;  ///< [size] the frequency's number
  bool proven = true;                    ///< no other assignment needs fewer
};

/// All meshes of a size go to one of the frequencies (rising, 1 to 4), so that all pad `most_padded` entries together
/// at most: a knapsack, in which room for padding buys slots. Exact for two frequencies, but for knapsacks that take
/// more than some thousand steps; for more the best gains for their room are taken first. Nothing where no assignment
/// is below `fewer_than` slots, or none is found.
std::optional<LimitedSlots> limited_slots(std::span<const MeshSize> sizes, std::span<const std::uint32_t> frequencies,
                                          std::uint64_t most_padded, std::uint64_t fewer_than);

}  // namespace foredraw::processors::merge_instances
