#include <foredraw/c/checked_input.h>

#include <algorithm>
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

/// Writes the indices by a number for each vertex, if all of these fit into the indices' bytes; else nothing.
int renumber(void* to, const foredraw_triangles& triangles, std::span<const std::uint32_t> indices,
             std::span<const std::uint32_t> new_of) {
  std::vector<std::uint32_t> numbered;
  numbered.reserve(indices.size());
  for (const std::uint32_t index : indices) {
    if (triangles.index_bytes < 4 && new_of[index] >> (8 * triangles.index_bytes) != 0) return FOREDRAW_TOO_LARGE;
    numbered.push_back(new_of[index]);
  }
  write_indices(to, triangles.index_bytes, numbered);
  return FOREDRAW_DONE;
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
    return renumber(renumbered, *triangles, checked.indices(), new_of);
  });
}

int foredraw_move_vertices(void* moved, const foredraw_triangles* triangles, const uint32_t* destination) {
  return with_triangles(triangles, moved, [&](const CheckedTriangles& checked) -> int {
    if (checked.triangle_count() == 0) return FOREDRAW_DONE;
    if (destination == nullptr) return FOREDRAW_NULL_POINTER;
    constexpr std::uint32_t nowhere = 0xffffffff;
    const bool is_left_out =
        std::ranges::any_of(checked.indices(), [&](std::uint32_t index) { return destination[index] == nowhere; });
    if (is_left_out) return FOREDRAW_NO_ORDER;
    return renumber(moved, *triangles, checked.indices(), {destination, checked.vertex_count()});
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
