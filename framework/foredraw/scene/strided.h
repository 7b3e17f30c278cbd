#pragma once
// Views over vertices as an engine keeps them: one attribute of an interleaved buffer, say.

#include <concepts>
#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>

namespace foredraw {

/// A view over elements at any stride and alignment; they come by value. Whatever converts to a span converts to it.
template <class T>
requires std::is_trivially_copyable_v<T>
class Strided {
 public:
  Strided() = default;
  /// `count` elements, the first at `data`, each `stride` bytes behind the last. The memory stays the caller's.
  Strided(const void* data, std::size_t count, std::size_t stride)
      : data_(static_cast<const std::byte*>(data)), count_(count), stride_(stride) {}
  template <std::convertible_to<std::span<const T>> Range>
  Strided(const Range& values)
      : Strided(std::span<const T>(values).data(), std::span<const T>(values).size(), sizeof(T)) {}

  std::size_t size() const { return count_; }
  T operator[](std::size_t i) const {
    T value;
    std::memcpy(&value, data_ + i * stride_, sizeof(T));
    return value;
  }

 private:
  const std::byte* data_ = nullptr;
  std::size_t count_ = 0;
  std::size_t stride_ = sizeof(T);
};

}  // namespace foredraw
