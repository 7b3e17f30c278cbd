#pragma once
// Bytes that hold text: tokens, numbers, and where in the file they stand. Private to io.

#include <foredraw/base/diagnostics.h>
#include <foredraw/io/reading/faults.h>

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace foredraw::mesh_files {

inline bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Without the byte order mark that some programs put before UTF-8.
std::string_view without_mark(std::string_view text);

std::string_view trimmed(std::string_view text);
std::string lower_case(std::string_view text);

/// A name as it stands in a file, trimmed; one that is no UTF-8 is taken for Latin-1, which is what older tools wrote.
std::string name_in(std::string_view text);

/// The next token of a text, taken off its front; empty at its end.
std::string_view take_token(std::string_view& text);

/// The next line, taken off the front of a text, without the character that ends it; a carriage return before a line
/// feed stays.
std::string_view take_line(std::string_view& text, char line_end = '\n');

/// Reads a finite number as a 32-bit float; one that is too small becomes 0. Says why not; empty: done. The value is
/// not finite where the token is a number and yet no such one, as Microsoft's "-1.#IND" is, too.
std::string_view read_float(std::string_view token, float& value);

/// Reads a whole number that the type can hold, a plus sign allowed.
template <class T>
bool read_integer(std::string_view token, T& value) {
  if (token.size() > 1 && token.front() == '+' && token[1] != '-') token.remove_prefix(1);
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  return error == std::errc{} && end == token.data() + token.size();
}

/// A token as messages show it: short, and printable.
std::string shown(std::string_view token);

/// A file being read: its name, its bytes, and who is told.
struct Reading {
  std::string name;
  std::string_view text;
  Diagnostics& diagnostics;
  Faults* faults = nullptr;  ///< nullptr: the file is read again, and all is told

  /// Line and column of a part of `text`.
  Where at(std::string_view part) const;
  /// A place in bytes that are no text.
  Where at_byte(std::size_t offset) const;
  /// Tells why the file is refused. False, to be passed on.
  bool refuse(Where where, std::string message, std::string hint = {}) const;
  bool read(std::string_view token, float& value) const;  ///< or refuses
  /// What triangles do not depend on: 0, with a fault, where it is not finite.
  bool read_attribute(std::string_view token, float& value) const;

  /// Something wrong that has one meaning; `part` of the text says where.
  void fault(std::string_view code, std::string_view part, std::string message) const;
  void fault_at_byte(std::string_view code, std::size_t offset, std::string message) const;
};

}  // namespace foredraw::mesh_files
