#include <foredraw/job/result_cache.h>

#include <foredraw/cache/result_about.h>
#include <foredraw/io/imported_file.h>
#include <foredraw/pipeline/canonical.h>
#include <foredraw/platform/machine.h>
#include <foredraw/platform/program_stamp.h>
#include <foredraw/report/readdressed.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace foredraw {

namespace {

namespace fs = std::filesystem;

std::string extension_in_lower_case(const fs::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension;
}

/// Everything that decides what comes of a scene, but for the scene.
std::string done_by(const Pipeline& pipeline, const Registry& registry, const Cache& cache) {
  std::string text = to_text(program_stamp()) + '\n' + canonical_text(pipeline, registry);
  for (const fs::path& file : files_named_in(pipeline, registry)) {
    const auto content = cache.hashes().of(file, FileRead::all_of_it);
    text += fmt::format("file {} {}\n", file.string(), content ? to_text(content->stamp) : "");
  }
  for (const std::vector<Stage>* stages : {&pipeline.stages, &pipeline.measure}) {
    for (const Stage& stage : *stages) {
      if (const ModuleFile* module = registry.module_of(stage.use)) text += fmt::format("module {}\n", module->hash);
    }
  }
  for (const std::string& device : devices_in(pipeline, registry)) {
    text += fmt::format("device {} of {}\n", device, machine_text());
  }
  return text;
}

/// How scenes are read. What is imported comes by a program of its own, whose build counts as ours does.
std::string read_by(const SceneInput& how, const std::string& input, bool is_folder) {
  const bool may_import = is_folder || is_imported_file(input);
  return fmt::format("strict {}\nroot {}\n{}", how.strict, how.root.string(),
                     may_import ? "importer " + to_text(importer_stamp(import_limits())) + '\n' : "");
}

Stamp stamp_of(const std::string& text) { return content_hash(std::as_bytes(std::span(text))); }

/// Whether what was written says by which names its files go, or where others lie.
bool holds_names(const std::string& input, const std::vector<JobOutput>& outputs,
                 const std::vector<std::vector<OutputFile>>& files, const Scene& scene) {
  const auto is_glb = [](const fs::path& path) { return extension_in_lower_case(path) == ".glb"; };
  return !is_glb(input) ||
         std::ranges::any_of(outputs, [&](const JobOutput& output) { return output.row || !is_glb(output.path); }) ||
         std::ranges::any_of(files, [](const auto& of_one) { return of_one.size() != 1; }) ||
         std::ranges::any_of(scene.images, [](const Image& image) { return !image.uri.empty(); });
}

bool is_one_of(const fs::path& path, const std::vector<fs::path>& files) {
  std::error_code error;
  const fs::path whole = fs::absolute(path, error).lexically_normal();
  return std::ranges::any_of(files, [&](const fs::path& file) {
    return fs::absolute(file, error).lexically_normal() == whole || fs::equivalent(file, path, error);
  });
}

std::string with_names(std::string text, const std::string& old, const std::string& now) {
  const std::size_t at = old == now ? std::string::npos : text.find(old);
  return at == std::string::npos ? text : text.replace(at, old.size(), now);
}

std::string text_in(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

std::unique_ptr<ResultCache> ResultCache::opened(const fs::path& folder, const Pipeline& pipeline,
                                                 const Registry& registry, const SceneInput& how,
                                                 const std::string& input, Told told, Diagnostics& diagnostics) {
  auto cache = Cache::in(folder, diagnostics);
  if (!cache) return nullptr;
  std::error_code error;
  const bool is_folder = fs::is_directory(input, error);
  std::string key = "results 2\n" + done_by(pipeline, registry, *cache) + read_by(how, input, is_folder);
  return std::unique_ptr<ResultCache>(
      new ResultCache(std::move(*cache), std::move(key), print_file(pipeline), is_folder, std::move(told)));
}

Work ResultCache::work_for(const std::string& input, const std::vector<JobOutput>& outputs) const {
  std::string text = how_ + "input " + extension_in_lower_case(input) + '\n';
  std::string place = fs::path(input).filename().string() + '\n';
  std::error_code error;
  const auto folder_of = [&](const fs::path& path) {
    return fs::absolute(path, error).lexically_normal().parent_path();
  };
  for (const JobOutput& output : outputs) {
    text += "output " + output.kind + ' ' + extension_in_lower_case(output.path) + '\n';
    place += fs::path(output.path).filename().string() + '\n' +
             folder_of(input).lexically_relative(folder_of(output.path)).string() + '\n';
  }
  return {stamp_of(text), input, std::move(place)};
}

std::optional<Recalled> ResultCache::recalled(const std::string& input, const std::vector<JobOutput>& outputs) const {
  Diagnostics damaged;
  const auto found = find_result(cache_, work_for(input, outputs), damaged);
  tell_now(damaged);
  const auto about = found ? result_about(found->entry.about()) : std::nullopt;
  if (!about || found->entry.size() != about->files.size() + 2 || about->outputs.size() != outputs.size()) {
    return std::nullopt;
  }
  const Cache::Entry& entry = found->entry;
  std::vector<std::vector<OutputFile>> files(outputs.size());
  std::vector<std::pair<fs::path, std::size_t>> places;  // and of which content
  bool are_there = true;
  for (std::size_t i = 0; i < about->files.size(); ++i) {
    const auto& [output, name] = about->files[i];
    if (output >= outputs.size()) return std::nullopt;
    const fs::path path = outputs[output].path;
    const fs::path place = name.empty() ? path : path.parent_path() / name;
    if (is_one_of(place, found->read)) return std::nullopt;  // who writes it says that this can not be
    const auto content = cache_.hashes().of(place, FileRead::all_of_it);
    are_there =
        are_there && content && content->stamp == entry.stamp(i).stamp && content->bytes == entry.stamp(i).bytes;
    places.emplace_back(place, i);
  }
  const auto damage = [&]() -> std::optional<Recalled> {
    Diagnostics told;
    tell_damaged(cache_.place_of(found->key), told);
    tell_now(told);
    return std::nullopt;
  };
  for (std::size_t i = 0; i < places.size() && !are_there; ++i) {
    auto bytes = entry.read(i);
    if (!bytes) return damage();
    files[about->files[i].output].push_back({places[i].first, std::move(*bytes)});
  }
  const auto json = entry.read(about->files.size()), text = entry.read(about->files.size() + 1);
  if (!json || !text) return damage();
  if (text->empty() && !is_of_folder_) return std::nullopt;

  Recalled run{text_in(*json), with_names(text_in(*text), about->input, input), {}, found->read, found->sought};
  std::map<std::string, std::string> renamed{{about->input, input}};
  bool is_renamed = about->input != input || about->pipeline != pipeline_;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    renamed.emplace(about->outputs[i], outputs[i].path);
    run.text = with_names(std::move(run.text), about->outputs[i], outputs[i].path);
    is_renamed = is_renamed || about->outputs[i] != outputs[i].path;
  }
  if (is_renamed) run.json = readdressed(run.json, renamed, pipeline_);
  if (!are_there) run.files = std::move(files);
  return run;
}

void ResultCache::keep(const std::string& input, const std::vector<JobOutput>& outputs,
                       const std::vector<std::vector<OutputFile>>& files, const WorkRead& read, const Scene& scene,
                       const Report& report, const std::string& json) const {
  ResultAbout about{input, {}, pipeline_, {}};
  std::vector<std::span<const std::byte>> contents;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    about.outputs.push_back(outputs[i].path);
    for (const OutputFile& file : files[i]) {
      if (file.rest) return;  // made while it is written
      about.files.push_back({i, file.path == outputs[i].path ? "" : file.path.filename().string()});
      contents.emplace_back(file.bytes);
    }
  }
  const std::string text = is_of_folder_ ? "" : to_text(report);
  contents.push_back(std::as_bytes(std::span(json)));
  contents.push_back(std::as_bytes(std::span(text)));
  tell_once(keep_result(cache_, work_for(input, outputs), read, holds_names(input, outputs, files, scene),
                        to_text(about), contents));
}

void ResultCache::tell_once(const std::string& why) const {
  if (why.empty()) return;
  Diagnostics diagnostics;
  diagnostics.warning({}, "cache-not-written", "results could not be put into the cache: " + why,
                      "outputs are not affected; make room, or choose a folder that you may write to");
  const std::lock_guard lock(telling_);
  if (!std::exchange(has_told_, true)) told_(diagnostics);
}

void ResultCache::tell_now(const Diagnostics& diagnostics) const {
  if (diagnostics.empty()) return;
  const std::lock_guard lock(telling_);
  told_(diagnostics);
}

}  // namespace foredraw
