#include "session.h"

#include <foredraw/pipeline/parse.h>
#include <foredraw/platform/terminal.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw::cli {

void tell(const std::vector<Diagnostic>& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics) fmt::print(stderr, "{}\n", to_text(diagnostic));
}

void tell(const Diagnostics& diagnostics) { tell(diagnostics.all()); }

Exit refuse(const Diagnostics& diagnostics) {
  tell(diagnostics);
  return users_mistake;
}

Exit refuse_file(const Diagnostics& diagnostics) {
  tell(diagnostics);
  const bool missing = std::ranges::any_of(diagnostics.all(), [](const Diagnostic& d) {
    return d.code == "no-such-file" || d.code == "is-a-folder";
  });
  return missing ? users_mistake : something_failed;
}

std::optional<Pipeline> pipeline_for(const Arguments& arguments, const std::string& text, Diagnostics& diagnostics) {
  std::optional<Pipeline> pipeline = load_pipeline(text, diagnostics);
  if (!pipeline) return std::nullopt;
  if (!arguments.with.empty()) {
    auto measure = parse_stages(arguments.with, "--with", diagnostics);
    if (!measure) return std::nullopt;
    pipeline->measure = std::move(*measure);
  } else if (pipeline->measure.empty()) {
    pipeline->measure = load_pipeline("@default", diagnostics)->measure;
  }
  bool good = true;
  for (const std::string& assignment : arguments.set) good = set_option(*pipeline, assignment, diagnostics) && good;
  return good ? pipeline : std::nullopt;
}

std::function<void(std::string_view, double)> progress_line() {
  if (!stderr_is_terminal()) return {};
  return [](std::string_view what, double part) {
    fmt::print(stderr, "\r\033[K[{:3.0f} %] {}", 100 * part, what);
    std::fflush(stderr);
  };
}

void end_progress() {
  if (stderr_is_terminal()) fmt::print(stderr, "\r\033[K");
}

bool write_text(const std::string& path, const std::string& text, Diagnostics& diagnostics) {
  const auto bytes = std::as_bytes(std::span(text));
  const OutputFile file{path, {bytes.begin(), bytes.end()}};
  return write_files(std::span(&file, 1), diagnostics);
}

}  // namespace foredraw::cli
