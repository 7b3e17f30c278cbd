// Wherever memory runs out, the functions say so; nothing leaks, and no exception comes out.

#include <foredraw/c/functions.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <new>

namespace {

long left = -1;  ///< allocations that succeed; negative: all do
long held = 0;   ///< allocations less releases since counting began

void* allocate(std::size_t size) {
  if (left == 0) throw std::bad_alloc();
  if (left > 0) --left;
  ++held;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

// The library's as well: the program comes first when names are looked up.
void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void operator delete(void* memory) noexcept {
  if (memory != nullptr) --held;
  std::free(memory);
}
void operator delete[](void* memory) noexcept { operator delete(memory); }
void operator delete(void* memory, std::size_t) noexcept { operator delete(memory); }
void operator delete[](void* memory, std::size_t) noexcept { operator delete(memory); }

namespace {

/// Calls it with ever more allocations that succeed, until it is done.
void expect_survives(const std::function<int()>& call) {
  int failed = 0;
  for (long allowed = 0;; ++allowed) {
    const long before = held;
    left = allowed;
    const int status = call();
    left = -1;
    ASSERT_EQ(held, before);
    if (status == FOREDRAW_DONE) break;
    ASSERT_EQ(status, FOREDRAW_NO_MEMORY);
    ++failed;
  }
  EXPECT_GT(failed, 0);
}

TEST(WithoutMemory, FunctionsSayThatItRanOut) {
  std::uint16_t indices[300];
  std::uint32_t order[100], offsets[101], sequence[100], clusters = 0;
  float positions[300];
  for (int i = 0; i < 300; ++i)
    indices[i] = static_cast<std::uint16_t>(i * 37 % 100), positions[i] = static_cast<float>(i);
  const foredraw_triangles list{indices, 300, 2, 100};
  const foredraw_positions places{positions, 0};
  foredraw_vertex_cache_figures figures;
  expect_survives([&] { return foredraw_tipsify(order, &list, 0); });
  expect_survives([&] { return foredraw_forsyth(order, &list, 0); });
  expect_survives([&] { return foredraw_lookahead(order, &list, FOREDRAW_LOOKAHEAD_HIGH, 0, 0); });
  expect_survives([&] { return foredraw_linear_clusters(offsets, &clusters, &list, 0, 0); });
  expect_survives([&] { return foredraw_dot_rule(sequence, &list, &places, offsets, clusters); });
  expect_survives([&] { return foredraw_order_of_clusters(order, offsets, clusters, sequence); });
  expect_survives([&] { return foredraw_vertex_fetch(order, nullptr, &list); });
  expect_survives([&] { return foredraw_renumber_vertices(indices, &list, order); });
  expect_survives([&] { return foredraw_vertex_cache(&figures, &list, 0); });
}

}  // namespace
