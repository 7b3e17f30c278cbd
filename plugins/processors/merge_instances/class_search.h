#pragma once
// Several frequencies at once, each mesh at the one where it costs least.

#include "frequency_candidates.h"

#include <functional>

namespace foredraw::processors::merge_instances {

struct ClassSearch {
  std::vector<std::uint32_t>
      frequencies;  ///< rising, different; as many as were asked for, or fewer where that is as good
  double cost = 0;
  double bound = 0;  ///< no choice costs less; == cost where the search came to its end
};

/// Up to `classes` frequencies of least cost for all; sizes as distinct_sizes() gives them, not empty.
///
/// By branch and bound over ranges of candidates: the costs that each mesh has at best anywhere in a range bound those
/// of every choice from these ranges. Two classes are searched to the end; more for `most_steps` looks at a mesh. Where
/// the sizes have millions of candidates times sizes between them, only some of the large ones are searched, and
/// `bound` is no more than one slot for each mesh; the steps then limit two classes too. Deterministic: the work is
/// counted, not timed.
ClassSearch search_classes(std::span<const MeshSize> sizes, std::uint32_t multiple, std::uint32_t classes,
                           const Prices& prices, std::uint64_t most_steps);

/// Calls look(frequencies) for choices of `classes` frequencies that may cost less than `below`, the most promising
/// first; it answers with what further ones have to be below. For `most_steps`, of which a look takes 32 for each mesh;
/// answers whether all were looked at.
bool visit_choices(std::span<const MeshSize> sizes, std::uint32_t multiple, std::uint32_t classes, const Prices& prices,
                   std::uint64_t most_steps, double below,
                   const std::function<double(std::span<const std::uint32_t>)>& look);

}  // namespace foredraw::processors::merge_instances
