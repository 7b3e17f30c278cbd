#pragma once
#include <string>
#include <string_view>

namespace foredraw {

/// Text from a file as it may be shown: bytes that are no UTF-8 and control characters, which terminals obey, become
/// U+FFFD. `kept`: control characters that stay, such as "\n".
std::string printable(std::string_view text, std::string_view kept = "");

/// Whether all of it is well-formed (Unicode 15, table 3-7).
bool is_utf8(std::string_view text);

}  // namespace foredraw
