#include <foredraw/io/text/private/json_text.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace foredraw {

namespace {

/// Parsers recurse, so that depth has to be bounded before one is let loose. Returns the byte where it gets too deep.
std::optional<std::size_t> too_deep(std::string_view text, int deepest) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c == '\\') ++i;
      if (c == '"') quoted = false;
    } else if (c == '"') {
      quoted = true;
    } else if (c == '[' || c == '{') {
      if (++depth > deepest) return i;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return std::nullopt;
}

/// "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error ..." without what we say ourselves.
std::string reason(const std::string& what) {
  const std::size_t from = what.find("syntax error");
  if (from != std::string::npos) return what.substr(from);
  const std::size_t bracket = what.find("] ");
  return bracket == std::string::npos ? what : what.substr(bracket + 2);
}

/// Makes the tree of values, and sees what such a tree does not show or has no room for. The library's own callback
/// would ask all of an array at the end of each of its objects.
class Reading {
 public:
  explicit Reading(std::size_t most_keys) : most_keys_(most_keys) {}

  Json tree;
  std::string twice;                 ///< the first key that stands twice in one object
  bool is_crowded = false;           ///< some object has too many keys
  std::optional<std::size_t> stuck;  ///< the byte at which it is no JSON
  std::string why;

  bool null() { return put(nullptr); }
  bool boolean(bool value) { return put(value); }
  bool number_integer(Json::number_integer_t value) { return put(value); }
  bool number_unsigned(Json::number_unsigned_t value) { return put(value); }
  bool number_float(Json::number_float_t value, const std::string&) { return put(value); }
  bool string(std::string& value) { return put(std::move(value)); }
  bool binary(Json::binary_t&) { return false; }  // there is none in a text
  bool start_array(std::size_t) { return begin(Json::array()); }
  bool end_array() { return end(); }
  bool start_object(std::size_t) {
    JsonObject members;
    members.reserve(open_.empty() ? 32 : 4);  // where it grows it copies all that its members hold
    return begin(std::move(members));
  }
  bool end_object() { return end(); }
  bool key(std::string& key) {
    Json& object = *open_.back();
    const std::size_t keys = object.size();
    member_ = &object[key];
    if (object.size() == keys && twice.empty()) twice = key;
    is_crowded = object.size() > most_keys_;
    return !is_crowded;
  }
  bool parse_error(std::size_t byte, const std::string&, const Json::exception& mistake) {
    stuck = byte == 0 ? 0 : byte - 1;
    why = reason(mistake.what());
    return false;
  }

 private:
  template <class T>
  bool put(T&& value) {
    add(Json(std::forward<T>(value)));
    return true;
  }
  bool begin(Json empty) {
    open_.push_back(add(std::move(empty)));
    return true;
  }
  bool end() {
    open_.pop_back();
    return true;
  }
  Json* add(Json value) {
    if (open_.empty()) return &(tree = std::move(value));
    if (open_.back()->is_object()) return &(*member_ = std::move(value));
    open_.back()->push_back(std::move(value));
    return &open_.back()->back();
  }

  std::size_t most_keys_;
  std::vector<Json*> open_;  ///< the objects and arrays around what comes next
  Json* member_ = nullptr;   ///< that the key before named
};

}  // namespace

std::variant<Json, JsonFault> parse_json_text(std::string_view text, const JsonLimits& limits) {
  if (const auto byte = too_deep(text, limits.depth)) {
    return JsonFault{byte, "json-nesting", fmt::format("the JSON is nested deeper than {} levels", limits.depth), ""};
  }
  Reading reading(limits.keys);
  Json::sax_parse(text.begin(), text.end(), &reading);
  if (reading.stuck) return JsonFault{reading.stuck, "json-syntax", "is not JSON: " + reading.why, ""};
  if (reading.is_crowded) {
    return JsonFault{std::nullopt, "json-crowd", fmt::format("an object has more than {} keys", limits.keys),
                     "use an array instead"};
  }
  if (!reading.twice.empty()) {
    return JsonFault{std::nullopt, "json-duplicate-key",
                     fmt::format("the key '{}' occurs twice in one object", reading.twice),
                     "keep one of them; readers differ in which one they use"};
  }
  return std::move(reading.tree);
}

Where place_in(const std::string& file, std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  const auto line = static_cast<int>(std::ranges::count(before, '\n')) + 1;
  const std::size_t start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  return {.file = file, .line = line, .column = static_cast<int>(before.size() - start) + 1, .inside = {}};
}

}  // namespace foredraw
