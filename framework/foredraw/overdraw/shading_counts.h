#pragma once
#include <foredraw/overdraw/fragment_layers.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// Where the overdraw of an order comes from.
struct OverdrawDetails {
  std::vector<std::uint64_t> hidden;           ///< [triangle] its fragments that pass and do not stay
  std::vector<std::uint64_t> pixels_by_times;  ///< [n] pixels that are shaded n times, of all views; [0] is 0
};

/// From the layers, without drawing: order[rank] = triangle. std::invalid_argument where the order is no permutation.
OverdrawDetails overdraw_details(const FragmentLayers& layers, std::span<const std::uint32_t> order);

}  // namespace foredraw
