#include "file_runs.h"

#include <foredraw/io/sprite/sprite_files.h>
#include "scene_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>

namespace foredraw::cli {

namespace {

namespace fs = std::filesystem;

/// Where the scene goes: to the same place in the output folder, as its own kind where that is glTF, sprites as a frame
/// list, else as a GLB.
fs::path output_of(const fs::path& scene, const fs::path& folder) {
  fs::path output = folder / scene;
  if (is_sprite_input(scene)) return output.replace_extension(".json");
  return is_gltf_file(output) ? output : output.replace_extension(".glb");
}

/// Where things go, of several inputs.
struct FolderOutputs {
  std::string folder;                 ///< each scene by itself; empty: nowhere
  std::vector<std::string> gathered;  ///< files of sprites that hold those of all scenes
};

FolderOutputs outputs_in(const std::vector<std::string>& words, const ProductRows& rows, Diagnostics& diagnostics) {
  FolderOutputs result;
  for (const std::string& word : words) {
    const Output output = typed_output(word, rows);
    if (!output.is_scene()) {
      diagnostics.error({.file = output.path}, "bad-arguments",
                        "holds the " + output.kind + " of one scene, but the input is a folder",
                        "run foredraw on a single file for this output");
    } else if (is_sprite_output(output.path) && !is_folder(output.path)) {
      result.gathered.push_back(output.path);
    } else if (result.folder.empty()) {
      result.folder = output.path;
    } else {
      diagnostics.error(
          {.file = output.path}, "bad-arguments", "is a second folder for the same scenes",
          "give -o one folder, and as further outputs only files of sprites: " + sprite_output_extensions());
    }
  }
  return result;
}

/// All sprites in one file each; scenes that were lost are missing.
bool gather(const std::vector<FileRun>& runs, const std::vector<std::string>& gathered, Diagnostics& diagnostics) {
  std::vector<Scene> scenes;
  for (const FileRun& run : runs) {
    if (run.scene && is_sprite_input(run.scene->name)) scenes.push_back(*run.scene);
  }
  std::vector<OutputFile> files;
  for (const std::string& target : gathered) {
    auto file = encode_sprites(scenes, target, diagnostics);
    if (!file) return false;
    files.push_back(std::move(*file));
  }
  return write_files(files, diagnostics);
}

/// Every file of the input folder: a scene, or what one is read from. What is below the output folder is neither.
std::vector<fs::path> files_read_from(const fs::path& from, const fs::path& to) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::recursive_directory_iterator at(from, error), end; at != end; at.increment(error)) {
    if (fs::equivalent(at->path(), to, error)) {
      at.disable_recursion_pending();
    } else if (at->is_regular_file(error)) {
      files.push_back(at->path());
    }
  }
  return files;
}

/// "prop.glb" and "prop.obj" would both become "prop.glb"; and no file may become what another has yet to be read from.
bool outputs_meet(std::vector<fs::path> scenes, const std::vector<fs::path>& inputs, std::vector<fs::path> outputs,
                  const std::vector<std::string>& gathered, Diagnostics& diagnostics) {
  for (const std::string& file : gathered) {
    scenes.emplace_back("all sprites");
    outputs.emplace_back(file);
  }
  std::map<fs::path, fs::path> taken;
  std::error_code error;
  for (const fs::path& input : inputs) taken.emplace(fs::weakly_canonical(input, error), "an input");
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (const fs::path& file : foredraw::paths_written_for(outputs[i])) {
      const auto [at, is_new] = taken.emplace(fs::weakly_canonical(file, error), scenes[i]);
      if (is_new) continue;
      diagnostics.error({.file = file.string()}, "outputs-meet",
                        at->second.string() + " and the output of " + scenes[i].string() + " would both have this name",
                        "give one of them another name, or -o another folder");
    }
  }
  return diagnostics.has_errors();
}

FileRun lost(const fs::path& input, const std::string& why, const std::string& hint) {
  FileRun run;
  run.report.input.path = input.string();
  run.report.diagnostics = {{Severity::error, {.file = input.string()}, "lost", why, hint}};
  run.exit = something_failed;
  run.is_lost = true;
  return run;
}

/// One file; whatever it throws is its own affair.
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

/// Works on all files at once, tells of them in their sequence, and sums up.
Exit run_batch(const FileJob& job, const std::string& command, const std::vector<fs::path>& inputs,
               const std::function<FileRun(const FileJob&, std::size_t)>& run_one, Batch& batch,
               const std::function<bool(const std::vector<FileRun>&)>& finish = {}) {
  const auto begin = std::chrono::steady_clock::now();
  const auto progress = progress_line();
  std::vector<FileRun> runs(inputs.size());
  std::mutex at_the_line;
  std::size_t finished = 0;
  job.executor.for_each(inputs.size(), [&](std::size_t i) {
    runs[i] = guarded(inputs[i], [&] { return run_one(job, i); });
    const std::scoped_lock lock(at_the_line);
    ++finished;
    if (progress) progress(inputs[i].string(), static_cast<double>(finished) / static_cast<double>(inputs.size()));
  });
  end_progress();

  Exit worst = done;
  batch.command = command;
  for (FileRun& run : runs) {
    tell(run.report.diagnostics);
    if (run.exit != done) worst = something_failed;
    const Outcome outcome = run.is_lost ? Outcome::lost : run.exit != done ? Outcome::in_part : Outcome::done;
    batch.files.push_back({std::move(run.report), outcome});
  }
  if (finish && !finish(runs)) worst = something_failed;
  batch.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return worst;
}

}  // namespace

bool is_folder(const std::string& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

Exit optimize_folder(const FileJob& job) {
  const Arguments& arguments = job.arguments;
  Diagnostics diagnostics;
  const fs::path from = arguments.inputs[0];
  const FolderOutputs wanted = outputs_in(arguments.outputs, job.registry.products(), diagnostics);
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
  const FolderScenes which = scenes_for(job.pipeline, job.registry);
  const auto scenes = diagnostics.has_errors() ? std::nullopt : scenes_below(from, to, which, diagnostics);
  if (!scenes) return refuse(diagnostics);
  if (!wanted.gathered.empty() && std::ranges::none_of(*scenes, is_sprite_input)) {
    diagnostics.error(
        {.file = wanted.gathered[0]}, "bad-arguments",
        "is a file of sprites, but there are none: the folder has no sprites, or the pipeline has no stage for them",
        "for a folder of meshes, give -o a folder");
    return refuse(diagnostics);
  }
  std::vector<fs::path> inputs;
  std::vector<fs::path> outputs;
  for (const fs::path& scene : *scenes) {
    inputs.push_back(from / scene);
    if (!wanted.folder.empty()) outputs.push_back(output_of(scene, to));
  }
  const auto written_of = wanted.folder.empty() ? std::vector<fs::path>() : *scenes;
  if (outputs_meet(written_of, files_read_from(from, to), outputs, wanted.gathered, diagnostics)) {
    return refuse(diagnostics);
  }
  for (const fs::path& output : outputs) {
    if (!make_folder(output.parent_path(), diagnostics)) return refuse_file(diagnostics);
  }
  std::vector<std::string> written = wanted.gathered;
  written.push_back(arguments.report);
  if (!have_folders(written, diagnostics)) return refuse_file(diagnostics);

  Batch batch;
  const auto run_one = [&](const FileJob& each, std::size_t i) {
    std::vector<Output> own;
    if (!outputs.empty()) own.push_back({{}, outputs[i].string()});
    return optimize_file(each, inputs[i].string(), own);
  };
  const auto finish = [&](const std::vector<FileRun>& runs) {
    Diagnostics gathering;
    const bool good = wanted.gathered.empty() || gather(runs, wanted.gathered, gathering);
    tell(gathering);
    return good;
  };
  FileJob keeping = job;
  keeping.keeps_scenes = !wanted.gathered.empty();
  const Exit worst = run_batch(keeping, "optimize", inputs, run_one, batch, finish);
  fmt::print(stderr, "{}", to_text(batch));
  if (!arguments.report.empty()) {
    const OutputFile report = text_file(arguments.report, to_json(batch));
    if (!write_files(std::span(&report, 1), diagnostics)) return refuse_file(diagnostics);
  }
  return arguments.json ? std::max(worst, print(to_json(batch))) : worst;
}

Exit measure_folder(const FileJob& job) {
  Diagnostics diagnostics;
  const fs::path from = job.arguments.inputs[0];
  const auto scenes = scenes_below(from, {}, scenes_for(job.pipeline, job.registry), diagnostics);
  if (!scenes) return refuse(diagnostics);
  std::vector<fs::path> inputs;
  for (const fs::path& scene : *scenes) inputs.push_back(from / scene);
  Batch batch;
  const auto run_one = [&](const FileJob& each, std::size_t i) { return measure_file(each, inputs[i].string()); };
  const Exit worst = run_batch(job, "measure", inputs, run_one, batch);
  return std::max(worst, print(job.arguments.json ? to_json(batch) : to_text(batch)));
}

}  // namespace foredraw::cli
