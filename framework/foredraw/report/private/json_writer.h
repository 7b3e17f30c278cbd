#pragma once
// JSON written piece by piece, so that a long record stands in memory neither as a tree nor as a text.

#include <foredraw/base/diagnostics.h>
#include <foredraw/technique/options.h>

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace foredraw {

/// Lays its text out as Json::dump(2) does, and frees nothing that would need memory for that: where memory runs out,
/// std::bad_alloc comes out. Whoever calls begins and ends objects and arrays in step, and gives each
/// value in an object its key.
class JsonWriter {
 public:
  using Put = std::function<void(std::string_view)>;

  explicit JsonWriter(Put put) : put_(std::move(put)) {}

  JsonWriter& key(std::string_view name);
  void begin(char bracket);  ///< '{' or '['
  void end(char bracket);    ///< '}' or ']'

  void value(double number);  ///< null where it is infinite or not a number
  void value(std::uint64_t number);
  void value(std::int64_t number);
  void value(int number) { value(std::int64_t{number}); }
  void value(bool truth) { plain(truth ? "true" : "false"); }
  void value(std::string_view text);
  void value(const std::string& text) { value(std::string_view(text)); }
  void value(const char* text) { value(std::string_view(text)); }
  void null() { plain("null"); }
  void json(std::string_view text);  ///< laid out as Json::dump(2) does

  /// Ends the text with a line break, and hands over what is left of it.
  void finish();

 private:
  void place();  ///< what comes next goes onto a line of its own, or behind its key
  void text(std::string_view text);
  void plain(std::string_view word);

  Put put_;
  std::string waiting_;
  std::size_t depth_ = 0;
  bool is_first_ = true;
  bool has_key_ = true;  ///< what comes next stays on its line: the whole does, too
};

/// How single values stand in every form.
void write(JsonWriter& out, const OptionValue& value);  ///< null where the option is not set
void write(JsonWriter& out, const Diagnostic& diagnostic);
void write(JsonWriter& out, const std::vector<Diagnostic>& diagnostics);

/// The text that write(out) makes.
template <class Write>
std::string json_text(Write write) {
  std::string text;
  JsonWriter out([&](std::string_view piece) { text += piece; });
  write(out);
  out.finish();
  return text;
}

}  // namespace foredraw
