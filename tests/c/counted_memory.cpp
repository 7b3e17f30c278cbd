#include "counted_memory.h"

void* operator new(std::size_t size) { return foredraw::testing::allocate(size); }
void* operator new[](std::size_t size) { return foredraw::testing::allocate(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return foredraw::testing::allocate_or_not(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return foredraw::testing::allocate_or_not(size);
}
void operator delete(void* memory) noexcept { foredraw::testing::release(memory); }
void operator delete[](void* memory) noexcept { foredraw::testing::release(memory); }
void operator delete(void* memory, std::size_t) noexcept { foredraw::testing::release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { foredraw::testing::release(memory); }
