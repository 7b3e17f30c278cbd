#include "file_runs.h"
#include "folder_outputs.h"

#include <foredraw/io/sprite/sprite_files.h>
#include <foredraw/job/pipelines.h>
#include "scene_folder.h"

#include <foredraw/base/counted.h>
#include <foredraw/report/since.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <mutex>

namespace foredraw::cli {

namespace {

namespace fs = std::filesystem;

/// All sprites in one file each; scenes that were lost are missing.
bool gather(const std::vector<std::optional<Scene>>& kept, const std::vector<std::string>& gathered,
            Diagnostics& diagnostics) {
  std::vector<Scene> scenes;
  for (const std::optional<Scene>& scene : kept) {
    if (scene && is_sprite_input(scene->name)) scenes.push_back(*scene);
  }
  const auto files = encode_together(scenes, gathered, diagnostics);
  return files && write_files(*files, diagnostics);
}

FileRun lost(const fs::path& input, const std::string& why, const std::string& hint) {
  FileRun run;
  run.report.input.path = input.string();
  run.report.diagnostics = {{Severity::error, {.file = input.string()}, "lost", why, hint}};
  run.exit = something_failed;
  run.is_lost = true;
  return run;
}

std::string json_of(const FileRun& run) { return run.json.empty() ? to_json(run.report) : run.json; }

/// Works on all files at once, and tells of each as soon as all before it are done.
Exit run_batch(const FileJob& job, const std::vector<std::string>& inputs,
               const std::function<FileRun(const FileJob&, std::size_t)>& run_one, Batch& batch) {
  const auto progress = progress_line();
  std::mutex at_the_line;
  std::size_t finished = 0;
  std::atomic<Exit> worst = done;
  job.setup.executor.for_each(inputs.size(), [&](std::size_t i) {
    FileRun run = guarded(inputs[i], [&] { return run_one(job, i); });
    if (run.exit == interrupted) {
      worst = interrupted;
      return;
    }
    const Outcome outcome = run.is_lost ? Outcome::lost : run.exit != done ? Outcome::in_part : Outcome::done;
    batch.add(i, json_of(run), outcome, run.from_cache);
    const std::scoped_lock lock(at_the_line);
    if (run.exit != done && worst == done) worst = something_failed;
    ++finished;
    if (progress) progress(inputs[i], static_cast<double>(finished) / static_cast<double>(inputs.size()));
  });
  end_progress();
  if (worst == interrupted) {
    tell_interrupted(
        fmt::format("{} of {} done; the same command does the others", finished, counted(inputs.size(), "file")));
  }
  return worst;
}

/// Of each file, above the line of progress.
void tell_file(const StoredReport& report, Outcome) {
  if (report.diagnostics.empty()) return;
  end_progress();
  tell(report.diagnostics);
}

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace

FileRun guarded(const fs::path& input, const std::function<FileRun()>& run) {
  const std::string hint = "allow more memory, or use --threads 1";
  try {
    return run();
  } catch (const OutOfMemory& lack) {
    return lost(input, "there is not enough memory to " + lack.doing, hint);
  } catch (const std::bad_alloc&) {
    return lost(input, "there is not enough memory", hint);
  } catch (const std::exception& problem) {
    return lost(input, problem.what(), "");
  }
}

bool is_folder(const std::string& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

Exit optimize_folder(const FileJob& job, const OptimizeArguments& arguments) {
  Diagnostics diagnostics;
  const fs::path from = arguments.inputs[0];
  const FolderOutputs wanted = outputs_in(arguments.outputs, job.setup.registry.products(), diagnostics);
  const fs::path to = wanted.folder;
  std::error_code error;
  if (to == "-" || (fs::exists(to, error) && !is_folder(wanted.folder))) {
    diagnostics.error({.file = wanted.folder}, "bad-arguments", "is not a folder, but the input is one",
                      "give -o the name of a folder; it is created if it does not exist");
  }
  if (fs::equivalent(from, to, error)) {
    diagnostics.error({.file = wanted.folder}, "bad-arguments", "is the input folder itself",
                      "give -o another folder: several scenes may share a .bin, which must not be overwritten");
  }
  if (!arguments.html.empty()) {
    diagnostics.error({}, "bad-arguments", "--html makes the page of one scene, but the input is a folder",
                      "use foredraw compare, which makes one page of several scenes");
  }
  is_sound(job.pipeline, job.setup.registry, *job.setup.lender, diagnostics);
  const FolderScenes which = scenes_for(job.pipeline, job.setup.registry);
  const auto scenes = diagnostics.has_errors() ? std::nullopt : scenes_below(from, to, which, diagnostics);
  if (!scenes) return refuse(diagnostics);
  if (!wanted.gathered.empty() && std::ranges::none_of(*scenes, is_sprite_input)) {
    diagnostics.error(
        {.file = wanted.gathered[0]}, "bad-arguments",
        "is a file of sprites, but there are none: the folder has no sprites, or the pipeline has no stage for them",
        "for a folder of meshes, give -o a folder");
    return refuse(diagnostics);
  }
  if (!wanted.gathered.empty() && (arguments.shard || !arguments.cache.empty())) {
    diagnostics.error({.file = wanted.gathered[0]}, "bad-arguments",
                      "holds the sprites of all files, so that --shard and --cache cannot be used",
                      "give -o a folder, or leave these options out");
    return refuse(diagnostics);
  }
  const auto written_of = wanted.folder.empty() ? std::vector<fs::path>() : *scenes;
  if (outputs_meet(written_of, from, wanted, diagnostics)) return refuse(diagnostics);
  std::vector<std::string> inputs;
  std::vector<std::vector<JobOutput>> outputs;
  fs::path made;
  for (const fs::path& scene : *scenes) {
    if (arguments.shard && !holds(*arguments.shard, scene)) continue;
    inputs.push_back((from / scene).string());
    outputs.emplace_back();
    if (wanted.folder.empty()) continue;
    const fs::path output = output_of(scene, to);
    if (output.parent_path() != made && !make_folder(output.parent_path(), diagnostics)) {
      return refuse_file(diagnostics);
    }
    made = output.parent_path();
    outputs.back().push_back({{}, output.string()});
  }
  std::vector<std::string> written = wanted.gathered;
  written.insert(written.end(), {arguments.report, arguments.depfile});
  if (!have_folders(written, diagnostics)) return refuse_file(diagnostics);

  const auto baseline = baseline_of(arguments.baseline, diagnostics);
  if (diagnostics.has_errors()) return refuse(diagnostics);
  std::optional<Since> since;
  if (baseline) since.emplace(arguments.baseline, *baseline, arguments.shard.has_value());

  const Stopwatch watch;
  Spool spool(spool_folder(arguments.report));
  Batch batch("optimize", job.setup.registry, spool, [&](const StoredReport& report, Outcome outcome) {
    tell_file(report, outcome);
    if (since) since->add(report, outcome);
  });
  std::vector<std::optional<Scene>> kept(wanted.gathered.empty() ? 0 : inputs.size());
  std::vector<std::string> rules(arguments.depfile.empty() ? 0 : inputs.size());
  const auto run_one = [&](const FileJob& each, std::size_t i) {
    FileRun run = optimize_file(each, inputs[i], outputs[i]);
    if (!kept.empty()) kept[i] = std::move(run.scene);
    if (!rules.empty() && !run.is_lost) rules[i] = rules_of(each, run, outputs[i]);
    return run;
  };
  FileJob keeping = job;
  keeping.keeps_scenes = !wanted.gathered.empty();
  Exit worst = run_batch(keeping, inputs, run_one, batch);
  if (worst == interrupted) return interrupted;
  tell(diagnostics);  // of what was passed by
  Diagnostics gathering;
  if (!wanted.gathered.empty() && !gather(kept, wanted.gathered, gathering)) worst = something_failed;
  tell(gathering);
  const double seconds = watch.seconds();
  fmt::print(stderr, "{}{}", batch.to_text(seconds), since ? '\n' + since->to_text() : "");
  const auto write = [&](const OutputFile::Put& put) {
    batch.write_json(seconds, arguments.shard, put, since ? since->to_json() : "");
  };
  std::vector<OutputFile> texts;
  if (!arguments.report.empty()) texts.push_back({arguments.report, {}, write});
  if (!arguments.depfile.empty()) {
    texts.push_back({arguments.depfile, {}, [&](const OutputFile::Put& put) {
                       for (const std::string& rule : rules) put(rule);
                     }});
  }
  Diagnostics writing;
  if (!texts.empty() && !write_files(texts, writing)) return refuse_file(writing);
  return arguments.json ? std::max(worst, print_pieces(write)) : worst;
}

Exit measure_folder(const FileJob& job, const MeasureArguments& arguments) {
  Diagnostics diagnostics;
  const fs::path from = arguments.inputs[0];
  const auto scenes = scenes_below(from, {}, scenes_for(job.pipeline, job.setup.registry), diagnostics);
  if (!scenes) return refuse(diagnostics);
  std::vector<std::string> inputs;
  for (const fs::path& scene : *scenes) inputs.push_back((from / scene).string());
  const Stopwatch watch;
  Spool spool;
  Batch batch("measure", job.setup.registry, spool, tell_file);
  const auto run_one = [&](const FileJob& each, std::size_t i) { return measure_file(each, inputs[i]); };
  const Exit worst = run_batch(job, inputs, run_one, batch);
  if (worst == interrupted) return interrupted;
  tell(diagnostics);  // of what was passed by
  const double seconds = watch.seconds();
  if (!arguments.json) return std::max(worst, print(batch.to_text(seconds)));
  return std::max(worst, print_pieces([&](const OutputFile::Put& put) { batch.write_json(seconds, {}, put); }));
}

}  // namespace foredraw::cli
