#include "name_rules.h"

#include <algorithm>
#include <regex>

namespace foredraw::architecture {

Breaches name_breaches(const std::string& path) {
  static const std::regex says_nothing(R"((^|[^a-z])(utils?|utilities|commons?|managers?|helpers?|misc)([^a-z]|$))");
  static const std::regex lower_case(R"([a-z0-9_]+\.(h|cpp|inl))");
  Breaches breaches;
  std::string lower = path;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (std::regex_search(lower, says_nothing)) {
    breaches.push_back(path + ": a name that says nothing; name the idea that it holds");
  }
  if (is_cpp(path) && !std::regex_match(parts_of(path).back(), lower_case)) {
    breaches.push_back(path + ": C++ files are called in lower case with underscores");
  }
  return breaches;
}

Breaches length_breaches(const std::string& path, const std::string& text, std::size_t limit) {
  if (!is_cpp(path) && !path.ends_with(".mjs") && !path.ends_with(".js")) return {};
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  if (lines <= limit) return {};
  return {path + ": has " + std::to_string(lines) + " lines, more than " + std::to_string(limit) + "; one idea a file"};
}

}  // namespace foredraw::architecture
