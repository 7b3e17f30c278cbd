#include <foredraw/pipeline/private/line_scanner.h>

#include <foredraw/pipeline/private/toml.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("_-+./@*?").find(c) != std::string_view::npos;
}

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// Continuation bytes of UTF-8 belong to the character before them.
bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }

/// ".25" as "0.25": people write the first, TOML has only the second.
std::string with_leading_zero(std::string word) {
  const std::size_t dot = word.find_first_not_of("+-");
  if (dot < 2 && word[dot] == '.') word.insert(dot, "0");
  return word;
}

OptionValue value_of_word(const std::string& word) {
  const toml::parse_result read = toml::parse("value = " + with_leading_zero(word));
  if (!read) return word;
  const toml::node& node = *read.table().get("value");
  if (const auto* truth = node.as_boolean()) return truth->get();
  if (const auto* whole = node.as_integer()) return whole->get();
  if (const auto* number = node.as_floating_point()) return number->get();
  return word;
}

class Scanner {
 public:
  Scanner(std::string_view text, const TextPlace& place, Diagnostics& diagnostics)
      : text_(text), counts_places_(place.exact), where_(place.start), diagnostics_(diagnostics) {}

  std::optional<std::vector<Stage>> stages() {
    std::vector<Stage> stages;
    bool good = true;
    skip_space();
    if (at_end()) return stages;
    do {
      StageWords words;
      skip_space();
      const Where where = here();
      if (!read_stage(words)) return std::nullopt;
      if (auto stage = stage_of(words, where, diagnostics_)) {
        stages.push_back(std::move(*stage));
      } else {
        good = false;
      }
    } while (take(','));
    if (!at_end()) {
      mistake("',' or the end", is_plain(text_[next_])
                                    ? "separate stages with commas, and put options in parentheses: name(option=value)"
                                    : "");
      return std::nullopt;
    }
    if (!good) return std::nullopt;
    return stages;
  }

  std::optional<StageWords> only_options() {
    StageWords words;
    skip_space();
    if (at_end()) return words;
    do {
      if (!read_option(words)) return std::nullopt;
    } while (take(','));
    if (at_end()) return words;
    mistake("',' or the end", "options are given as name=value, with commas between them");
    return std::nullopt;
  }

  std::optional<OptionValue> only_value() {
    auto value = read_value();
    if (!value) return std::nullopt;
    skip_space();
    if (at_end()) return value;
    mistake("nothing after the value",
            "put text with spaces or commas in quotes that the shell leaves: 'STAGE.OPTION=\"0.5, 0.25\"'");
    return std::nullopt;
  }

 private:
  bool at_end() const { return next_ == text_.size(); }

  /// The place of what is next. Counted on from where it was asked last.
  Where here() {
    for (; counts_places_ && counted_ < next_; ++counted_) {
      if (text_[counted_] == '\n') {
        ++where_.line;
        where_.column = 1;
      } else if (begins_character(text_[counted_])) {
        ++where_.column;
      }
    }
    return where_;
  }

  void skip_space() {
    while (!at_end() && is_space(text_[next_])) ++next_;
  }

  bool take(char c) {
    skip_space();
    if (at_end() || text_[next_] != c) return false;
    ++next_;
    return true;
  }

  std::string found() const {
    if (at_end()) return "the end";
    std::size_t end = next_ + 1;
    while (end < text_.size() && !begins_character(text_[end])) ++end;
    return fmt::format("'{}'", text_.substr(next_, end - next_));
  }

  void mistake(std::string_view expected, std::string hint = {}) {
    diagnostics_.error(here(), "syntax", fmt::format("expected {}, found {}", expected, found()), std::move(hint));
  }

  bool read_stage(StageWords& words) {
    const auto use = read_name("a stage");
    if (!use) return false;
    words.values["use"] = *use;
    if (!take('(') || take(')')) return true;
    do {
      if (!read_option(words)) return false;
    } while (take(','));
    if (take(')')) return true;
    mistake("',' or ')'",
            at_end() ? "close the options with )" : "put text with spaces or special characters in quotes");
    return false;
  }

  bool read_option(StageWords& words) {
    skip_space();
    const Where name_where = here();
    const auto name = read_name("an option");
    if (!name) return false;
    if (!take('=')) {
      mistake(fmt::format("'=' after '{}'", *name), "options are given as name=value");
      return false;
    }
    skip_space();
    const Where where = here();
    auto value = read_value();
    if (!value) return false;
    if (!words.values.emplace(*name, std::move(*value)).second) {
      diagnostics_.error(name_where, "twice", fmt::format("'{}' is given twice", *name), "leave one of them out");
      return false;
    }
    words.where[*name] = where;
    return true;
  }

  std::optional<std::string> read_name(std::string_view what) {
    skip_space();
    if (at_quote()) return read_quoted();
    std::string word = read_word();
    if (!word.empty()) return word;
    mistake(what);
    return std::nullopt;
  }

  std::optional<OptionValue> read_value() {
    skip_space();
    if (at_quote()) return read_quoted();
    const std::string word = read_word();
    if (!word.empty()) return value_of_word(word);
    mistake("a value", at_end()
                           ? "an empty text is written \"\""
                           : "put text with spaces or special characters in quotes, and lists, too, without brackets: "
                             "\"0.5, 0.25\"");
    return std::nullopt;
  }

  std::string read_word() {
    const std::size_t begin = next_;
    while (!at_end() && is_plain(text_[next_])) ++next_;
    return std::string(text_.substr(begin, next_ - begin));
  }

  bool at_quote() const { return !at_end() && (text_[next_] == '"' || text_[next_] == '\''); }

  /// As in TOML: "with \" and \\ and \n", or 'as it stands'.
  std::optional<std::string> read_quoted() {
    const Where where = here();
    const std::size_t begin = next_;
    const char quote = text_[next_++];
    while (!at_end() && text_[next_] != quote) {
      const bool escapes = text_[next_] == '\\' && quote == '"';
      next_ = std::min(next_ + (escapes ? 2 : 1), text_.size());
    }
    if (at_end()) {
      diagnostics_.error(where, "syntax", "the quoted text that begins here has no end",
                         fmt::format("close it with {}", quote));
      return std::nullopt;
    }
    ++next_;
    const toml::parse_result read = toml::parse(fmt::format("text = {}", text_.substr(begin, next_ - begin)));
    if (read) return read.table().get("text")->value<std::string>();
    diagnostics_.error(where, "syntax",
                       fmt::format("the quoted text that begins here cannot be read: {}", read.error().description()));
    return std::nullopt;
  }

  std::string_view text_;
  std::size_t next_ = 0;
  bool counts_places_;
  std::size_t counted_ = 0;
  Where where_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::optional<std::vector<Stage>> scan_stages(std::string_view text, const TextPlace& place, Diagnostics& diagnostics) {
  return Scanner(text, place, diagnostics).stages();
}

std::optional<StageWords> scan_options(std::string_view text, const TextPlace& place, Diagnostics& diagnostics) {
  return Scanner(text, place, diagnostics).only_options();
}

std::optional<OptionValue> scan_value(std::string_view text, const TextPlace& place, Diagnostics& diagnostics) {
  return Scanner(text, place, diagnostics).only_value();
}

bool is_plain_name(std::string_view text) { return !text.empty() && std::ranges::all_of(text, is_plain); }

bool is_plain_text(std::string_view text) {
  return is_plain_name(text) && std::holds_alternative<std::string>(value_of_word(std::string(text)));
}

}  // namespace foredraw
