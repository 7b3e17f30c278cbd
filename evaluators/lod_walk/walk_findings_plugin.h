#pragma once
// What a walk found, as figures, notes, charts and films of a run.

#include "lod_walk.h"

#include <foredraw/technique/run.h>

#include <vector>

namespace foredraw {

/// Of all methods; the scene's own figures are those of the last one.
void report_walk(const LodWalk& walk, const Run& run);

/// What was drawn by all methods, where there was a timer.
std::vector<FrameSample> samples_of(const LodWalk& walk);

}  // namespace foredraw
