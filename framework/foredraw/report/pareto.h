#pragma once
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace foredraw {

/// The points that no other one is below in one figure without being above it in the other; equal ones all. Their
/// numbers, ascending. Figures that are no numbers are on no front.
std::vector<std::size_t> pareto_front(std::span<const std::pair<double, double>> points);

}  // namespace foredraw
