// Whatever the text, parsing it ends well; what parses prints, in the form that it had, and parses back equal.

#include "claim.h"

#include <foredraw/pipeline/parse.h>

namespace foredraw {
namespace {

void file_goes_round(std::string_view text) {
  Diagnostics diagnostics;
  const auto pipeline = parse_file(text, "input", diagnostics);
  claim(pipeline.has_value() != diagnostics.has_errors(), "parsed and not parsed at once: " + to_text(diagnostics));
  if (!pipeline) return;
  const std::string printed = print_file(*pipeline);
  const auto again = parse_file(printed, "printed", diagnostics);
  claim(again.has_value(), "does not parse back:\n" + printed + to_text(diagnostics));
  claim(same_pipeline(*pipeline, *again), "parses back as another:\n" + printed);
}

void line_goes_round(std::string_view text) {
  Diagnostics diagnostics;
  const auto pipeline = parse_line(text, diagnostics);
  claim(pipeline.has_value() != diagnostics.has_errors(), "parsed and not parsed at once: " + to_text(diagnostics));
  if (!pipeline) return;
  const auto line = print_line(*pipeline);
  claim(line.has_value(), "a line holds stages alone, yet does not print as one");
  const auto again = parse_line(*line, diagnostics);
  claim(again.has_value(), "does not parse back: " + *line + '\n' + to_text(diagnostics));
  claim(same_pipeline(*pipeline, *again), "parses back as another: " + *line);
  file_goes_round(print_file(*pipeline));
}

}  // namespace
}  // namespace foredraw

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  foredraw::file_goes_round(text);
  foredraw::line_goes_round(text);
  return 0;
}
