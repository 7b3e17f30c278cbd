#include <foredraw/page/private/page_buffer.h>

namespace foredraw {

std::size_t PageBuffer::add_bytes(std::span<const std::byte> bytes) {
  const auto [place, is_new] = offsets_.try_emplace(content_hash(bytes), bytes_.size());
  if (is_new) bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  return place->second;
}

std::string base64(std::span<const std::byte> bytes) {
  static constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t group = 0;
    for (std::size_t i = at; i < at + 3; ++i) {
      group = group << 8 | (i < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i]) : 0);
    }
    for (int shift = 18; shift >= 0; shift -= 6) text += letters[group >> shift & 63];
  }
  if (const std::size_t rest = bytes.size() % 3; rest != 0)
    text.replace(text.size() - (3 - rest), 3 - rest, 3 - rest, '=');
  return text;
}

}  // namespace foredraw
