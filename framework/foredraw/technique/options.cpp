#include <foredraw/technique/options.h>

#include <foredraw/scene/views.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace foredraw {

namespace {

/// As a basic string of TOML, which has no control characters as they are.
std::string in_quotes(const std::string& text) {
  std::string escaped = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      escaped += {'\\', c};
    } else if (c == '\n') {
      escaped += "\\n";
    } else if (c == '\t') {
      escaped += "\\t";
    } else if ((c >= 0 && c < 0x20) || c == 0x7F) {
      escaped += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    } else {
      escaped += c;
    }
  }
  return escaped + '"';
}

}  // namespace

std::string to_text(const OptionValue& value, bool quoted) {
  if (std::holds_alternative<bool>(value)) return std::get<bool>(value) ? "true" : "false";
  if (std::holds_alternative<std::int64_t>(value)) return std::to_string(std::get<std::int64_t>(value));
  if (std::holds_alternative<double>(value)) {
    const double number = std::get<double>(value);
    const std::string text = fmt::format("{}", number);  // the shortest that reads back equal
    return text.find_first_of(".enf") == std::string::npos ? text + ".0" : text;
  }
  if (std::holds_alternative<std::string>(value)) {
    const std::string& text = std::get<std::string>(value);
    return quoted ? in_quotes(text) : text;
  }
  return "unset";
}

std::string range_text(const OptionSpec& spec) {
  const bool whole = spec.type == OptionType::integer;
  const auto number = [whole](double x) { return whole ? fmt::format("{:.0f}", x) : fmt::format("{}", x); };
  std::string text;
  if (std::isinf(spec.least) && std::isinf(spec.most)) return "";
  if (std::isinf(spec.least)) {
    text = "at most " + number(spec.most);
  } else if (std::isinf(spec.most)) {
    text = "at least " + number(spec.least);
  } else {
    text = number(spec.least) + " to " + number(spec.most);
  }
  return spec.unit.empty() ? text : text + ' ' + spec.unit;
}

namespace {

std::string joined(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, ", ")); }

std::variant<OptionValue, std::string> in_range(const OptionSpec& spec, double number, OptionValue value) {
  if (number >= spec.least && number <= spec.most) return value;
  return fmt::format("'{}' is {}, but must be {}", spec.name, to_text(value), range_text(spec));
}

std::string wants(const OptionSpec& spec, std::string_view what, const OptionValue& value) {
  return fmt::format("'{}' must be {}, not {}", spec.name, what, to_text(value, true));
}

}  // namespace

std::optional<std::vector<double>> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  const auto skip_spaces = [&] { text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size())); };
  for (skip_spaces(); !text.empty(); skip_spaces()) {
    if (!numbers.empty()) {
      if (text.front() != ',') return std::nullopt;
      text.remove_prefix(1);
      skip_spaces();
    }
    double number = 0;
    const auto [end, mistake] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (mistake != std::errc() || !std::isfinite(number)) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    numbers.push_back(number);
  }
  return numbers;
}

std::string numbers_text(const std::vector<double>& numbers) { return fmt::format("{}", fmt::join(numbers, ", ")); }

bool names_file(const OptionSpec& spec, const OptionValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  if (text == nullptr || text->empty()) return false;
  return spec.type == OptionType::scene || spec.type == OptionType::image ||
         (spec.type == OptionType::views && is_view_list(*text));
}

std::variant<OptionValue, std::string> fit(const OptionSpec& spec, const OptionValue& value) {
  switch (spec.type) {
    case OptionType::boolean:
      if (std::holds_alternative<bool>(value)) return value;
      return wants(spec, "true or false", value);
    case OptionType::integer:
      if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        return in_range(spec, static_cast<double>(*whole), value);
      }
      return wants(spec, "a whole number", value);
    case OptionType::number:
      if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        return in_range(spec, static_cast<double>(*whole), static_cast<double>(*whole));
      }
      if (const auto* number = std::get_if<double>(&value)) {
        if (std::isfinite(*number)) return in_range(spec, *number, value);
      }
      return wants(spec, "a finite number", value);
    case OptionType::text:
      if (std::holds_alternative<std::string>(value)) return value;
      return wants(spec, "a string", value);
    case OptionType::numbers:
      if (const auto* text = std::get_if<std::string>(&value); text != nullptr && numbers_in(*text)) return value;
      if (const auto* whole = std::get_if<std::int64_t>(&value)) return OptionValue(to_text(*whole));
      if (const auto* number = std::get_if<double>(&value); number != nullptr && std::isfinite(*number)) {
        return OptionValue(to_text(*number));
      }
      return wants(spec, "numbers, such as \"0.5, 0.25\"", value);
    case OptionType::scene:
    case OptionType::image:
      if (const auto* path = std::get_if<std::string>(&value); path != nullptr && !path->empty()) return value;
      return wants(spec, spec.type == OptionType::scene ? "the path of a scene" : "the path of an image", value);
    case OptionType::number_or_text:
    case OptionType::views:
      if (std::holds_alternative<std::string>(value)) return value;
      if (std::holds_alternative<std::int64_t>(value)) return OptionValue(to_text(value));
      return wants(spec, "a whole number or a string", value);
    case OptionType::choice:
      if (const auto* word = std::get_if<std::string>(&value)) {
        if (std::find(spec.choices.begin(), spec.choices.end(), *word) != spec.choices.end()) return value;
      }
      return fmt::format("'{}' is {}, but must be one of {}", spec.name, to_text(value), joined(spec.choices));
  }
  return value;
}

}  // namespace foredraw
