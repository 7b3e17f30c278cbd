#pragma once
// The 128-bit stamp of content: equal bytes have equal stamps, on every machine.

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>

namespace foredraw {

struct Stamp {
  std::uint64_t high = 0;
  std::uint64_t low = 0;
  auto operator<=>(const Stamp&) const = default;
};

/// XXH3, 128 bits.
Stamp content_hash(std::span<const std::byte> bytes, std::uint64_t seed = 0);

template <class T>
requires std::is_trivially_copyable_v<T> Stamp content_hash(std::span<const T> values, std::uint64_t seed = 0) {
  return content_hash(std::as_bytes(values), seed);
}

/// The stamp of several stamps in this order.
Stamp combine(std::span<const Stamp> stamps);

/// 32 hexadecimal digits.
std::string to_text(const Stamp& stamp);

}  // namespace foredraw
