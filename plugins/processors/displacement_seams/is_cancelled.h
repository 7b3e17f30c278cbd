#pragma once
#include <atomic>

namespace foredraw::seams {

/// Whether somebody wants what runs to end. Null: nobody can.
inline bool is_cancelled(const std::atomic<bool>* cancel) {
  return cancel != nullptr && cancel->load(std::memory_order_relaxed);
}

}  // namespace foredraw::seams
