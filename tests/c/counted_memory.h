#pragma once
// Memory that runs out when it is told to, for a program that has counted_memory.cpp among its sources: operators new
// and delete are its own, and those of the libraries that it links.

#include <cstdlib>
#include <new>

namespace foredraw::testing {

inline long left = -1;  ///< allocations that succeed; negative: all do
inline long held = 0;   ///< allocations less releases since counting began

inline void* allocate(std::size_t size) {
  if (left == 0) throw std::bad_alloc();
  if (left > 0) --left;
  ++held;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}

inline void* allocate_or_not(std::size_t size) noexcept {
  try {
    return allocate(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

inline void release(void* memory) noexcept {
  if (memory != nullptr) --held;
  std::free(memory);
}

}  // namespace foredraw::testing
