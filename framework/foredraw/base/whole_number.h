#pragma once
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

namespace foredraw {

/// The number that all of the text spells, with a minus or without; nothing where it is none, or too large.
inline std::optional<std::int64_t> whole_number(std::string_view text) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

}  // namespace foredraw
