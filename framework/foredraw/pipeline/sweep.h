#pragma once
// One pipeline with an option at many values: what is best is looked for, not guessed.

#include <foredraw/pipeline/parse.h>

#include <span>
#include <string>
#include <vector>

namespace foredraw {

/// "linear-clusters.growth=1:1.5:0.05", from the first to the second in such steps, both included;
/// "lookahead.quality=fast,high", each of these.
struct Sweep {
  std::string option;               ///< as set_option() takes it
  std::vector<std::string> values;  ///< one at least
};

/// Nothing where the text has another form, has no values or more than 1000; a diagnostic says why.
std::optional<Sweep> parse_sweep(const std::string& text, Diagnostics& diagnostics);

/// Every pipeline once for each combination of the values, the last sweep's changing first, called "NAME with
/// growth=1.05, quality=high". A pipeline without the stage of a sweep is left out of it. Nothing where no pipeline has
/// the stage, a value does not fit, or there would be more than 1000 pipelines; a diagnostic says why.
std::optional<std::vector<NamedPipeline>> swept(std::vector<NamedPipeline> pipelines, std::span<const Sweep> sweeps,
                                                Diagnostics& diagnostics);

}  // namespace foredraw
