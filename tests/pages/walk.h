#pragma once
// An evaluator that attaches what a page shows frame by frame.

#include <foredraw/technique/plugin.h>

namespace foredraw::testing {

/// Of `frames` frames: charts "cost" (in ms, with a mark at 10 and a gap at frames 10 to 12) and "switches"; films
/// "steady", whose pictures are as grey as 10 times the number of the frame, and "<b>eager</b>", which are as red. And
/// "portrait", one picture of the first draw. Costs hang on the number of triangles.
Plugin walk_plugin();

}  // namespace foredraw::testing
