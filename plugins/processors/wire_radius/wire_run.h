#pragma once
// The part of a chain that is a wire.

#include "chain.h"
#include "wire_radius.h"

#include <optional>

namespace foredraw::processors::wire_radius {

/// Sections first to last of a chain.
struct WireRun {
  std::size_t first = 0, last = 0;
  double length = 0, half_width = 0;  ///< half the least width, on average over the length
  double mean_width = 0;
  WireKind kind = WireKind::tube;
  bool closed = false;
};

/// The longest run whose widths are alike but for `taper`. Nothing where the chain has no length.
std::optional<WireRun> longest_run(const Chain& chain, double taper);

/// Why it is no wire by its shape; nothing: it is one.
std::optional<WireRefusal> shape_refusal(const Chain& chain, const WireRun& run, const WireOptions& options);

}  // namespace foredraw::processors::wire_radius
