#pragma once
// The frequencies among which the best ones are.

#include "frequency.h"

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw::processors::merge_instances {

/// What a choice is judged by: padded entries and slots, each with its price.
struct Prices {
  double padded = 0;
  double slot = 0;
};

/// One mesh at a frequency.
inline double cost_of(const MeshSize& mesh, std::uint32_t frequency, const Prices& prices) {
  const auto slots = static_cast<double>(slots_of(mesh.indices, frequency));
  const double padded = slots * frequency - static_cast<double>(mesh.indices);
  return static_cast<double>(mesh.placed) * (padded * prices.padded + slots * prices.slot);
}

/// Sizes that are equal made one, rising; those without indices or placements left out.
std::vector<MeshSize> distinct_sizes(std::span<const MeshSize> meshes);

/// All multiples between two frequencies at which a minimum of the cost can lie, rising.
///
/// As long as no mesh's number of slots changes, a larger frequency only pads more. So the cost is least at the
/// smallest frequency of such a stretch, and there some mesh of n entries just needs k slots, and would need more if
/// the frequency were one multiple smaller: it is ceil(n / k), rounded up to the multiple. The same holds for each
/// class of several, by the meshes in it. The numbers of slots that matter are between n / most and n / least.
std::vector<std::uint32_t> frequency_candidates(std::span<const MeshSize> sizes, std::uint32_t multiple,
                                                std::uint32_t least, std::uint32_t most);

/// The frequency of least cost for all; sizes as distinct_sizes() gives them, not empty. Of equals the smallest.
std::uint32_t best_frequency(std::span<const MeshSize> sizes, std::uint32_t multiple, const Prices& prices);

}  // namespace foredraw::processors::merge_instances
