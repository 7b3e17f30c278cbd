#include <foredraw/report/private/json_writer.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

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
    waiting_ += nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
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

void JsonWriter::plain(std::string_view word) {
  place();
  waiting_ += word;
}

void JsonWriter::value(double number) {
  if (!std::isfinite(number)) return null();
  place();
  std::array<char, 64> digits;  // as Json::dump() makes them
  const char* const end = nlohmann::detail::to_chars(digits.data(), digits.data() + digits.size(), number);
  waiting_.append(static_cast<const char*>(digits.data()), end);
}

void JsonWriter::value(std::uint64_t number) { plain(std::to_string(number)); }
void JsonWriter::value(std::int64_t number) { plain(std::to_string(number)); }

void JsonWriter::value(std::string_view string) {
  place();
  text(string);
}

void JsonWriter::json(std::string_view text) {
  while (text.ends_with('\n')) text.remove_suffix(1);
  place();
  for (const char c : text) {
    waiting_ += c;
    if (c == '\n') waiting_.append(2 * depth_, ' ');
  }
}

void JsonWriter::finish() {
  waiting_ += '\n';
  put_(waiting_);
  waiting_.clear();
}

namespace {

struct PutValue {
  JsonWriter& out;
  void operator()(std::monostate) const { out.null(); }
  void operator()(const auto& value) const { out.value(value); }
};

}  // namespace

void write(JsonWriter& out, const OptionValue& value) { std::visit(PutValue{out}, value); }

void write(JsonWriter& out, const Diagnostic& diagnostic) {
  out.begin('{');
  out.key("severity").value(to_text(diagnostic.severity));
  out.key("code").value(diagnostic.code);
  out.key("message").value(diagnostic.message);
  out.key("hint").value(diagnostic.hint);
  out.key("file").value(diagnostic.where.file);
  out.key("line").value(diagnostic.where.line);
  out.key("column").value(diagnostic.where.column);
  out.key("inside").value(diagnostic.where.inside);
  out.key("places").value(diagnostic.places);
  out.end('}');
}

void write(JsonWriter& out, const std::vector<Diagnostic>& diagnostics) {
  out.begin('[');
  for (const Diagnostic& diagnostic : diagnostics) write(out, diagnostic);
  out.end(']');
}

}  // namespace foredraw
