#pragma once
// JSON from files that may be damaged or mean harm. Private to io.

#include <foredraw/base/diagnostics.h>
#include <foredraw/io/text/private/json_tree.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace foredraw {

struct JsonLimits {
  int depth = 64;           ///< parsers recurse
  std::size_t keys = 2048;  ///< of one object, whose keys are looked for one after the other
};

/// Why a text is not taken.
struct JsonFault {
  std::optional<std::size_t> byte;  ///< at which it shows; none: somewhere
  std::string code;
  std::string message;
  std::string hint;
};

/// The values of a text, which has no byte order mark. Refused are those that are no JSON, hold a key twice in one
/// object, or exceed the limits.
std::variant<Json, JsonFault> parse_json_text(std::string_view text, const JsonLimits& limits = {});

/// Line and column of a byte of a file's text.
Where place_in(const std::string& file, std::string_view text, std::size_t byte);

}  // namespace foredraw
