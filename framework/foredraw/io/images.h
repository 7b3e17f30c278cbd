#pragma once
// Images: what their headers say, and their texels. PNG, JPEG, TGA and OpenEXR, told apart by content and not by name.

#include <foredraw/base/diagnostics.h>
#include <foredraw/scene/image.h>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace foredraw {

/// From the header alone, in no time. nullopt where it is none that we know, or the header is damaged.
std::optional<ImageFacts> image_facts(std::span<const std::byte> bytes);

struct ImageLimits {
  std::uint64_t texels = std::uint64_t{1} << 28;  ///< width times height: 16384 squared
};

/// Rows from the top, channels interleaved, no padding. 8 or 16 bits unsigned a channel in the machine's byte order, as
/// stored (fewer than 8 and palettes become 8); 32-bit float where the image holds floats, of 16 bits too.
struct Texels {
  ImageFacts facts;  ///< of these texels: `bits` is 8, 16 or 32
  std::vector<std::byte> bytes;
};

/// Decodes an image. nullopt, with an error at `where`, for what is damaged, is of another kind, exceeds the limits, or
/// claims more texels than its bytes can hold at its format's best compression: that is known before anything is
/// allocated.
std::optional<Texels> decode_image(std::span<const std::byte> bytes, const Where& where, Diagnostics& diagnostics,
                                   const ImageLimits& limits = {});

}  // namespace foredraw
