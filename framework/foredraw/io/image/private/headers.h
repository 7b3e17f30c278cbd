#pragma once
// The headers of image files. Private to io.

#include <foredraw/scene/image.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace foredraw::images {

using Bytes = std::span<const std::byte>;

enum class Kind { png, jpeg, tga, exr };

struct Header {
  Kind kind = Kind::png;
  ImageFacts facts;
  std::uint64_t most_texels = 0;  ///< that so many bytes can hold in this format, however well they are compressed
};

/// nullopt where no header of a kind that we know stands there whole.
std::optional<Header> header_of(Bytes bytes);

/// The name of a kind that is known, but not decoded: "WebP". Empty for every other.
std::string_view undecoded_kind(Bytes bytes);

/// What stands between two markers of a JPEG, as far as there are bytes.
struct Segment {
  std::uint32_t marker;
  Bytes content;
};

/// The segment at `i`, which is moved to the next one; the first is at 2. nullopt at the end, and where none begins.
std::optional<Segment> next_segment(Bytes bytes, std::size_t& i);

}  // namespace foredraw::images
