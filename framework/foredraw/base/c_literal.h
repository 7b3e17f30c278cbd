#pragma once
#include <string>
#include <string_view>

namespace foredraw {

/// The text as a string literal of C. Whatever is not plain is written by its number, so that no name ends the literal
/// or the line.
inline std::string c_string(std::string_view text) {
  std::string literal = "\"";
  for (const char c : text) {
    const bool is_plain = c >= ' ' && c <= '~' && c != '"' && c != '\\' && c != '?';
    if (is_plain) {
      literal += c;
      continue;
    }
    const auto code = static_cast<unsigned char>(c);
    literal += '\\';
    for (const int shift : {6, 3, 0}) literal += static_cast<char>('0' + (code >> shift & 7));
  }
  return literal + '"';
}

/// A number's shortest text as a float literal of C: "12.0f", for C takes no "12f".
inline std::string c_float(std::string shortest) {
  if (shortest.find_first_of(".e") == std::string::npos) shortest += ".0";
  return shortest + 'f';
}

}  // namespace foredraw
