#include <foredraw/report/private/json_writer.h>

#include <algorithm>
#include <array>

namespace foredraw {

namespace {

constexpr std::size_t piece = std::size_t{1} << 16;

bool is_plain(char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; }

}  // namespace

void JsonWriter::place() {
  if (has_key_) {
    has_key_ = false;
    return;
  }
  if (!is_first_) waiting_ += ',';
  is_first_ = false;
  waiting_ += '\n';
  waiting_.append(2 * depth_, ' ');
  if (waiting_.size() < piece) return;
  put_(waiting_);
  waiting_.clear();
}

void JsonWriter::text(std::string_view text) {
  if (std::ranges::all_of(text, is_plain)) {
    waiting_ += '"';
    waiting_ += text;
    waiting_ += '"';
  } else {
    waiting_ += Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
  }
}

JsonWriter& JsonWriter::key(std::string_view name) {
  place();
  text(name);
  waiting_ += ": ";
  has_key_ = true;
  return *this;
}

void JsonWriter::begin(char bracket) {
  place();
  waiting_ += bracket;
  ++depth_;
  is_first_ = true;
}

void JsonWriter::end(char bracket) {
  --depth_;
  if (!is_first_) {
    waiting_ += '\n';
    waiting_.append(2 * depth_, ' ');
  }
  waiting_ += bracket;
  is_first_ = false;
}

void JsonWriter::value(double number) {
  place();
  if (!std::isfinite(number)) {
    waiting_ += "null";
    return;
  }
  std::array<char, 64> digits;  // as Json::dump() makes them
  const char* const end = nlohmann::detail::to_chars(digits.data(), digits.data() + digits.size(), number);
  waiting_.append(static_cast<const char*>(digits.data()), end);
}

void JsonWriter::value(std::uint64_t number) {
  place();
  waiting_ += std::to_string(number);
}

void JsonWriter::value(std::string_view string) {
  place();
  text(string);
}

void JsonWriter::tree(const Json& json) {
  switch (json.type()) {
    case Json::value_t::object:
      begin('{');
      for (const auto& [name, member] : json.items()) key(name).tree(member);
      end('}');
      break;
    case Json::value_t::array:
      begin('[');
      for (const Json& element : json) tree(element);
      end(']');
      break;
    case Json::value_t::string: value(std::string_view(json.get_ref<const std::string&>())); break;
    case Json::value_t::number_float: value(json.get<double>()); break;
    default: place(); waiting_ += json.dump();
  }
}

void JsonWriter::finish() {
  waiting_ += '\n';
  put_(waiting_);
  waiting_.clear();
}

}  // namespace foredraw
