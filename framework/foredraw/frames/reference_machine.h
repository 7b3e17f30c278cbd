#pragma once
#include <foredraw/frames/calibration.h>

namespace foredraw {

/// The reference renderer on one thread of this processor, with a colour image and a normal map on all surfaces. What
/// it draws is made at the first ask and kept. Times are those that the processor worked for this process: other
/// threads of it should rest meanwhile.
MeasuredMachine reference_machine();

}  // namespace foredraw
