#pragma once
// What differs from shader to shader, put into their texts.

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace foredraw::displaced_shader_parts {

using Words = std::span<const std::pair<std::string_view, std::string>>;

/// With the value of each word that stands between @ in its place. std::logic_error where there is none.
inline std::string filled(std::string_view text, Words words) {
  const auto value_of = [&](std::string_view name) -> std::string_view {
    for (const auto& [from, to] : words)
      if (from == name) return to;
    throw std::logic_error("a shader's text has no word " + std::string(name));
  };
  std::string result;
  while (true) {
    const std::size_t from = text.find('@');
    result += text.substr(0, from);
    if (from == std::string_view::npos) return result;
    const std::size_t to = text.find('@', from + 1);
    result += value_of(text.substr(from + 1, to - from - 1));
    text.remove_prefix(to + 1);
  }
}

}  // namespace foredraw::displaced_shader_parts
