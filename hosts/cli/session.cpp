#include "session.h"

#include <foredraw/job/pipelines.h>
#include <foredraw/pipeline/canonical.h>
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

SceneInput input_of(const ReadingArguments& reading, const CommonArguments& arguments, const Registry& registry) {
  return {registry.products(), reading.strict, reading.root, Executor(arguments.threads)};
}

JobSetup setup_of(const CommonArguments& arguments, const Registry& registry, const Executor& executor,
                  const Lender& lender, SceneInput how) {
  return {.registry = registry,
          .executor = executor,
          .lender = &lender,
          .input = std::move(how),
          .cancel = arguments.cancel()};
}

std::optional<std::vector<NamedPipeline>> pipelines_for(const PipelineArguments& arguments, const Registry& registry,
                                                        const std::vector<std::string>& texts,
                                                        Diagnostics& diagnostics) {
  std::vector<NamedPipeline> pipelines;
  for (const std::string& text : texts) {
    auto branches = load_branches(text, diagnostics);
    if (branches) std::ranges::move(*branches, std::back_inserter(pipelines));
  }
  if (diagnostics.has_errors()) return std::nullopt;
  const PipelineChanges changes{arguments.with, arguments.set, arguments.written_as};
  return change(pipelines, changes, registry, diagnostics) ? std::optional(std::move(pipelines)) : std::nullopt;
}

std::optional<Pipeline> one_pipeline(const PipelineArguments& arguments, const Registry& registry,
                                     Diagnostics& diagnostics) {
  if (arguments.pipelines.size() > 1) {
    diagnostics.error({}, "bad-arguments", "--pipeline is given more than once", "use foredraw compare to run several");
    return std::nullopt;
  }
  const std::string text = arguments.pipelines.empty() ? "@default" : arguments.pipelines.front();
  return only_one(pipelines_for(arguments, registry, {text}, diagnostics), text, diagnostics);
}

std::vector<std::filesystem::path> files_of(const PipelineArguments& arguments, const Pipeline& pipeline,
                                            const Registry& registry) {
  std::vector<std::filesystem::path> files = files_named_in(pipeline, registry);
  std::error_code error;
  for (const std::string& text : arguments.pipelines) {
    if (std::filesystem::is_regular_file(text, error)) files.emplace_back(text);
  }
  return files;
}

std::unique_ptr<ResultCache> cache_of(const std::string& folder, const std::string& input, const Pipeline& pipeline,
                                      const Registry& registry, const SceneInput& how, Diagnostics& diagnostics) {
  if (folder.empty()) return nullptr;
  const auto told = [](const Diagnostics& wrong) {
    end_progress();
    tell(wrong);
  };
  return ResultCache::opened(folder, pipeline, registry, how, input, told, diagnostics);
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

std::optional<Baseline> baseline_of(const std::string& file, Diagnostics& diagnostics) {
  const auto bytes = file.empty() ? std::nullopt : read_file(file, diagnostics);
  if (!bytes) return std::nullopt;
  const std::string text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  return read_baseline(text, file, diagnostics);
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

}  // namespace foredraw::cli
