#pragma once
// Figures of thousands of files: in columns, of which the script makes a table and histograms.

#include <foredraw/report/comparison.h>

#include <span>
#include <string>

namespace foredraw {

/// JSON: {files: [path], states: ["input", "[1] NAME"], figures: [{evaluator, metric, unit, lower-is-better, is-count,
/// values: [state][file]}]}. A value in six digits; null where there is none.
std::string file_figures(std::span<const Comparison> comparisons);

}  // namespace foredraw
