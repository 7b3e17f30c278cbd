#include <foredraw/io/image/private/stb.h>

#include <foredraw/io/image/private/damage.h>

#include <cstdlib>
#include <limits>

// A copy of its own with only what is needed, whose names nobody else sees: a program may bring another.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_TGA
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
// Cleared memory: the JPEG decoder follows Huffman tables that a damaged file names and never defines.
#define STBI_MALLOC(bytes) std::calloc(1, bytes)
#define STBI_REALLOC(pointer, bytes) std::realloc(pointer, bytes)
#define STBI_FREE(pointer) std::free(pointer)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <memory>

namespace foredraw::images {

namespace {

/// A Huffman table of a JPEG says how many codes there are of each of 16 lengths; for more than 256 in all the decoder
/// has no room, and does not look.
bool tables_fit(Bytes jpeg) {
  std::size_t i = 2;
  while (const auto segment = next_segment(jpeg, i)) {
    if (segment->marker != 0xc4) continue;
    for (Bytes tables = segment->content; tables.size() >= 17;) {
      std::size_t codes = 0;
      for (const std::byte count : tables.subspan(1, 16)) codes += std::to_integer<std::size_t>(count);
      if (codes > 256) return false;
      tables = tables.subspan(std::min(tables.size(), 17 + codes));
    }
  }
  return true;
}

/// A TGA may store its rows from the right, which the decoder passes by.
void turn_rows(std::vector<std::byte>& texels, std::size_t width, std::size_t channels) {
  const std::size_t row = width * channels;
  for (std::size_t first = 0; first + row <= texels.size(); first += row) {
    for (std::size_t left = 0, right = width - 1; left < right; ++left, --right) {
      std::swap_ranges(&texels[first + left * channels], &texels[first + left * channels] + channels,
                       &texels[first + right * channels]);
    }
  }
}

}  // namespace

std::variant<std::vector<std::byte>, std::string> stb_texels(Bytes bytes, const Header& header) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) return "is larger than 2 GB";
  if (header.kind == Kind::jpeg && !tables_fit(bytes)) return "has a Huffman table of more than 256 codes";
  if (std::string damage = damage_of(bytes, header); !damage.empty()) return damage;
  const auto* from = reinterpret_cast<const stbi_uc*>(bytes.data());
  const auto length = static_cast<int>(bytes.size());
  int width = 0, height = 0, stored = 0;
  const int channels = header.facts.channels;
  const bool is_wide = header.facts.bits > 8;
  void* made = is_wide ? static_cast<void*>(stbi_load_16_from_memory(from, length, &width, &height, &stored, channels))
                       : static_cast<void*>(stbi_load_from_memory(from, length, &width, &height, &stored, channels));
  const std::unique_ptr<void, decltype(&stbi_image_free)> texels(made, &stbi_image_free);
  if (!texels) return stbi_failure_reason() == nullptr ? "cannot be decoded" : std::string(stbi_failure_reason());
  if (static_cast<std::uint32_t>(width) != header.facts.width ||
      static_cast<std::uint32_t>(height) != header.facts.height) {
    return "has two different headers";
  }
  const auto* first = static_cast<const std::byte*>(texels.get());
  const std::size_t size =
      std::size_t{header.facts.width} * header.facts.height * static_cast<std::size_t>(channels) * (is_wide ? 2 : 1);
  std::vector<std::byte> result(first, first + size);
  if (header.kind == Kind::tga && (std::to_integer<std::uint32_t>(bytes[17]) & 0x10) != 0) {
    turn_rows(result, header.facts.width, static_cast<std::size_t>(channels));
  }
  return result;
}

}  // namespace foredraw::images
