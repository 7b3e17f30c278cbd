#include <foredraw/io/image/private/damage.h>

#include <zlib.h>

#include <algorithm>
#include <string_view>

namespace foredraw::images {

namespace {

std::uint32_t byte_at(Bytes bytes, std::size_t i) { return std::to_integer<std::uint32_t>(bytes[i]); }

std::uint32_t big32_at(Bytes bytes, std::size_t i) {
  return byte_at(bytes, i) << 24 | byte_at(bytes, i + 1) << 16 | byte_at(bytes, i + 2) << 8 | byte_at(bytes, i + 3);
}

/// Chunks that texels are made from; of the others nobody reads more than the length.
bool is_of_texels(std::string_view kind) {
  constexpr std::string_view kinds[] = {"IHDR", "PLTE", "IDAT", "tRNS"};
  return std::ranges::find(kinds, kind) != std::end(kinds);
}

std::string png_damage(Bytes bytes) {
  for (std::size_t i = 8; i + 12 <= bytes.size();) {
    const std::size_t length = big32_at(bytes, i);
    if (length > bytes.size() - i - 12) return {};  // cut off, which the decoder tells
    const Bytes checked = bytes.subspan(i + 4, 4 + length);
    const std::string_view kind(reinterpret_cast<const char*>(checked.data()), 4);
    const auto sum = crc32_z(0, reinterpret_cast<const Bytef*>(checked.data()), checked.size());
    if (is_of_texels(kind) && sum != big32_at(bytes, i + 8 + length)) {
      return "has a wrong checksum in chunk " + std::string(kind) + ": it is damaged";
    }
    if (kind == "IEND") break;
    i += 12 + length;
  }
  return {};
}

/// Runs of equal texels and of different ones, until all texels are there.
std::string packed_tga_damage(Bytes bytes, const Header& header) {
  const std::size_t texel = byte_at(bytes, 16) / 8;
  const std::size_t map =
      byte_at(bytes, 1) == 1 ? (byte_at(bytes, 5) | byte_at(bytes, 6) << 8) * (byte_at(bytes, 7) / 8) : 0;
  std::size_t i = 18 + byte_at(bytes, 0) + map;
  for (std::uint64_t left = std::uint64_t{header.facts.width} * header.facts.height; left > 0;) {
    const std::uint32_t packet = i < bytes.size() ? byte_at(bytes, i) : 0;
    const std::uint64_t texels = 1 + (packet & 0x7f);
    i += 1 + static_cast<std::size_t>(packet >= 0x80 ? texel : texels * texel);
    if (i > bytes.size()) return "ends before its last texel: it is cut off or damaged";
    left -= std::min(left, texels);
  }
  return {};
}

}  // namespace

std::string damage_of(Bytes bytes, const Header& header) {
  if (header.kind == Kind::png) return png_damage(bytes);
  if (header.kind == Kind::tga && byte_at(bytes, 2) >= 9) return packed_tga_damage(bytes, header);
  return {};
}

}  // namespace foredraw::images
