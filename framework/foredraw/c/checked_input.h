#pragma once
// What C hands over, checked and as the plain functions take it; and the border that no exception crosses.

#include <foredraw/c/functions.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <span>
#include <vector>

namespace foredraw::c {

/// A triangle list as 32-bit indices. Those of the caller's that are so already are taken in place.
class CheckedTriangles {
 public:
  /// Says by status() what is wrong. The caller's memory has to stay as long as this.
  explicit CheckedTriangles(const foredraw_triangles* triangles) : status_(take(triangles)) {}

  int status() const { return status_; }
  std::span<const std::uint32_t> indices() const { return indices_; }
  std::size_t triangle_count() const { return indices_.size() / 3; }
  std::size_t vertex_count() const { return vertex_count_; }

 private:
  int take(const foredraw_triangles* triangles);

  std::vector<std::uint32_t> widened_;
  std::span<const std::uint32_t> indices_;
  std::size_t vertex_count_ = 0;
  int status_;  // last: found by what fills the others
};

/// Whether `order` names each of so many once at most, and nothing else: FOREDRAW_NO_ORDER if not.
int order_status(std::span<const std::uint32_t> order, std::size_t count);

/// Whether the offsets begin with 0 and rise: FOREDRAW_NO_CLUSTERS if not. At least one.
int offsets_status(std::span<const std::uint32_t> offsets);

/// Whether there are positions of so many vertices.
inline int positions_status(const foredraw_positions* positions, std::size_t count) {
  return count > 0 && (positions == nullptr || positions->first == nullptr) ? FOREDRAW_NULL_POINTER : FOREDRAW_DONE;
}

/// Elements of `stride` bytes from one to the next (0: none between them), one behind the other.
template <class Element>
std::vector<Element> elements_at(const void* first, std::size_t stride, std::size_t count) {
  std::vector<Element> elements(count);
  const auto* from = static_cast<const std::byte*>(first);
  for (std::size_t i = 0; i < count; ++i) {
    std::memcpy(&elements[i], from + i * (stride == 0 ? sizeof(Element) : stride), sizeof(Element));
  }
  return elements;
}

/// Writes indices, one behind the other, with so many bytes each. They fit.
void write_indices(void* to, std::uint32_t bytes, std::span<const std::uint32_t> indices);

/// Whether an image can be read.
inline int alpha_status(const foredraw_alpha* image) {
  constexpr std::uint32_t most = 32768;
  if (image == nullptr || image->first == nullptr) return FOREDRAW_NULL_POINTER;
  const bool is_good = image->width >= 1 && image->height >= 1 && (image->bytes == 1 || image->bytes == 2);
  if (!is_good) return FOREDRAW_OPTION_RANGE;
  return image->width > most || image->height > most ? FOREDRAW_TOO_LARGE : FOREDRAW_DONE;
}

/// The numbers of its texels, row after row, 0 to 65535.
std::vector<std::uint16_t> numbers_of(const foredraw_alpha& image);

/// Calls work(), which returns a status, with exceptions turned into one. Memory is all that the functions throw for.
template <class Work>
int guarded(Work work) noexcept {
  try {
    return work();
  } catch (...) {
    return FOREDRAW_NO_MEMORY;
  }
}

/// The same of work(triangles), if these are in order and `output` has room for what it writes.
template <class Work>
int with_triangles(const foredraw_triangles* triangles, const void* output, Work work) noexcept {
  return guarded([&]() -> int {
    const CheckedTriangles checked(triangles);
    if (checked.status() != FOREDRAW_DONE) return checked.status();
    if (output == nullptr && checked.triangle_count() > 0) return FOREDRAW_NULL_POINTER;
    return work(checked);
  });
}

/// An option of which 0 means the default; FOREDRAW_OPTION_RANGE where it is out of bounds.
inline int take_option(std::uint32_t value, std::uint32_t least, std::uint32_t most, int& option) {
  if (value == 0) return FOREDRAW_DONE;
  if (value < least || value > most) return FOREDRAW_OPTION_RANGE;
  option = static_cast<int>(value);
  return FOREDRAW_DONE;
}

}  // namespace foredraw::c
