#include <foredraw/c/checked_input.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <limits>

namespace foredraw::c {

namespace {

template <class Index>
void widen(const void* from, std::span<std::uint32_t> to) {
  const auto* bytes = static_cast<const std::byte*>(from);
  for (std::uint32_t& index : to) {
    Index narrow;
    std::memcpy(&narrow, bytes, sizeof narrow);
    index = narrow;
    bytes += sizeof narrow;
  }
}

template <class Index>
void narrow(void* to, std::span<const std::uint32_t> indices) {
  auto* next = static_cast<std::byte*>(to);
  for (const std::uint32_t index : indices) {
    const auto narrow = static_cast<Index>(index);
    std::memcpy(next, &narrow, sizeof narrow);
    next += sizeof narrow;
  }
}

bool is_aligned(const void* pointer) { return reinterpret_cast<std::uintptr_t>(pointer) % alignof(std::uint32_t) == 0; }

}  // namespace

int CheckedTriangles::take(const foredraw_triangles* triangles) {
  if (triangles == nullptr) return FOREDRAW_NULL_POINTER;
  const auto [indices, count, bytes, vertices] = *triangles;
  if (count % 3 != 0) return FOREDRAW_INDEX_COUNT;
  if (bytes != 1 && bytes != 2 && bytes != 4) return FOREDRAW_INDEX_BYTES;
  vertex_count_ = vertices;
  if (count == 0) return FOREDRAW_DONE;
  if (indices == nullptr) return FOREDRAW_NULL_POINTER;
  if (count / 3 > std::numeric_limits<std::uint32_t>::max()) return FOREDRAW_TOO_LARGE;
  if (bytes == 4 && is_aligned(indices)) {
    indices_ = {static_cast<const std::uint32_t*>(indices), static_cast<std::size_t>(count)};
  } else {
    widened_.resize(static_cast<std::size_t>(count));
    if (bytes == 1) widen<std::uint8_t>(indices, widened_);
    if (bytes == 2) widen<std::uint16_t>(indices, widened_);
    if (bytes == 4) widen<std::uint32_t>(indices, widened_);
    indices_ = widened_;
  }
  std::uint32_t largest = 0;  // without a branch for each index
  for (const std::uint32_t index : indices_) largest = std::max(largest, index);
  return largest < vertices ? FOREDRAW_DONE : FOREDRAW_INDEX_RANGE;
}

int order_status(std::span<const std::uint32_t> order, std::size_t count) {
  std::vector<bool> is_named(count);
  for (const std::uint32_t old : order) {
    if (old >= count || is_named[old]) return FOREDRAW_NO_ORDER;
    is_named[old] = true;
  }
  return FOREDRAW_DONE;
}

int offsets_status(std::span<const std::uint32_t> offsets) {
  const bool is_rising = std::ranges::adjacent_find(offsets, std::greater_equal()) == offsets.end();
  return offsets.front() == 0 && is_rising ? FOREDRAW_DONE : FOREDRAW_NO_CLUSTERS;
}

std::vector<std::uint16_t> numbers_of(const foredraw_alpha& image) {
  std::vector<std::uint16_t> numbers;
  numbers.reserve(std::size_t{image.width} * image.height);
  const std::size_t step = image.texel_stride == 0 ? image.bytes : image.texel_stride;
  const std::size_t row = image.row_stride == 0 ? image.width * step : image.row_stride;
  for (std::size_t y = 0; y < image.height; ++y) {
    const auto* texel = static_cast<const std::uint8_t*>(image.first) + y * row;
    for (std::size_t x = 0; x < image.width; ++x, texel += step) {
      std::uint16_t number = static_cast<std::uint16_t>(*texel * 257);  // 255 becomes 65535
      if (image.bytes == 2) std::memcpy(&number, texel, sizeof number);
      numbers.push_back(number);
    }
  }
  return numbers;
}

void write_indices(void* to, std::uint32_t bytes, std::span<const std::uint32_t> indices) {
  if (bytes == 1) narrow<std::uint8_t>(to, indices);
  if (bytes == 2) narrow<std::uint16_t>(to, indices);
  if (bytes == 4) narrow<std::uint32_t>(to, indices);
}

}  // namespace foredraw::c
