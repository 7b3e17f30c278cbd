#include <foredraw/io/image/private/exr.h>
#include <foredraw/io/image/private/headers.h>

#include <algorithm>
#include <cstring>
#include <string_view>

namespace foredraw::images {

namespace {

std::uint32_t at(Bytes bytes, std::size_t i) { return std::to_integer<std::uint32_t>(bytes[i]); }
std::uint32_t big16(Bytes bytes, std::size_t i) { return at(bytes, i) << 8 | at(bytes, i + 1); }
std::uint32_t big32(Bytes bytes, std::size_t i) { return big16(bytes, i) << 16 | big16(bytes, i + 2); }
std::uint32_t little16(Bytes bytes, std::size_t i) { return at(bytes, i) | at(bytes, i + 1) << 8; }

bool begins_with(Bytes bytes, std::string_view text) {
  return bytes.size() >= text.size() && std::memcmp(bytes.data(), text.data(), text.size()) == 0;
}

bool has(Bytes bytes, std::size_t i, std::string_view text) {
  return i < bytes.size() && begins_with(bytes.subspan(i), text);
}

/// Deflate makes 1032 bytes of one at best: a bit for a match of 258 bytes, and one for its distance.
constexpr std::uint64_t best_of_deflate = 1032;

std::optional<Header> png(Bytes bytes) {
  if (bytes.size() < 33 || !has(bytes, 12, "IHDR")) return std::nullopt;
  Header header{Kind::png, {big32(bytes, 16), big32(bytes, 20), 0, static_cast<int>(at(bytes, 24))}};
  switch (at(bytes, 25)) {
    case 0: header.facts.channels = 1; break;
    case 2: header.facts.channels = 3; break;
    case 3: header.facts.channels = 3; break;
    case 4: header.facts.channels = 2; break;
    case 6: header.facts.channels = 4; break;
    default: return std::nullopt;
  }
  const bool is_palette = at(bytes, 25) == 3;
  const std::uint64_t stored = static_cast<std::uint64_t>(header.facts.bits) * (is_palette ? 1 : header.facts.channels);
  if (stored == 0) return std::nullopt;
  header.most_texels = bytes.size() * best_of_deflate * 8 / stored;
  if (is_palette) header.facts.bits = 8;
  // Every chunk has to lie in the bytes: decoders allocate what a chunk claims. Transparent colours are an alpha
  // channel by another name; they are told before the texels.
  bool has_texels = false;
  for (std::size_t chunk = 8; !has(bytes, chunk + 4, "IEND");) {
    if (bytes.size() - chunk < 12 || big32(bytes, chunk) > bytes.size() - chunk - 12) return std::nullopt;
    has_texels = has_texels || has(bytes, chunk + 4, "IDAT");
    if (!has_texels && has(bytes, chunk + 4, "tRNS") && header.facts.channels % 2 == 1) ++header.facts.channels;
    chunk += 12 + big32(bytes, chunk);
  }
  return header;
}

std::optional<Header> jpeg(Bytes bytes) {
  std::size_t i = 2;
  while (const auto segment = next_segment(bytes, i)) {
    const auto [marker, content] = *segment;
    const bool is_frame = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (is_frame) {
      if (content.size() < 6) return std::nullopt;
      const auto bits = static_cast<int>(at(content, 0));
      const auto stored = static_cast<int>(at(content, 5));
      const int channels = stored == 4 ? 3 : stored;  // the inks of a press become RGB
      // A block of 64 texels takes a bit at least, and colour that is stored more coarsely is stored beside grey that
      // is not.
      return Header{
          Kind::jpeg, {big16(content, 3), big16(content, 1), channels, bits}, std::uint64_t{1024} * bytes.size()};
    }
    if (marker == 0xda) return std::nullopt;  // texels without a frame
  }
  return std::nullopt;
}

/// It has no mark at its beginning: every byte has to be one that a TGA can have there.
std::optional<Header> tga(Bytes bytes) {
  if (bytes.size() < 18) return std::nullopt;
  const std::uint32_t has_map = at(bytes, 1), type = at(bytes, 2), depth = at(bytes, 16), map_depth = at(bytes, 7);
  const bool is_packed = type >= 9 && type <= 11;
  const std::uint32_t plain = is_packed ? type - 8 : type;
  if (plain < 1 || plain > 3 || has_map != (plain == 1 ? 1u : 0u)) return std::nullopt;
  if (plain == 1 ? depth != 8 : plain == 2 ? depth != 16 && depth != 24 && depth != 32 : depth != 8)
    return std::nullopt;
  if (plain == 1 && map_depth != 24 && map_depth != 32) return std::nullopt;
  if ((at(bytes, 17) & 0xc0) != 0) return std::nullopt;
  const std::uint32_t colours = plain == 1 ? map_depth : depth;
  const int channels = plain == 3 ? 1 : colours == 32 ? 4 : 3;
  const std::uint64_t texel = depth / 8;
  // A packet of 128 equal texels is a byte and the texel.
  const std::uint64_t most = is_packed ? bytes.size() * 128 / (1 + texel) : bytes.size() / texel;
  return Header{Kind::tga, {little16(bytes, 12), little16(bytes, 14), channels, 8}, most};
}

}  // namespace

std::optional<Segment> next_segment(Bytes bytes, std::size_t& i) {
  const auto stands_alone = [](std::uint32_t marker) { return marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8); };
  while (i + 2 <= bytes.size() && at(bytes, i) == 0xff &&
         (at(bytes, i + 1) == 0xff || stands_alone(at(bytes, i + 1)))) {
    i += at(bytes, i + 1) == 0xff ? 1 : 2;  // an 0xff before a marker is fill
  }
  if (i + 4 > bytes.size() || at(bytes, i) != 0xff || at(bytes, i + 1) == 0xd9) return std::nullopt;
  const std::uint32_t marker = at(bytes, i + 1), length = big16(bytes, i + 2);
  if (length < 2) return std::nullopt;
  const Segment segment{marker, bytes.subspan(i + 4).first(std::min<std::size_t>(length - 2, bytes.size() - i - 4))};
  i = std::min<std::size_t>(i + 2 + length, bytes.size());
  if (marker == 0xda) {  // texels follow, in which 0xff is followed by 0, or by more of it, or marks a fresh start
    const auto is_texels = [](std::uint32_t second) {
      return second == 0 || second == 0xff || (second >= 0xd0 && second <= 0xd7);
    };
    while (i + 1 < bytes.size() && (at(bytes, i) != 0xff || is_texels(at(bytes, i + 1)))) ++i;
  }
  return segment;
}

std::optional<Header> header_of(Bytes bytes) {
  std::optional<Header> header;
  if (begins_with(bytes, "\x89PNG\r\n\x1a\n")) {
    header = png(bytes);
  } else if (begins_with(bytes, "\xff\xd8\xff")) {
    header = jpeg(bytes);
  } else if (is_exr(bytes)) {
    header = exr_header(bytes);
  } else {
    header = tga(bytes);
  }
  if (header && (header->facts.width == 0 || header->facts.height == 0)) return std::nullopt;
  return header;
}

std::string_view undecoded_kind(Bytes bytes) {
  if (begins_with(bytes, "\xabKTX 20\xbb\r\n\x1a\n")) return "KTX2";
  if (begins_with(bytes, "\xabKTX 11\xbb\r\n\x1a\n")) return "KTX";
  if (begins_with(bytes, "RIFF") && has(bytes, 8, "WEBP")) return "WebP";
  if (has(bytes, 4, "ftypavif") || has(bytes, 4, "ftypavis")) return "AVIF";
  if (begins_with(bytes, "DDS ")) return "DDS";
  if (begins_with(bytes, "GIF8")) return "GIF";
  if (begins_with(bytes, "BM")) return "BMP";
  return {};
}

}  // namespace foredraw::images
