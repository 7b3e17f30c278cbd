#pragma once
// What figures may not become: bounds for whoever holds assets to a budget.

#include <foredraw/base/diagnostics.h>
#include <foredraw/report/baseline.h>
#include <foredraw/report/comparison.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace foredraw {

/// "overdraw-raster.ratio > baseline * 1.01": a figure that is so is out of bounds.
struct Bound {
  enum class Than { above, from, below, to };  ///< > >= < <=
  enum class Beside { nothing, baseline, input };

  std::string text;    ///< as it was written
  std::string figure;  ///< EVALUATOR.METRIC of the totals, or "time": the seconds of all stages
  Than than = Than::above;
  Beside beside = Beside::nothing;
  double factor = 0;  ///< of what it stands beside
  double added = 0;   ///< the limit where it stands beside nothing
};

/// FIGURE (> | >= | < | <=) LIMIT; LIMIT: a number, or (baseline | input) [* NUMBER] [(+ | -) NUMBER]. Nothing where it
/// is none; a diagnostic says what was expected where.
std::optional<Bound> parse_bound(const std::string& text, Diagnostics& diagnostics);

/// Tells of every figure that is out of bounds (`out-of-bounds`), and of those that nobody measured (`unknown-figure`),
/// as errors, file by file. The baseline is the first pipeline, which then is not judged beside itself; or, where there
/// are some, the stored figures of the file of that path, else of that name.
void judge(std::span<const Bound> bounds, std::span<const Comparison> comparisons, const Baseline* stored,
           Diagnostics& diagnostics);

}  // namespace foredraw
