#pragma once
// PNG, JPEG and TGA by stb_image. Private to io.

#include <foredraw/io/image/private/headers.h>

#include <string>
#include <variant>
#include <vector>

namespace foredraw::images {

/// The texels, of 16 bits a channel where the header says more than 8; or why not.
std::variant<std::vector<std::byte>, std::string> stb_texels(Bytes bytes, const Header& header);

}  // namespace foredraw::images
