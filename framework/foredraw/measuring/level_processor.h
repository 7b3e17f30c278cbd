#pragma once
#include <foredraw/technique/level_maker.h>
#include <foredraw/technique/plugin.h>

namespace foredraw {

struct LevelProcessorOptions {
  int samples = 4096;  ///< points on each surface that distances are measured from
};

/// The processor that a maker of levels is: asks it for each subject, many at once, checks what it answers and measures
/// each level's distance from full detail (figures "error.largest", which is proved, "error.found" and "error.rms"; a
/// note where a point that is found is farther than was said). Each level's error is the greatest of what was said,
/// what is proved and that of the level before: errors never fall. Draws that have levels stay as they are. An answer
/// that is none, such as an index that names no vertex, fails the stage.
std::unique_ptr<Processor> level_processor(std::unique_ptr<const LevelMaker> maker, LevelProcessorOptions options = {});

/// Figures that such a processor measures, for its card.
std::vector<Metric> level_metrics();

}  // namespace foredraw
