#pragma once
// The one-line form: stages with commas between them, each a name with its options in parentheses. Values are spelled
// as in TOML, except that a text of plain characters (letters, digits and _ - + . / @ * ?) needs no quotes.

#include <foredraw/pipeline/pipeline.h>
#include <foredraw/pipeline/private/words.h>

#include <string_view>

namespace foredraw {

/// Where a scanned text stands in what the user gave.
struct TextPlace {
  Where start;
  bool exact = true;  ///< a place in the text is as far from the start; not so behind escapes
};

/// nullopt at the first mistake of form, or after all mistakes of reserved words.
std::optional<std::vector<Stage>> scan_stages(std::string_view text, const TextPlace& place, Diagnostics& diagnostics);

/// Options as between the parentheses of a stage, "a=1, b=c"; none in an empty text.
std::optional<StageWords> scan_options(std::string_view text, const TextPlace& place, Diagnostics& diagnostics);

/// A value with nothing after it.
std::optional<OptionValue> scan_value(std::string_view text, const TextPlace& place, Diagnostics& diagnostics);

/// Whether it can stand without quotes: as a name, or as a value that is still this text when read back.
bool is_plain_name(std::string_view text);
bool is_plain_text(std::string_view text);

}  // namespace foredraw
