#pragma once
// Text in UTF-16 with a byte order mark, to UTF-8 and back. Private to io.

#include <optional>
#include <string>
#include <string_view>

namespace foredraw::mesh_files {

/// By the byte order mark.
bool is_utf16(std::string_view bytes);

/// Without the mark. nullopt: it is no UTF-16.
std::optional<std::string> utf8_of(std::string_view utf16);

/// UTF-8 in the byte order of another text, whose mark it gets. The inverse of utf8_of().
std::string utf16_like(std::string_view other, std::string_view utf8);

}  // namespace foredraw::mesh_files
