// CLI11 is slow to compile, so it is included here alone.
#include "arguments.h"
#include "session.h"

#include <foredraw/io/imported_file.h>
#include <foredraw/io/scene_kinds.h>
#include <foredraw/io/scene_writers.h>
#include <foredraw/job/outputs.h>
#include <foredraw/pipeline/output_words.h>
#include <foredraw/pipeline/presets.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>

namespace foredraw::cli {

namespace {

std::string presets_text() {
  std::string text = "Presets:";
  for (const Preset& preset : presets()) text += fmt::format(" @{}", preset.name);
  return text;
}

class CommandLine {
 public:
  explicit CommandLine(const Registry& registry) {
    app_.require_subcommand(1);
    app_.set_version_flag("--version", program_name());
    app_.footer(
        "Exit codes: 0 done, 1 a mistake in the arguments or the pipeline, 2 a file or a stage failed, 3 a figure was "
        "out of the bounds of --fail-if.\n"
        "A first try: foredraw optimize in.glb -o out.glb");

    auto& optimize_app = add("optimize", "Make a scene cheaper to draw", optimize);
    input(optimize_app);
    optimize_app
        .add_option(
            "-o,--output", arguments_.outputs,
            fmt::format("Output file: {}, or - for standard output; sprites as {}. "
                        "KIND:FILE writes extra data; the kinds are {}. May be given several times; all outputs are "
                        "written, or none. For a folder of inputs, give a folder; a file of sprites then holds those "
                        "of all inputs",
                        extensions_written(SceneType::meshes), extensions_written(SceneType::sprites),
                        kinds_text(registry.products())))
        ->required()
        ->expected(1)
        ->take_all();
    pipeline(optimize_app);
    with(optimize_app);
    optimize_app.add_option("--report", arguments_.report, "Write the record of the run, as JSON, to this file");
    html(optimize_app);
    how_written(optimize_app);
    heat_maps(optimize_app, ", before and after,");
    json(optimize_app,
         "Print the record of the run, as JSON, to standard output; the tables go to standard error, with or without "
         "it");
    batches(optimize_app);
    threads(optimize_app);
    modules(optimize_app);

    auto& plan_app = add("plan", "Show what would run, what would be skipped and why", plan);
    input(plan_app, false);
    pipeline(plan_app);
    json(plan_app);
    modules(plan_app);

    auto& measure_app = add("measure", "Measure a scene as it is", measure);
    input(measure_app);
    with(measure_app, "those of @default");
    heat_maps(measure_app, "");
    json(measure_app);
    threads(measure_app);
    modules(measure_app);

    auto& compare_app = add("compare", "Run several pipelines on the same scenes and compare them", compare);
    compare_app.add_option("inputs", arguments_.inputs, "Scenes, images or frame lists, or folders of them")
        ->required();
    pipeline(compare_app, "; may be given several times");
    with(compare_app);
    compare_app
        .add_option("--sweep", arguments_.sweeps,
                    "Run the pipelines at every value of an option: stage.option=FIRST:LAST:STEP or =A,B,C; if given "
                    "several times, at every combination")
        ->allow_extra_args(false);
    compare_app
        .add_option("--repeat", arguments_.repeat,
                    "Run the stages this many times, the pipelines in turn; times are medians (default: 1)")
        ->check(CLI::Range(1, 1000));
    compare_app
        .add_option("--fail-if", arguments_.fail_if,
                    "End with exit code 3 if a figure is out of bounds, such as 'overdraw-raster.ratio > baseline * "
                    "1.01'. The limit may also name input, or be a number. May be given several times")
        ->allow_extra_args(false);
    compare_app.add_option("--baseline", arguments_.baseline,
                           "Tell what changed since an earlier run, the worst first: its report or comparison. "
                           "--fail-if takes it as baseline (default: the first pipeline)");
    compare_app
        .add_option("--front", arguments_.fronts,
                    "Show which pipelines no other pipeline beats in both of two figures, such as "
                    "time,overdraw-raster.ratio; may be given several times")
        ->allow_extra_args(false);
    compare_app.add_option("--report", arguments_.report, "Write the comparison, as JSON, to this file");
    compare_app.add_option("--csv", arguments_.csv, "Write every figure on its own line, as CSV, to this file");
    html(compare_app);
    json(compare_app);
    threads(compare_app);
    memory_limit(compare_app);
    modules(compare_app);

    auto& inspect_app = add("inspect", "Show what a scene holds", inspect);
    input(inspect_app, false);
    json(inspect_app);

    auto& list_app = add("list", "List the plugins", list);
    list_app.add_option("--kind", arguments_.kind, "Only orderer, clusterer, processor or evaluator");
    json(list_app);
    modules(list_app);

    auto& show_app = add("show", "Show a plugin's options, or a preset's text", show);
    show_app.add_option("name", arguments_.name, "A plugin's name, or @preset")->required();
    json(show_app);
    modules(show_app);

    auto& schema_app = add("schema", "Print a JSON Schema of the pipeline format, for editors", schema);
    schema_app.add_option("product", arguments_.name,
                          "Print the schemas of this product's glTF extension instead, by file name");
    modules(schema_app);

    auto& check_app = add("check-module", "Ask of a module's techniques what is asked of those built in", check_module);
    check_app.add_option("module", arguments_.modules, "The module, a .so or .py file, or a folder of them")
        ->required()
        ->expected(1);
    threads(check_app);
    how_modules_run(check_app);

    auto& calibrate_app =
        add("calibrate", "Measure what drawing costs on this machine, so that levels can be chosen within a budget",
            calibrate);
    calibrate_app.add_option("-o,--output", arguments_.costs,
                             "Write the costs to this file, for options called costs (default: print them)");
    calibrate_app
        .add_option("--rounds", arguments_.rounds, "Draw each frame this many times; medians count (default: 7)")
        ->check(CLI::Range(1, 1000));

    auto& watch_app =
        add("watch", "Keep the outputs of a folder up to date while its files change, until Ctrl-C", watch);
    watch_app.add_option("folder", arguments_.inputs, "The folder of scenes that you work in")->required()->expected(1);
    how_read(watch_app);
    watch_app
        .add_option("-o,--output", arguments_.outputs,
                    "Folder of the outputs; it is created if it does not exist. Nothing is ever removed from it")
        ->required()
        ->expected(1);
    pipeline(watch_app);
    with(watch_app);
    how_written(watch_app);
    watch_app
        .add_option("--settle", arguments_.settle,
                    "Take files once nothing has changed for so many seconds (default: 0.3)")
        ->check(CLI::Range(.01, 60.));
    cache(watch_app);
    threads(watch_app);
    modules(watch_app);

    auto& join_app = add("join-reports", "Make the report of a folder from those of its parts", join_reports);
    join_app.add_option("parts", arguments_.inputs, "Reports of foredraw optimize FOLDER --shard")->required();
    join_app.add_option("-o,--output", arguments_.outputs, "Write the report of the whole folder to this file")
        ->expected(1);
    baseline(join_app);
    json(join_app);

    auto& cache_app =
        add("cache", "Look after a cache: how much it holds, and what to throw away", foredraw::cli::cache);
    cache_app.add_option("folder", arguments_.inputs, "The folder that --cache was given")->required()->expected(1);
    size(
        cache_app, "--trim", [this](std::uint64_t bytes) { arguments_.trim = bytes; },
        "Remove what was not used for longest, until the cache has no more than this, such as 20G");
    cache_app.add_flag("--verify", arguments_.verify, "Read every entry whole, and remove those that are damaged");
    cache_app.add_flag("--stats", shows_stats_, "Show how much the cache holds; this is also done without the option");
    json(cache_app);
  }

  std::variant<Asked, Misunderstood> run(int argc, char** argv) {
    Misunderstood no{.words = {argv + 1, argv + argc}, .commands = commands()};
    const bool begins_with_command = argc > 1 && argv[1][0] != '-';
    if (begins_with_command && std::ranges::find(no.commands, argv[1]) == no.commands.end()) {
      no.unknown_command = argv[1];
      return no;
    }
    try {
      app_.parse(argc, argv);
    } catch (const CLI::Success& printed) {  // --help, --version
      app_.exit(printed);
      return Asked{};
    } catch (const CLI::ParseError& mistake) {
      no.why = mistake.what();
      const std::vector<CLI::App*> named = app_.get_subcommands();
      const CLI::App& of = named.empty() ? app_ : *named.front();
      if (!named.empty()) no.command = of.get_name();
      no.options = options_of(of);
      const CLI::Option* input = of.get_option_no_throw("input");
      const bool takes_one = input != nullptr && input->get_items_expected_max() == 1;
      if (takes_one && input->count() > 1) no.input_too_many = input->results()[1];
      return no;
    }
    return std::move(asked_);
  }

 private:
  std::vector<std::string> commands() const {
    std::vector<std::string> names;
    for (const CLI::App* command : app_.get_subcommands({})) names.push_back(command->get_name());
    return names;
  }

  static std::vector<std::string> options_of(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
      for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    }
    return names;
  }

  CLI::App& add(const std::string& name, const std::string& what, Command command) {
    CLI::App* app = app_.add_subcommand(name, what);
    app->callback([this, command] { asked_.command = command; });
    return *app;
  }

  void input(CLI::App& app, bool takes_folder = true) {
    app.add_option(
           "input", arguments_.inputs,
           fmt::format("A scene: {}, or - for standard input; what foredraw-import reads: {}; an image ({}) or a "
                       "frame list ({}) as sprites{}",
                       extensions_that_hold(Holds::meshes), imported_extensions(), extensions_that_hold(Holds::image),
                       extensions_that_hold(Holds::frame_list), takes_folder ? "; or a folder of these" : ""))
        ->required()
        ->expected(1);
    how_read(app);
  }
  void how_read(CLI::App& app) {
    app.add_flag(
        "--strict", arguments_.strict,
        "Refuse a file with any fault, instead of mending faults that can have only one meaning, with a warning");
    app.add_option(
           "--root", arguments_.root,
           "Let a scene name files outside of its own folder, such as \"../meshes.bin\", if they are in this folder")
        ->type_name("FOLDER");
    memory_limit(app);
  }
  void pipeline(CLI::App& app, const std::string& more = "") {
    app.add_option("-p,--pipeline", arguments_.pipelines,
                   "A .toml file, a @preset, or stages on one line such as \"weld, tipsify(cache-size=24)\"" + more +
                       " (default: @default). " + presets_text())
        ->expected(1)
        ->take_all();
    app.add_option("--set", arguments_.set,
                   "Set an option of the pipeline: stage.option=value; may be given several times")
        ->expected(1)
        ->take_all();
  }
  void with(CLI::App& app, const std::string& usual = "the pipeline's, else those that show what its stages gain") {
    app.add_option(
        "--with", arguments_.with,
        "Evaluators to measure with, such as \"vertex-cache, overdraw-raster(views=162)\" (default: " + usual + ")");
  }
  void how_written(CLI::App& app) {
    for (const OptionSpec& spec : output_words().specs()) {
      const auto take = [this, name = spec.name](const std::string& word) { arguments_.written_as[name] = word; };
      app.add_option_function<std::string>(
             "--" + spec.name, take,
             fmt::format("{} (default: the pipeline's, else {})", spec.doc, to_text(spec.default_value)))
          ->type_name(fmt::format("TEXT:{{{}}}", fmt::join(spec.choices, ",")));
    }
  }
  void heat_maps(CLI::App& app, const std::string& when) {
    app.add_option("--heatmap", arguments_.heat_maps,
                   "Write PNG pictures of how often each pixel is shaded" + when + " into this folder");
    app.add_option(
        "--heatmap-view", arguments_.heat_map_view,
        "View to draw: worst, all, or the number of a view of the first overdraw evaluator (default: worst)");
  }
  void html(CLI::App& app) {
    app.add_option("--html", arguments_.html,
                   "Write a page with tables, a plot and a 3D view of the scene, for any browser, to this file");
  }
  void json(CLI::App& app, const std::string& what = "Print JSON to standard output") {
    app.add_flag("--json", arguments_.json, what);
  }
  void threads(CLI::App& app) {
    app.add_option("--threads", arguments_.threads, "Number of threads (default: one for each processor)")
        ->check(CLI::Range(1, 1024));
  }
  void cache(CLI::App& app) {
    app.add_option("--cache", arguments_.cache,
                   "Keep results in this folder, and take them from there if nothing that they depend on has changed")
        ->type_name("FOLDER");
  }
  void batches(CLI::App& app) {
    cache(app);
    const auto take_shard = [this](const std::string& text) {
      arguments_.shard = shard_in(text);
      if (!arguments_.shard) {
        throw CLI::ValidationError("--shard", "'" + text + "' is no part of a folder; give one such as 3/16");
      }
    };
    app.add_option_function<std::string>(
           "--shard", take_shard,
           "Work on one of several parts of a folder, such as 3/16; foredraw join-reports "
           "puts their reports together")
        ->type_name("I/N");
    baseline(app);
    app.add_option("--depfile", arguments_.depfile,
                   "Write which files each output was made from, as rules of Make, to this file");
  }
  void baseline(CLI::App& app) {
    app.add_option("--baseline", arguments_.baseline,
                   "Tell what changed since an earlier run over the folder, the worst first: its report");
  }
  void memory_limit(CLI::App& app) {
    size(
        app, "--memory-limit", [this](std::uint64_t bytes) { arguments_.memory_limit = bytes; },
        "Stop with an error, and change no file, if more memory than this is needed, such as 500M or 2G (default: no "
        "limit)");
  }
  void modules(CLI::App& app) {
    app.add_option("--module", arguments_.modules,
                   "Also know the techniques of this module, a .so or .py file, or of all in this folder; may be given "
                   "several times. Those that the environment variable FOREDRAW_MODULES names are known as well")
        ->type_name("FILE|FOLDER")
        ->expected(1)
        ->take_all();
    how_modules_run(app);
  }
  void how_modules_run(CLI::App& app) {
    const auto take = [this](const std::string& word) { arguments_.modules_inside = word == "inside"; };
    app.add_option_function<std::string>("--modules", take,
                                         "apart: modules run in processes of their own; inside: in this one, which "
                                         "saves a little time and trusts them (default: apart)")
        ->check(CLI::IsMember({"apart", "inside"}));
    app.add_option("--module-seconds", arguments_.module_seconds,
                   "End a module's process that takes longer than this for a call (default: 600)")
        ->check(CLI::Range(.001, 1e6));
    size(
        app, "--module-memory", [this](std::uint64_t bytes) { arguments_.module_memory = bytes; },
        "The most memory that a module's process may hold, such as 500M (default: 2G)");
  }
  /// Bytes, or K, M, G, T of 1024.
  static void size(CLI::App& app, const std::string& name, const std::function<void(const std::uint64_t&)>& take,
                   const std::string& what) {
    app.add_option_function<std::uint64_t>(name, take, what)
        ->transform(CLI::AsSizeValue(false).description(""))
        ->type_name("SIZE");
  }

  Asked asked_;
  Arguments& arguments_ = asked_.arguments;
  bool shows_stats_ = true;  ///< for who says what is done anyway
  CLI::App app_{"Foredraw makes real-time scenes cheaper to draw before they are drawn.", "foredraw"};
};

}  // namespace

std::variant<Asked, Misunderstood> asked(int argc, char** argv, const Registry& registry) {
  return CommandLine(registry).run(argc, argv);
}

}  // namespace foredraw::cli
