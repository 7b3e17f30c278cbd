#pragma once
#include <foredraw/modules/foreign_runner.h>
#include <foredraw/technique/plugin.h>

#include <string>
#include <vector>

namespace foredraw {

/// What is known of a foreign technique besides its card.
struct ForeignKind {
  std::uint32_t kind = 0;  ///< FOREDRAW_TRIANGLE_ORDERER and so on
  std::vector<OptionSpec> options;
  std::vector<Metric> metrics;
};

/// The technique with these settings. What it answers is an answer as far as its size goes; the stage runner checks the
/// rest, as of every technique.
Technique foreign_technique(const ForeignKind& kind, const Settings& settings,
                            std::shared_ptr<const ForeignRunner> runner);

/// Text of foreign code as it may be shown: its first 4000 bytes, those that are no UTF-8 marked. NULL: empty.
std::string text_from_c(const char* text);

}  // namespace foredraw
