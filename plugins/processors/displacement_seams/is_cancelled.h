#pragma once
#include <atomic>

namespace foredraw::processors::displacement_seams {

/// Whether somebody wants what runs to end. Null: nobody can.
inline bool is_cancelled(const std::atomic<bool>* cancel) {
  return cancel != nullptr && cancel->load(std::memory_order_relaxed);
}

}  // namespace foredraw::processors::displacement_seams
