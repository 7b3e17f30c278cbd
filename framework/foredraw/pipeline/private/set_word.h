#pragma once
// One word of an option table, set by its name.

#include <foredraw/base/diagnostics.h>
#include <foredraw/technique/options.h>

#include <string>

namespace foredraw {

struct WordValue {
  std::string word;
  OptionValue value;
  Where where;       ///< of the value
  Where word_where;  ///< of the word
};

std::string there_are(const std::vector<OptionSpec>& specs);

/// Sets it in the options; false, with an error, if the table has no such word or the value does not fit.
template <class Options>
bool set_word(const OptionTable<Options>& table, Options& options, const WordValue& given, Diagnostics& diagnostics) {
  for (const OptionSpec& spec : table.specs()) {
    if (spec.name != given.word) continue;
    auto fitted = fit(spec, given.value);
    if (const auto* why = std::get_if<std::string>(&fitted)) {
      diagnostics.error(given.where, "bad-value", *why);
      return false;
    }
    table.apply({{spec.name, std::get<OptionValue>(std::move(fitted))}}, options);
    return true;
  }
  diagnostics.error(given.word_where, "unknown-word", "there is no '" + given.word + "'", there_are(table.specs()));
  return false;
}

}  // namespace foredraw
