#pragma once
#include <foredraw/base/parallel.h>

namespace foredraw {

/// Whoever asks for work does it, one task after the other.
inline Executor on_this_thread() {
  return Executor(1, [](std::size_t count, const std::function<void(std::size_t)>& task) {
    for (std::size_t i = 0; i < count; ++i) task(i);
  });
}

}  // namespace foredraw
