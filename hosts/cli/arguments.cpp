// CLI11 is slow to compile, so it is included here alone.
#include "arguments.h"
#include "byte_size.h"
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

    {
      auto [app, arguments] = add("optimize", "Make a scene cheaper to draw", optimize, Modules::all, is_interruptible);
      input(app, arguments);
      how_read(app, arguments);
      app.add_option("-o,--output", arguments.outputs,
                     fmt::format("Output file: {}, or - for standard output; sprites as {}. "
                                 "KIND:FILE writes extra data; the kinds are {}. May be given several times; all "
                                 "outputs are written, or none. For a folder of inputs, give a folder; a file of "
                                 "sprites then holds those of all inputs",
                                 extensions_written(SceneType::meshes), extensions_written(SceneType::sprites),
                                 kinds_text(registry.products())))
          ->required()
          ->expected(1)
          ->take_all();
      pipeline(app, arguments);
      with(app, arguments);
      app.add_option("--report", arguments.report, "Write the record of the run, as JSON, to this file");
      html(app, arguments);
      how_written(app, arguments);
      heat_maps(app, arguments, ", before and after,");
      json(app, arguments.json,
           "Print the record of the run, as JSON, to standard output; the tables go to standard error, with or without "
           "it");
      cache(app, arguments.cache);
      shard(app, arguments);
      baseline(app, arguments);
      app.add_option("--depfile", arguments.depfile,
                     "Write which files each output was made from, as rules of Make, to this file");
      threads(app, arguments);
      modules(app, arguments);
    }
    {
      auto [app, arguments] = add("plan", "Show what would run, what would be skipped and why", plan);
      input(app, arguments, false);
      how_read(app, arguments);
      pipeline(app, arguments);
      json(app, arguments.json);
      modules(app, arguments);
    }
    {
      auto [app, arguments] = add("measure", "Measure a scene as it is", measure, Modules::all, is_interruptible);
      input(app, arguments);
      how_read(app, arguments);
      with(app, arguments, "those of @default");
      heat_maps(app, arguments, "");
      json(app, arguments.json);
      threads(app, arguments);
      modules(app, arguments);
    }
    compare_app();
    {
      auto [app, arguments] = add("inspect", "Show what a scene holds", inspect, Modules::none);
      input(app, arguments, false);
      how_read(app, arguments);
      json(app, arguments.json);
    }
    {
      auto [app, arguments] = add("list", "List the plugins", list);
      app.add_option("--kind", arguments.kind, "Only orderer, clusterer, processor or evaluator");
      json(app, arguments.json);
      modules(app, arguments);
    }
    {
      auto [app, arguments] = add("show", "Show a plugin's options, or a preset's text", show);
      app.add_option("name", arguments.name, "A plugin's name, or @preset")->required();
      json(app, arguments.json);
      modules(app, arguments);
    }
    {
      auto [app, arguments] = add("schema", "Print a JSON Schema of the pipeline format, for editors", schema);
      app.add_option("product", arguments.product,
                     "Print the schemas of this product's glTF extension instead, by file name");
      modules(app, arguments);
    }
    {
      auto [app, arguments] = add("check-module", "Ask of a module's techniques what is asked of those built in",
                                  check_module, Modules::named);
      app.add_option("module", arguments.modules, "The module, a .so or .py file, or a folder of them")
          ->required()
          ->expected(1);
      threads(app, arguments);
      how_modules_run(app, arguments);
    }
    {
      auto [app, arguments] =
          add("calibrate", "Measure what drawing costs on this machine, so that levels can be chosen within a budget",
              calibrate, Modules::none);
      app.add_option("-o,--output", arguments.costs,
                     "Write the costs to this file, for options called costs (default: print them)");
      app.add_option("--rounds", arguments.rounds, "Draw each frame this many times; medians count (default: 7)")
          ->check(CLI::Range(1, 1000));
    }
    {
      auto [app, arguments] =
          add("watch", "Keep the outputs of a folder up to date while its files change, until Ctrl-C", watch,
              Modules::all, is_interruptible);
      app.add_option("folder", arguments.inputs, "The folder of scenes that you work in")->required()->expected(1);
      how_read(app, arguments);
      app.add_option("-o,--output", arguments.output,
                     "Folder of the outputs; it is created if it does not exist. Nothing is ever removed from it")
          ->required();
      pipeline(app, arguments);
      with(app, arguments);
      how_written(app, arguments);
      app.add_option("--settle", arguments.settle,
                     "Take files once nothing has changed for so many seconds (default: 0.3)")
          ->check(CLI::Range(.01, 60.));
      cache(app, arguments.cache);
      threads(app, arguments);
      modules(app, arguments);
    }
    {
      auto [app, arguments] = add("join-reports", "Make the report of a folder from those of its parts", join_reports);
      app.add_option("parts", arguments.inputs, "Reports of foredraw optimize FOLDER --shard")->required();
      app.add_option("-o,--output", arguments.report, "Write the report of the whole folder to this file");
      baseline(app, arguments);
      json(app, arguments.json);
    }
    {
      auto [app, arguments] =
          add("cache", "Look after a cache: how much it holds, and what to throw away", foredraw::cli::cache);
      app.add_option("folder", arguments.inputs, "The folder that --cache was given")->required()->expected(1);
      size(
          app, "--trim", [&trim = arguments.trim](std::uint64_t bytes) { trim = bytes; },
          "Remove what was not used for longest, until the cache has no more than this, such as 20G");
      app.add_flag("--verify", arguments.verify, "Read every entry whole, and remove those that are damaged");
      app.add_flag("--stats", shows_stats_, "Show how much the cache holds; this is also done without the option");
      json(app, arguments.json);
    }
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

  static constexpr bool is_interruptible = true;

  /// A command, and where its arguments go.
  template <class Arguments>
  std::pair<CLI::App&, Arguments&> add(const std::string& name, const std::string& what,
                                       Exit (*command)(const Arguments&, const Registry&),
                                       Modules loaded = Modules::all, bool may_be_interrupted = false) {
    CLI::App& app = *app_.add_subcommand(name, what);
    const auto arguments = std::make_shared<Arguments>();
    app.callback([=, this] {
      asked_ = {arguments, [=](const Registry& registry) { return command(*arguments, registry); }, loaded,
                may_be_interrupted};
    });
    return {app, *arguments};
  }

  void compare_app() {
    auto [app, arguments] = add("compare", "Run several pipelines on the same scenes and compare them", compare,
                                Modules::all, is_interruptible);
    app.add_option("inputs", arguments.inputs, "Scenes, images or frame lists, or folders of them")->required();
    pipeline(app, arguments, "; may be given several times");
    with(app, arguments);
    app.add_option("--sweep", arguments.sweeps,
                   "Run the pipelines at every value of an option: stage.option=FIRST:LAST:STEP or =A,B,C; if given "
                   "several times, at every combination")
        ->allow_extra_args(false);
    app.add_option("--repeat", arguments.repeat,
                   "Run the stages this many times, the pipelines in turn; times are medians (default: 1)")
        ->check(CLI::Range(1, 1000));
    app.add_option("--fail-if", arguments.fail_if,
                   "End with exit code 3 if a figure is out of bounds, such as 'overdraw-raster.ratio > baseline * "
                   "1.01'. The limit may also name input, or be a number. May be given several times")
        ->allow_extra_args(false);
    app.add_option("--baseline", arguments.baseline,
                   "Tell what changed since an earlier run, the worst first: its report or comparison. "
                   "--fail-if takes it as baseline (default: the first pipeline)");
    app.add_option("--front", arguments.fronts,
                   "Show which pipelines no other pipeline beats in both of two figures, such as "
                   "time,overdraw-raster.ratio; may be given several times")
        ->allow_extra_args(false);
    app.add_option("--report", arguments.report, "Write the comparison, as JSON, to this file");
    app.add_option("--csv", arguments.csv, "Write every figure on its own line, as CSV, to this file");
    html(app, arguments);
    json(app, arguments.json);
    threads(app, arguments);
    memory_limit(app, arguments);
    modules(app, arguments);
  }

  void input(CLI::App& app, CommonArguments& arguments, bool takes_folder = true) {
    app.add_option(
           "input", arguments.inputs,
           fmt::format("A scene: {}, or - for standard input; what foredraw-import reads: {}; an image ({}) or a "
                       "frame list ({}) as sprites{}",
                       extensions_that_hold(Holds::meshes), imported_extensions(), extensions_that_hold(Holds::image),
                       extensions_that_hold(Holds::frame_list), takes_folder ? "; or a folder of these" : ""))
        ->required()
        ->expected(1);
  }
  template <class Arguments>
  void how_read(CLI::App& app, Arguments& arguments) {
    ReadingArguments& reading = arguments;
    app.add_flag(
        "--strict", reading.strict,
        "Refuse a file with any fault, instead of mending faults that can have only one meaning, with a warning");
    app.add_option(
           "--root", reading.root,
           "Let a scene name files outside of its own folder, such as \"../meshes.bin\", if they are in this folder")
        ->type_name("FOLDER");
    memory_limit(app, arguments);
  }
  void pipeline(CLI::App& app, PipelineArguments& arguments, const std::string& more = "") {
    app.add_option("-p,--pipeline", arguments.pipelines,
                   "A .toml file, a @preset, or stages on one line such as \"weld, tipsify(cache-size=24)\"" + more +
                       " (default: @default). " + presets_text())
        ->expected(1)
        ->take_all();
    app.add_option("--set", arguments.set,
                   "Set an option of the pipeline: stage.option=value; may be given several times")
        ->expected(1)
        ->take_all();
  }
  void with(CLI::App& app, PipelineArguments& arguments,
            const std::string& usual = "the pipeline's, else those that show what its stages gain") {
    app.add_option(
        "--with", arguments.with,
        "Evaluators to measure with, such as \"vertex-cache, overdraw-raster(views=162)\" (default: " + usual + ")");
  }
  void how_written(CLI::App& app, PipelineArguments& arguments) {
    const OptionTable<OutputSettings> words = output_words();
    for (const OptionSpec& spec : words.specs()) {
      const auto take = [&words = arguments.written_as, name = spec.name](const std::string& word) {
        words[name] = word;
      };
      app.add_option_function<std::string>(
             "--" + spec.name, take,
             fmt::format("{} (default: the pipeline's, else {})", spec.doc, to_text(spec.default_value)))
          ->type_name(fmt::format("TEXT:{{{}}}", fmt::join(spec.choices, ",")));
    }
  }
  void heat_maps(CLI::App& app, PictureArguments& arguments, const std::string& when) {
    app.add_option("--heatmap", arguments.heat_maps,
                   "Write PNG pictures of how often each pixel is shaded" + when + " into this folder");
    app.add_option(
        "--heatmap-view", arguments.heat_map_view,
        "View to draw: worst, all, or the number of a view of the first overdraw evaluator (default: worst)");
  }
  void html(CLI::App& app, TextArguments& arguments) {
    app.add_option("--html", arguments.html,
                   "Write a page with tables, a plot and a 3D view of the scene, for any browser, to this file");
  }
  void json(CLI::App& app, bool& json, const std::string& what = "Print JSON to standard output") {
    app.add_flag("--json", json, what);
  }
  void threads(CLI::App& app, CommonArguments& arguments) {
    app.add_option("--threads", arguments.threads, "Number of threads (default: one for each processor)")
        ->check(CLI::Range(1, 1024));
  }
  void cache(CLI::App& app, std::string& folder) {
    app.add_option("--cache", folder,
                   "Keep results in this folder, and take them from there if nothing that they depend on has changed")
        ->type_name("FOLDER");
  }
  void shard(CLI::App& app, OptimizeArguments& arguments) {
    const auto take = [&shard = arguments.shard](const std::string& text) {
      shard = shard_in(text);
      if (!shard) {
        throw CLI::ValidationError("--shard", "'" + text + "' is no part of a folder; give one such as 3/16");
      }
    };
    app.add_option_function<std::string>(
           "--shard", take,
           "Work on one of several parts of a folder, such as 3/16; foredraw join-reports "
           "puts their reports together")
        ->type_name("I/N");
  }
  void baseline(CLI::App& app, TextArguments& arguments) {
    app.add_option("--baseline", arguments.baseline,
                   "Tell what changed since an earlier run over the folder, the worst first: its report");
  }
  void memory_limit(CLI::App& app, CommonArguments& arguments) {
    size(
        app, "--memory-limit", [&limit = arguments.memory_limit](std::uint64_t bytes) { limit = bytes; },
        "Stop with an error, and change no file, if more memory than this is needed, such as 500M or 2G (default: no "
        "limit)");
  }
  void modules(CLI::App& app, CommonArguments& arguments) {
    app.add_option("--module", arguments.modules,
                   "Also know the techniques of this module, a .so or .py file, or of all in this folder; may be given "
                   "several times. Those that the environment variable FOREDRAW_MODULES names are known as well")
        ->type_name("FILE|FOLDER")
        ->expected(1)
        ->take_all();
    how_modules_run(app, arguments);
  }
  void how_modules_run(CLI::App& app, CommonArguments& arguments) {
    const auto take = [&inside = arguments.modules_inside](const std::string& word) { inside = word == "inside"; };
    app.add_option_function<std::string>("--modules", take,
                                         "apart: modules run in processes of their own; inside: in this one, which "
                                         "saves a little time and trusts them (default: apart)")
        ->check(CLI::IsMember({"apart", "inside"}));
    app.add_option("--module-seconds", arguments.module_seconds,
                   "End a module's process that takes longer than this for a call (default: 600)")
        ->check(CLI::Range(.001, 1e6));
    size(
        app, "--module-memory", [&memory = arguments.module_memory](std::uint64_t bytes) { memory = bytes; },
        "The most memory that a module's process may hold, such as 500M (default: 2G)");
  }
  static void size(CLI::App& app, const std::string& name, std::function<void(std::uint64_t)> take,
                   const std::string& what) {
    const auto read = [name, take = std::move(take)](const std::string& text) {
      const auto bytes = byte_size_in(text);
      if (!bytes) throw CLI::ValidationError(name, "'" + text + "' is not a size; give one such as 500M or 2G");
      take(*bytes);
    };
    app.add_option_function<std::string>(name, read, what)->type_name("SIZE");
  }

  Asked asked_;
  bool shows_stats_ = true;  ///< for who says what is done anyway
  CLI::App app_{"Foredraw makes real-time scenes cheaper to draw before they are drawn.", "foredraw"};
};

}  // namespace

std::variant<Asked, Misunderstood> asked(int argc, char** argv, const Registry& registry) {
  return CommandLine(registry).run(argc, argv);
}

}  // namespace foredraw::cli
