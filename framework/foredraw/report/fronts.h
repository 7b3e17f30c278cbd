#pragma once
// Which branches no other one beats.

#include <foredraw/base/diagnostics.h>
#include <foredraw/report/comparison.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace foredraw {

/// The points that no other one is below in one figure without being above it in the other; equal ones all. Their
/// numbers, ascending. Figures that are no numbers are on no front.
std::vector<std::size_t> pareto_front(std::span<const std::pair<double, double>> points);

/// The branches of a comparison that none beats in both of two figures.
struct Front {
  std::string x, y;  ///< as value_of() names them
  std::vector<std::size_t> branches;
};

/// Those that were asked for; where none were, and there are three branches at least, what most people weigh against
/// each other: overdraw against ACMR and against time. Without those that nobody is on.
std::vector<Front> fronts_of(const Comparison& comparison);

/// Figures of the fronts that were asked for, and that no branch has.
std::vector<std::string> unknown_figures(const Comparison& comparison);

/// "time,overdraw-raster.ratio" as two figures. Nothing where the text has another form; a diagnostic says so.
std::optional<std::pair<std::string, std::string>> parse_front(const std::string& text, Diagnostics& diagnostics);

}  // namespace foredraw
