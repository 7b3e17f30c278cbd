#pragma once

namespace foredraw {

/// Seconds that the calling thread has spent on a processor. Unlike time on the clock, it does not grow with what else
/// the machine does.
double thread_seconds();

}  // namespace foredraw
