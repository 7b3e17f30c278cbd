#include <foredraw/io/mesh/private/utf16.h>

#include <cstdint>

namespace foredraw::mesh_files {

namespace {

constexpr std::string_view big_mark = "\xFE\xFF", little_mark = "\xFF\xFE";

bool is_high_surrogate(std::uint32_t unit) { return unit >= 0xD800 && unit < 0xDC00; }
bool is_low_surrogate(std::uint32_t unit) { return unit >= 0xDC00 && unit < 0xE000; }

void put_utf8(std::uint32_t code, std::string& text) {
  const int more = code < 0x80 ? 0 : code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  constexpr std::uint32_t leads[] = {0x00, 0xC0, 0xE0, 0xF0};
  text += static_cast<char>(leads[more] | code >> 6 * more);
  for (int i = more - 1; i >= 0; --i) text += static_cast<char>(0x80 | (code >> 6 * i & 0x3F));
}

/// The next character of text that is known to be UTF-8.
std::uint32_t take_utf8(std::string_view& text) {
  const auto lead = static_cast<unsigned char>(text.front());
  const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  std::uint32_t code = length == 1 ? lead : lead & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) code = code << 6 | (static_cast<unsigned char>(text[i]) & 0x3F);
  text.remove_prefix(length);
  return code;
}

}  // namespace

bool is_utf16(std::string_view bytes) { return bytes.starts_with(big_mark) || bytes.starts_with(little_mark); }

std::optional<std::string> utf8_of(std::string_view utf16) {
  if (utf16.size() % 2 != 0) return std::nullopt;
  const bool is_big = utf16.starts_with(big_mark);
  const auto unit = [&](std::size_t at) -> std::uint32_t {
    const auto first = static_cast<unsigned char>(utf16[at]), second = static_cast<unsigned char>(utf16[at + 1]);
    return is_big ? first << 8 | second : second << 8 | first;
  };
  std::string text;
  text.reserve(utf16.size() / 2);
  for (std::size_t at = big_mark.size(); at < utf16.size(); at += 2) {
    std::uint32_t code = unit(at);
    if (is_low_surrogate(code)) return std::nullopt;
    if (is_high_surrogate(code)) {
      at += 2;
      if (at == utf16.size() || !is_low_surrogate(unit(at))) return std::nullopt;
      code = 0x10000 + ((code - 0xD800) << 10 | (unit(at) - 0xDC00));
    }
    put_utf8(code, text);
  }
  return text;
}

std::string utf16_like(std::string_view other, std::string_view utf8) {
  const bool is_big = other.starts_with(big_mark);
  std::string text(is_big ? big_mark : little_mark);
  const auto put = [&](std::uint32_t unit) {
    const char high = static_cast<char>(unit >> 8), low = static_cast<char>(unit & 0xFF);
    text += is_big ? high : low;
    text += is_big ? low : high;
  };
  while (!utf8.empty()) {
    const std::uint32_t code = take_utf8(utf8);
    if (code < 0x10000) {
      put(code);
    } else {
      put(0xD800 | (code - 0x10000) >> 10);
      put(0xDC00 | ((code - 0x10000) & 0x3FF));
    }
  }
  return text;
}

}  // namespace foredraw::mesh_files
