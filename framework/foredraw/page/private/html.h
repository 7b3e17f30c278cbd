#pragma once
#include <string>
#include <string_view>

namespace foredraw {

/// Text as HTML shows it: whatever a file calls its things, it is no markup.
std::string escaped(std::string_view text);

/// "<name attributes>content</name>"; the content is HTML.
std::string element(std::string_view name, std::string_view content, std::string_view attributes = "");

/// JSON as it may stand within a script element: no "<" ends it.
std::string script_safe(std::string_view json);

}  // namespace foredraw
