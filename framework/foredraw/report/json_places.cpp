#include <foredraw/report/private/json_places.h>

#include <algorithm>

namespace foredraw {

namespace {

constexpr std::string_view blank = " \t\r\n";

std::size_t behind_blanks(std::string_view text, std::size_t at) {
  return std::min(text.find_first_not_of(blank, at), text.size());
}

/// Behind the string that begins here.
std::size_t behind_string(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at) {
    if (text[at] == '\\') ++at;
  }
  return std::min(at + 1, text.size());
}

/// Behind the value that begins here.
std::size_t behind_value(std::string_view text, std::size_t at) {
  std::size_t depth = 0;
  while (at < text.size()) {
    const char c = text[at];
    if (c == '"') {
      at = behind_string(text, at);
    } else if (c == '{' || c == '[') {
      ++depth;
      ++at;
    } else if (c == '}' || c == ']') {
      if (depth == 0) return at;  // the end of what it stands in
      --depth;
      ++at;
    } else if (depth == 0) {
      return std::min(text.find_first_of(" \t\r\n,]}", at), text.size());
    } else {
      ++at;
    }
    if (depth == 0) return at;
  }
  return text.size();
}

}  // namespace

std::vector<std::pair<std::string_view, std::string_view>> members_in(std::string_view object) {
  std::vector<std::pair<std::string_view, std::string_view>> members;
  std::size_t at = behind_blanks(object, 0);
  if (at >= object.size() || object[at] != '{') return members;
  for (at = behind_blanks(object, at + 1); at < object.size() && object[at] == '"';) {
    const std::size_t end = behind_string(object, at);
    const std::string_view key = object.substr(at + 1, end - at - 2);
    const std::size_t value = behind_blanks(object, behind_blanks(object, end) + 1);  // the colon
    at = behind_value(object, value);
    members.emplace_back(key, object.substr(value, at - value));
    at = behind_blanks(object, at);
    if (at < object.size() && object[at] == ',') at = behind_blanks(object, at + 1);
  }
  return members;
}

std::vector<std::string_view> elements_in(std::string_view array) {
  std::vector<std::string_view> elements;
  std::size_t at = behind_blanks(array, 0);
  if (at >= array.size() || array[at] != '[') return elements;
  for (at = behind_blanks(array, at + 1); at < array.size() && array[at] != ']';) {
    const std::size_t end = behind_value(array, at);
    elements.push_back(array.substr(at, end - at));
    at = behind_blanks(array, end);
    if (at < array.size() && array[at] == ',') at = behind_blanks(array, at + 1);
  }
  return elements;
}

}  // namespace foredraw
