#include <foredraw/c/checked_input.h>

#include <cstring>

namespace foredraw::c {

namespace {

/// Triangles or vertices, `bytes` each, gathered by their order.
void gather(void* to, const void* from, std::size_t bytes, std::span<const std::uint32_t> order) {
  auto* next = static_cast<std::byte*>(to);
  for (const std::uint32_t old : order) {
    std::memcpy(next, static_cast<const std::byte*>(from) + old * bytes, bytes);
    next += bytes;
  }
}

template <class Index>
void renumber(void* to, std::span<const std::uint32_t> indices, std::span<const std::uint32_t> new_of) {
  auto* next = static_cast<std::byte*>(to);
  for (const std::uint32_t index : indices) {
    const auto narrow = static_cast<Index>(new_of[index]);
    std::memcpy(next, &narrow, sizeof narrow);
    next += sizeof narrow;
  }
}

}  // namespace

}  // namespace foredraw::c

using namespace foredraw::c;

int foredraw_reorder_triangles(void* reordered, const foredraw_triangles* triangles, const uint32_t* order) {
  return with_triangles(triangles, reordered, [&](const CheckedTriangles& checked) -> int {
    const std::size_t count = checked.triangle_count();
    if (count == 0) return FOREDRAW_DONE;
    if (order == nullptr) return FOREDRAW_NULL_POINTER;
    if (const int status = order_status({order, count}, count); status != FOREDRAW_DONE) return status;
    gather(reordered, triangles->indices, 3 * std::size_t{triangles->index_bytes}, {order, count});
    return FOREDRAW_DONE;
  });
}

int foredraw_renumber_vertices(void* renumbered, const foredraw_triangles* triangles, const uint32_t* order) {
  return with_triangles(triangles, renumbered, [&](const CheckedTriangles& checked) -> int {
    const std::size_t count = checked.vertex_count();
    if (count == 0) return FOREDRAW_DONE;
    if (order == nullptr) return FOREDRAW_NULL_POINTER;
    if (const int status = order_status({order, count}, count); status != FOREDRAW_DONE) return status;
    std::vector<std::uint32_t> new_of(count);
    for (std::uint32_t i = 0; i < count; ++i) new_of[order[i]] = i;
    // An index of few bytes may get a number that these cannot hold.
    if (triangles->index_bytes < 4) {
      for (const std::uint32_t index : checked.indices()) {
        if (new_of[index] >> (8 * triangles->index_bytes) != 0) return FOREDRAW_TOO_LARGE;
      }
    }
    if (triangles->index_bytes == 1) renumber<std::uint8_t>(renumbered, checked.indices(), new_of);
    if (triangles->index_bytes == 2) renumber<std::uint16_t>(renumbered, checked.indices(), new_of);
    if (triangles->index_bytes == 4) renumber<std::uint32_t>(renumbered, checked.indices(), new_of);
    return FOREDRAW_DONE;
  });
}

int foredraw_reorder_elements(void* reordered, const void* elements, uint64_t element_count, uint32_t bytes,
                              const uint32_t* order, uint64_t count) {
  return guarded([&]() -> int {
    if (count == 0) return FOREDRAW_DONE;
    if (reordered == nullptr || elements == nullptr || order == nullptr) return FOREDRAW_NULL_POINTER;
    if (count > element_count) return FOREDRAW_NO_ORDER;
    if (element_count > std::uint64_t{1} << 32) return FOREDRAW_TOO_LARGE;
    const std::span<const std::uint32_t> used(order, static_cast<std::size_t>(count));
    if (const int status = order_status(used, element_count); status != FOREDRAW_DONE) return status;
    gather(reordered, elements, bytes, used);
    return FOREDRAW_DONE;
  });
}
