#include "file_runs.h"

#include <foredraw/report/page/page.h>

#include <foredraw/io/image/images.h>
#include <foredraw/io/side_files.h>
#include <foredraw/report/page/heat_maps.h>
#include <foredraw/report/remap.h>

#include <numeric>

namespace foredraw::cli {

namespace {

using Work = std::function<Result(const Plan&, Scene, const Surroundings&)>;

/// How the plan's first evaluator of overdraw looks, or as all do by default.
OverdrawOptions looks_of(const Plan& plan) {
  OptionTable<OverdrawOptions> table;
  add_view_rows(table);
  add_pose_rows(table);
  add_faces_row(table);
  add_subject_row(table, &OverdrawOptions::subject);
  for (const PlannedStage& measure : plan.measures) {
    if (measure.plugin->overdraw_service) return table.read(measure.settings);
  }
  return {};
}

/// Into the folder that was asked for, or, of several inputs, one of the input's own in it.
bool write_heat_maps(const FileJob& job, const std::string& input, const Plan& plan, const Scene& before,
                     const Scene* after, Analyses& analyses, Diagnostics& diagnostics) {
  std::filesystem::path folder = job.arguments.heat_maps;
  if (is_folder(job.arguments.inputs[0]))
    folder /= std::filesystem::path(input).lexically_relative(job.arguments.inputs[0]);
  const auto files =
      heat_maps(before, after, looks_of(plan), job.arguments.heat_map_view, folder, job.executor, analyses);
  return files.empty() || (make_folder(folder, diagnostics) && write_files(files, diagnostics));
}

/// Reads, plans and works; `written` puts the result somewhere, beside what the scene was where that is shown, and may
/// fail.
FileRun run_file(const FileJob& job, const std::string& command, const std::string& input, const Work& work,
                 const std::function<bool(const Scene&, Result&, Diagnostics&)>& written) {
  FileRun run;
  Diagnostics diagnostics;
  const auto lost = [&](Exit exit) {
    run.report.command = command;
    run.report.input.path = input;
    run.report.diagnostics = diagnostics.all();
    run.exit = exit;
    run.is_lost = true;
    return run;
  };
  auto file = with_memory(input, "read it",
                          [&] { return read_scene(input, diagnostics, input_of(job.arguments, job.registry)); });
  if (!file) return lost(exit_for_file(diagnostics));
  const auto plan = with_memory(input, "plan for it", [&] {
    return foredraw::plan(job.pipeline, job.registry, file->scene, diagnostics, &job.lender);
  });
  if (!plan) return lost(users_mistake);
  const bool draws = !job.arguments.heat_maps.empty();
  if (draws && !are_views(job.arguments.heat_map_view, looks_of(*plan), diagnostics)) return lost(users_mistake);

  const Scene before = draws || !job.arguments.html.empty() ? file->scene : Scene();
  Analyses analyses(image_decoder(input, job.arguments.root));
  Result result = with_memory(input, "work on it", [&] {
    return work(*plan, std::move(file->scene), {job.executor, analyses, nullptr, job.progress});
  });
  result.report.command = command;
  result.report.input = {input, file->bytes, to_text(file->stamp)};
  for (const Diagnostic& diagnostic : result.report.diagnostics) diagnostics.add(diagnostic);
  result.report.diagnostics = diagnostics.all();
  if (!draws) analyses.clear();  // nobody asks them any more
  if (!written(before, result, diagnostics)) return lost(something_failed);
  if (draws) {
    const Scene* after = result.report.optimized ? &result.scene : nullptr;
    if (!write_heat_maps(job, input, *plan, before, after, analyses, diagnostics)) result.failed = true;
  }
  run.report = std::move(result.report);
  leave_out_pictures(run.report);  // a folder's reports are kept to the end
  run.report.diagnostics = diagnostics.all();
  run.exit = result.failed ? something_failed : done;
  if (job.keeps_scenes) run.scene = std::move(result.scene);
  return run;
}

/// One pipeline beside the input.
std::string page_of(const Scene& before, const Result& result, const FileJob& job) {
  const std::string name = job.arguments.pipelines.empty() ? "@default" : job.arguments.pipelines.front();
  const Comparison comparison{result.report.input, {{name, result.report}}, {}};
  const std::optional<Scene> after = result.scene;
  const Display shown = display(before, {&after, 1}, 0, job.pipeline.subjects.subject);
  return page({&comparison, 1}, {&shown, 1}, program_name());
}

std::uint64_t bytes_of(std::span<const OutputFile> files) {
  return std::accumulate(files.begin(), files.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const OutputFile& file) { return sum + file.bytes.size(); });
}

Compression compression_of(const std::string& word) {
  if (word == "none") return Compression::none;
  if (word == "ext-meshopt") return Compression::ext;
  return word == "khr-meshopt" ? Compression::khr : Compression::keep;
}

Scene without_products(Scene scene, const ProductRows& rows) {
  for (const auto& row : rows) {
    if (scene.products.has(row->card().name)) row->leave_out(scene);
  }
  return scene;
}

}  // namespace

FileRun optimize_file(const FileJob& job, const std::string& input, const std::vector<Output>& outputs) {
  const Arguments& arguments = job.arguments;
  // The scene, the report and whatever else: all of it, or none and an explanation.
  const auto write = [&](const Scene& before, Result& result, Diagnostics& diagnostics) {
    Report& report = result.report;
    std::vector<std::vector<OutputFile>> scenes;
    std::vector<std::byte> standard;
    const ProductRows rows = job.registry.products();
    const GltfOutput as{compression_of(arguments.compression),
                        arguments.levels == "msft-lod" ? LevelsAs::lod_nodes : LevelsAs::extension, rows};
    const bool is_bare = arguments.products == "none" && !result.scene.products.empty();
    const std::optional<Scene> bare = is_bare ? std::optional(without_products(result.scene, rows)) : std::nullopt;
    const Scene& scene = bare ? *bare : result.scene;
    for (const Output& output : outputs) {
      auto files = output.row           ? encode_side_file(result.scene, *output.row, output.path, diagnostics)
                   : output.level       ? encode_level(scene, *output.level, output.path, diagnostics, as)
                   : !output.is_scene() ? std::vector{text_file(output.path, remap_json(result.scene))}
                                        : encode_scene(scene, output.path, diagnostics, as);
      if (!files) return false;
      if (report.output.path.empty() && output.is_scene()) report.output = {output.path, bytes_of(*files)};
      if (output.path == "-") {
        standard = std::move(files->front().bytes);
      } else {
        scenes.push_back(std::move(*files));
      }
    }
    report.diagnostics = diagnostics.all();
    if (!is_folder(arguments.inputs[0])) {
      std::vector<OutputFile> texts;
      if (!arguments.report.empty()) {
        texts.push_back({arguments.report, {}, [&](const OutputFile::Put& put) { write_json(report, put); }});
      }
      if (!arguments.html.empty()) texts.push_back(text_file(arguments.html, page_of(before, result, job)));
      if (!texts.empty()) scenes.push_back(std::move(texts));
    }
    return write_scenes(std::move(scenes), diagnostics) &&
           (standard.empty() || write_standard_output(standard, diagnostics));
  };
  return run_file(job, "optimize", input, foredraw::optimize,
                  [&](const Scene& before, Result& result, Diagnostics& diagnostics) {
                    return with_memory(outputs.empty() ? input : outputs.front().path, "write it",
                                       [&] { return write(before, result, diagnostics); });
                  });
}

FileRun measure_file(const FileJob& job, const std::string& input) {
  return run_file(job, "measure", input, foredraw::measure, [](const Scene&, Result&, Diagnostics&) { return true; });
}

}  // namespace foredraw::cli
