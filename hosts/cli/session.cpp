#include "session.h"

#include <foredraw/pipeline/canonical.h>
#include <foredraw/pipeline/contest.h>
#include <foredraw/platform/terminal.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace foredraw::cli {

void tell(const std::vector<Diagnostic>& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics) {
    fmt::print(stderr, "{}{}\n", diagnostic.where.file.empty() ? "foredraw: " : "", to_text(diagnostic));
  }
}

void tell(const Diagnostics& diagnostics) { tell(diagnostics.all()); }

Exit refuse(const Diagnostics& diagnostics) {
  tell(diagnostics);
  return users_mistake;
}

Exit exit_for_file(const Diagnostics& diagnostics) {
  const bool missing = std::ranges::any_of(
      diagnostics.all(), [](const Diagnostic& d) { return d.code == "no-such-file" || d.code == "is-a-folder"; });
  return missing ? users_mistake : something_failed;
}

Exit refuse_file(const Diagnostics& diagnostics) {
  tell(diagnostics);
  return exit_for_file(diagnostics);
}

Exit tell_interrupted(const std::string& what_is_left) {
  fmt::print(stderr, "foredraw: interrupted{}{}\n", what_is_left.empty() ? "" : ": ", what_is_left);
  return interrupted;
}

Exit print(const std::string& text) {
  Diagnostics diagnostics;
  return write_standard_output(std::as_bytes(std::span(text)), diagnostics) ? done : refuse_file(diagnostics);
}

Exit print_pieces(const std::function<void(const OutputFile::Put&)>& write) {
  Diagnostics diagnostics;
  write([&](std::string_view text) {
    if (!diagnostics.has_errors()) write_standard_output(std::as_bytes(std::span(text)), diagnostics);
  });
  return diagnostics.has_errors() ? refuse_file(diagnostics) : done;
}

std::filesystem::path spool_folder(const std::string& report) {
  if (report.empty()) return {};
  const auto folder = std::filesystem::path(report).parent_path();
  return folder.empty() ? "." : folder;
}

SceneInput input_of(const Arguments& arguments, const Registry& registry) {
  return {registry.products(), arguments.strict, arguments.root, Executor(arguments.threads)};
}

namespace {

bool set_wherever_it_is(std::vector<NamedPipeline>& pipelines, const std::string& assignment,
                        Diagnostics& diagnostics) {
  Diagnostics nowhere;
  bool found = false;
  for (NamedPipeline& named : pipelines) {
    Diagnostics here;
    if (set_option(named.pipeline, assignment, here)) {
      found = true;
      continue;
    }
    const bool no_such_stage = here.all().front().code == "no-such-stage";
    for (const Diagnostic& diagnostic : here.all()) (no_such_stage ? nowhere : diagnostics).add(diagnostic);
    if (!no_such_stage) return false;
  }
  if (!found) diagnostics.add(nowhere.all().front());
  return found;
}

}  // namespace

std::optional<std::vector<NamedPipeline>> pipelines_for(const Arguments& arguments, const Registry& registry,
                                                        const std::vector<std::string>& texts,
                                                        Diagnostics& diagnostics) {
  std::vector<NamedPipeline> pipelines;
  for (const std::string& text : texts) {
    auto branches = load_branches(text, diagnostics);
    if (branches) std::ranges::move(*branches, std::back_inserter(pipelines));
  }
  auto measure = arguments.with.empty() ? std::optional<std::vector<Stage>>(std::in_place)
                                        : parse_stages(arguments.with, "--with", diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  measure_alike(pipelines, std::move(*measure), registry);
  bool good = true;
  for (const std::string& assignment : arguments.set)
    good = set_wherever_it_is(pipelines, assignment, diagnostics) && good;
  judge_alike(pipelines, registry);
  return good ? std::optional(std::move(pipelines)) : std::nullopt;
}

std::optional<Pipeline> one_pipeline(const Arguments& arguments, const Registry& registry, Diagnostics& diagnostics) {
  if (arguments.pipelines.size() > 1) {
    diagnostics.error({}, "bad-arguments", "--pipeline is given more than once", "use foredraw compare to run several");
    return std::nullopt;
  }
  const std::string text = arguments.pipelines.empty() ? "@default" : arguments.pipelines.front();
  return only_one(pipelines_for(arguments, registry, {text}, diagnostics), text, diagnostics);
}

std::vector<std::filesystem::path> files_of(const Arguments& arguments, const Pipeline& pipeline,
                                            const Registry& registry) {
  std::vector<std::filesystem::path> files = files_named_in(pipeline, registry);
  std::error_code error;
  for (const std::string& text : arguments.pipelines) {
    if (std::filesystem::is_regular_file(text, error)) files.emplace_back(text);
  }
  return files;
}

bool is_sound(const Pipeline& pipeline, const Registry& registry, const Lender& lender, Diagnostics& diagnostics) {
  Diagnostics found;
  if (plan(pipeline, registry, Scene(), found, &lender)) return true;
  for (const Diagnostic& diagnostic : found.all()) {
    if (diagnostic.severity == Severity::error) diagnostics.add(diagnostic);
  }
  return false;
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

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  const auto place = [&](const std::string& path) {  // what is not there yet stays relative unless it is asked for
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
  };
  return place(a) == place(b);
}

std::optional<Baseline> baseline_of(const Arguments& arguments, Diagnostics& diagnostics) {
  const auto bytes = arguments.baseline.empty() ? std::nullopt : read_file(arguments.baseline, diagnostics);
  if (!bytes) return std::nullopt;
  const std::string text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  return read_baseline(text, arguments.baseline, diagnostics);
}

std::string program_name() { return std::string("foredraw ") + FOREDRAW_VERSION; }

OutputFile text_file(const std::string& path, const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {path, {bytes.begin(), bytes.end()}};
}

bool make_folder(const std::filesystem::path& folder, Diagnostics& diagnostics) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    diagnostics.error({.file = folder.string()}, "can-not-make-folder", "cannot be created: " + error.message(),
                      "choose an output folder that you may write to");
  }
  return !error;
}

bool have_folders(const std::vector<std::string>& files, Diagnostics& diagnostics) {
  std::error_code none;
  for (const std::string& file : files) {
    const auto folder = std::filesystem::path(file).parent_path();
    if (folder.empty() || std::filesystem::is_directory(folder, none)) continue;
    diagnostics.error({.file = file}, "no-such-folder",
                      "cannot be written: there is no folder '" + folder.string() + "'",
                      "create it, or name another folder");
  }
  return !diagnostics.has_errors();
}

}  // namespace foredraw::cli
