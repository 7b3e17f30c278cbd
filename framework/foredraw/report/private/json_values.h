#pragma once
// How single values stand in every JSON form.

#include <foredraw/base/diagnostics.h>
#include <foredraw/io/text/private/json_tree.h>
#include <foredraw/technique/options.h>

#include <cmath>
#include <functional>
#include <string_view>

namespace foredraw {

/// The text of a form: lines of two blanks a level, and what is not UTF-8 replaced.
inline std::string indented_text(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace); }

/// A JSON text as it stands within another one: no line of it breaks but between values.
void put_indented(std::string_view text, std::string_view indent, const std::function<void(std::string_view)>& put);

/// An object but for its member `files`, an array of which each element is handed on and not kept: of many files no
/// tree stands in memory. Throws Json::exception, as `take` may.
template <class Take>
Json parse_files(std::string_view text, Take take) {
  bool is_in_files = false;
  return Json::parse(text, [&](int depth, Json::parse_event_t event, const Json& value) {
    if (depth == 1 && event == Json::parse_event_t::key) is_in_files = value == "files";
    if (!is_in_files || depth != 2 || event != Json::parse_event_t::object_end) return true;
    take(value);
    return false;
  });
}

/// JSON knows neither infinities nor NaN: null.
inline Json json_of(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// null where the option is not set.
inline Json json_of(const OptionValue& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return *whole;
  if (const auto* real = std::get_if<double>(&value)) return json_of(*real);
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return nullptr;
}

inline Json json_of(const Diagnostic& diagnostic) {
  return JsonObject{{"severity", to_text(diagnostic.severity)},
                    {"code", diagnostic.code},
                    {"message", diagnostic.message},
                    {"hint", diagnostic.hint},
                    {"file", diagnostic.where.file},
                    {"line", diagnostic.where.line},
                    {"column", diagnostic.where.column},
                    {"inside", diagnostic.where.inside},
                    {"places", diagnostic.places}};
}

}  // namespace foredraw
