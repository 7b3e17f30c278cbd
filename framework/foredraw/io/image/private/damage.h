#pragma once
#include <foredraw/io/image/private/headers.h>

#include <string>

namespace foredraw::images {

/// What is wrong with a file that its decoder would not notice, or take for texels that are not there: a PNG's
/// checksums, a packed TGA's end. Empty: nothing.
std::string damage_of(Bytes bytes, const Header& header);

}  // namespace foredraw::images
