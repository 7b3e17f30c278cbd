#include <foredraw/io/gltf/private/rows.h>

#include <cstring>

namespace foredraw::gltf {

namespace {

/// With a number of bytes that the compiler knows a copy is a move or two, else a call.
template <std::size_t bytes>
void copy_rows_of(std::byte* to, std::size_t to_stride, const std::byte* from, std::size_t from_stride,
                  std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) std::memcpy(to + i * to_stride, from + i * from_stride, bytes);
}

// Little-endian, as glTF is and every machine that we build for.
template <std::size_t width>
void widen(const std::byte* from, std::uint32_t* to, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t value = 0;
    std::memcpy(&value, from + i * width, width);
    to[i] = value;
  }
}

template <class Integer>
std::uint32_t greatest_of(const std::byte* from, std::size_t count) {
  Integer most = 0;  // of the narrow type, so that many fit a register
  for (std::size_t i = 0; i < count; ++i) {
    Integer value;
    std::memcpy(&value, from + i * sizeof(value), sizeof(value));
    most = value > most ? value : most;
  }
  return most;
}

template <std::size_t width>
void narrow(const std::uint32_t* from, std::byte* to, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t value = from[i];
    std::memcpy(to + i * width, &value, width);
  }
}

}  // namespace

void copy_rows(std::byte* to, std::size_t to_stride, const std::byte* from, std::size_t from_stride, std::size_t bytes,
               std::size_t count) {
  if (count == 0) return;
  if (to_stride == bytes && from_stride == bytes) {
    std::memcpy(to, from, count * bytes);
    return;
  }
  switch (bytes) {
    case 4: return copy_rows_of<4>(to, to_stride, from, from_stride, count);
    case 8: return copy_rows_of<8>(to, to_stride, from, from_stride, count);
    case 12: return copy_rows_of<12>(to, to_stride, from, from_stride, count);
    case 16: return copy_rows_of<16>(to, to_stride, from, from_stride, count);
    default:
      for (std::size_t i = 0; i < count; ++i) std::memcpy(to + i * to_stride, from + i * from_stride, bytes);
  }
}

std::vector<std::uint32_t> widened(std::span<const std::byte> elements, std::size_t width) {
  std::vector<std::uint32_t> values(elements.size() / width);
  if (width == 1) widen<1>(elements.data(), values.data(), values.size());
  if (width == 2) widen<2>(elements.data(), values.data(), values.size());
  if (width == 4) widen<4>(elements.data(), values.data(), values.size());
  return values;
}

std::vector<std::byte> narrowed(std::span<const std::uint32_t> values, std::size_t width) {
  std::vector<std::byte> elements(values.size() * width);
  if (width == 1) narrow<1>(values.data(), elements.data(), values.size());
  if (width == 2) narrow<2>(values.data(), elements.data(), values.size());
  if (width == 4) narrow<4>(values.data(), elements.data(), values.size());
  return elements;
}

std::uint32_t greatest(std::span<const std::byte> elements, std::size_t width) {
  const std::size_t count = elements.size() / width;
  if (width == 1) return greatest_of<std::uint8_t>(elements.data(), count);
  if (width == 2) return greatest_of<std::uint16_t>(elements.data(), count);
  return greatest_of<std::uint32_t>(elements.data(), count);
}

}  // namespace foredraw::gltf
