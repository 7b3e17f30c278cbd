#pragma once
// OpenEXR: single flat images in scan lines, uncompressed or by RLE, ZIPS or ZIP. Private to io.

#include <foredraw/io/image/private/headers.h>

#include <string>
#include <variant>
#include <vector>

namespace foredraw::images {

bool is_exr(Bytes bytes);

std::optional<Header> exr_header(Bytes bytes);

/// 32-bit floats, channels as ImageFacts has them; or why not.
std::variant<std::vector<std::byte>, std::string> exr_texels(Bytes bytes);

}  // namespace foredraw::images
