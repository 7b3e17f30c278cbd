#pragma once
#include <foredraw/technique/orderer.h>

namespace foredraw {

/// Notes what several orders of a subject take, beside one for each keyframe; nothing where one is always drawn.
void note_order_memory(const SubjectView& view, const SubjectOrders& answer, const Run& run);

}  // namespace foredraw
