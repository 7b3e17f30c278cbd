#pragma once
// Small image files made on the spot.

#include <foredraw/scene/image.h>

#include <cstddef>
#include <string>
#include <vector>

namespace foredraw::testing {

/// A PNG of the values: 1 to 4 channels of 8 or 16 bits, rows from the top.
std::vector<std::byte> png_of(const ImageFacts& facts, const std::vector<std::uint16_t>& values);

/// A baseline JPEG, nearly lossless.
std::vector<std::byte> jpeg_of(const ImageFacts& facts, const std::vector<std::uint16_t>& values);

/// Packed by run lengths.
std::vector<std::byte> tga_of(const ImageFacts& facts, const std::vector<std::uint16_t>& values);

/// "none", "rle", "zips", "zip" or "piz"; channels R, G, B, A, or Y alone; halves where facts.bits is 16.
std::vector<std::byte> exr_of(const ImageFacts& facts, const std::vector<float>& values,
                              const std::string& compression);

}  // namespace foredraw::testing
