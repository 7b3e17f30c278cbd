#pragma once
// Several orders for the draws of a subject, and which of them serves where: looks (a pose seen from a direction) are
// given to the order that draws them with least overdraw, and each order is made anew for the looks that it serves, in
// turn. The alternation is that of Han, Sander: Triangle Reordering for Reduced Overdraw in Animated Scenes, I3D 2016,
// section 3; the orders are occlusion_order's.

#include "occlusion_order.h"

#include <foredraw/base/parallel.h>
#include <foredraw/overdraw/k_sequences.h>

namespace foredraw {

struct KOrders {
  /// [order][draw][rank] = atom. The first is the one that serves best where there may be only one.
  std::vector<std::vector<std::vector<std::uint32_t>>> orders;
  std::vector<std::vector<std::uint32_t>> sequences;  ///< [order][rank] = part; none: as they came
  std::vector<std::uint8_t> serving;                  ///< [look] which order
  std::vector<OverdrawCount> counts;                  ///< [look] drawn in it
};

struct KOrdersOptions : OcclusionOrderOptions {
  /// What a vertex weighs beside a fragment: who shades a hundredth more of all vertices has to save so many hundredths
  /// of all visible fragments, or it is not done. 0: whatever the budget allows is spent.
  double vertex_weight = 0.1;
  int k = 1;               ///< 1 to 255; those beyond the looks serve nothing
  std::uint64_t seed = 0;  ///< of the directions by which looks are parted to begin with
  int restarts = 0;        ///< so often it begins anew, parted by other directions; the best of all goes on
  int rounds = 30;         ///< of each start, at most
};

/// So many an order is made for: of a character, four times as many lower its overdraw by less than a hundredth more.
std::size_t most_looks(OcclusionQuality quality);

/// `sequences`: as many as orders, each of which is made for one of them. None: parts are drawn as they came.
KOrders k_orders(const SubjectLayers& subject, const KOrdersOptions& options, const Executor& executor,
                 const KSequences* sequences = nullptr);

}  // namespace foredraw
