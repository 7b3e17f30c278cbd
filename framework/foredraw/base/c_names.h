#pragma once
// Names of ours in a file for C compilers.

#include <string>

namespace foredraw {

/// A name as C takes it: letters, digits and single underscores, a letter first; "table" where nothing is left.
inline std::string c_identifier(const std::string& name) {
  std::string result;
  for (const char c : name) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const bool is_digit = c >= '0' && c <= '9';
    if (is_letter || (is_digit && !result.empty())) {
      result += c;
    } else if (is_digit) {
      result = std::string("t") + c;
    } else if (!result.empty() && result.back() != '_') {
      result += '_';
    }
  }
  while (!result.empty() && result.back() == '_') result.pop_back();
  return result.empty() ? "table" : result;
}

inline std::string in_capitals(std::string text) {
  for (char& c : text) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return text;
}

/// So that it does not end a comment.
inline std::string in_comment(std::string text) {
  for (char& c : text) {
    if (c < ' ' || c > '~' || c == '*' || c == '\\' || c == '?') c = '_';
  }
  return text;
}

}  // namespace foredraw
