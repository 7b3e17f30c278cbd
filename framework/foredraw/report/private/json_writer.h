#pragma once
// JSON written piece by piece, so that a long record stands in memory neither as a tree nor as a text.

#include <foredraw/report/private/json_values.h>

#include <functional>
#include <string>
#include <string_view>

namespace foredraw {

/// Lays its text out as Json::dump(2) does. Whoever calls begins and ends objects and arrays in step, and gives each
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
  void value(std::string_view text);
  void tree(const Json& json);

  /// Ends the text with a line break, and hands over what is left of it.
  void finish();

 private:
  void place();  ///< what comes next goes onto a line of its own, or behind its key
  void text(std::string_view text);

  Put put_;
  std::string waiting_;
  std::size_t depth_ = 0;
  bool is_first_ = true;
  bool has_key_ = true;  ///< what comes next stays on its line: the whole does, too
};

}  // namespace foredraw
