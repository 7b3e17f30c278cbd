#pragma once
// Ranges of triangles that orders must not cross, because a product counts on where they lie. Whoever orders or
// clusters is handed each range as a draw of its own; what it answers is joined, so that no triangle ever leaves its
// range.

#include <foredraw/scene/product_row.h>
#include <foredraw/technique/clusterer.h>
#include <foredraw/technique/orderer.h>

namespace foredraw {

/// A scene in which each range is a draw. A draw's first range has the draw's number; others stand behind all draws.
struct RangedScene {
  Scene scene;
  std::vector<std::vector<DrawId>> ranges;  ///< [draw] in sequence, one at least

  /// `scene`: at_level() of `whole`, whose products have the bounds. Nothing where no draw has any.
  static std::optional<RangedScene> of(const Scene& scene, const Scene& whole, std::size_t level,
                                       const ProductRows& rows);
};

/// Cuts clusters that were there before the product, so that none lies across a bound.
void cut_clusters(Scene& scene, const ProductRows& rows);

/// What the technique answers for the draw, range by range. What it keeps stays as it is in that range; it keeps the
/// draw where it keeps every range. std::runtime_error where an answer is none for its range.
IndexOrder order_of(const DrawOrderer& technique, DrawId draw, const RangedScene& in, Run& run);
Clusters clusters_of(const Clusterer& technique, DrawId draw, const RangedScene& in, Run& run);

/// A subject's ranges are parts of it, drawn one behind the other.
SubjectOrders orders_of(const SubjectOrderer& technique, const SubjectView& subject, const RangedScene& in, Run& run);

}  // namespace foredraw
