#pragma once
// The commands: arguments in, framework call, text out.

#include <foredraw/platform/interruption.h>
#include <foredraw/report/shard.h>
#include <foredraw/technique/registry.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace foredraw::cli {

/// What a program ends with; of `interrupted`, the signal itself ends it.
enum Exit { done = 0, users_mistake = 1, something_failed = 2, out_of_bounds = 3, interrupted = 130 };

// Arguments as they were typed. Each command has a struct; what several commands take is a part of theirs.

struct CommonArguments {
  std::vector<std::string> inputs;  ///< scenes, folders or reports; none for commands that have no input
  int threads = 0;
  std::uint64_t memory_limit = 0;              ///< in bytes; 0: none
  std::vector<std::string> modules;            ///< files, and folders of them
  bool modules_inside = false;                 ///< in the program's own process
  double module_seconds = 0;                   ///< of a call; 0: as usual
  std::uint64_t module_memory = 0;             ///< bytes of a module's process; 0: as usual
  const Interruption* interruption = nullptr;  ///< of commands that may take long: where Ctrl-C is reported

  const std::atomic<bool>* cancel() const { return interruption == nullptr ? nullptr : &interruption->came(); }
  bool is_cancelled() const { return interruption != nullptr && interruption->came(); }
};

struct ReadingArguments {
  bool strict = false;  ///< refuse files with faults that would be mended
  std::string root;     ///< folder that files named by `..` may lie in
};

struct PipelineArguments {
  std::vector<std::string> pipelines;  ///< none: @default
  std::vector<std::string> set;
  std::string with;     ///< evaluators to measure with instead of the pipeline's
  Settings written_as;  ///< of output_words(), instead of the pipeline's [output]
};

struct PictureArguments {
  std::string heat_maps;  ///< folder of pictures
  std::string heat_map_view = "worst";
};

/// Texts that are written; empty: none.
struct TextArguments {
  std::string report, csv, html, depfile;
  std::string baseline;  ///< a stored report that is read
};

struct OptimizeArguments : CommonArguments, ReadingArguments, PipelineArguments, PictureArguments, TextArguments {
  std::vector<std::string> outputs;  ///< one at least; "kind:FILE" or a path
  bool json = false;
  std::string cache;           ///< folder of earlier results
  std::optional<Shard> shard;  ///< the part of a folder that is worked on
};

struct PlanArguments : CommonArguments, ReadingArguments, PipelineArguments {
  bool json = false;
};

struct MeasureArguments : CommonArguments, ReadingArguments, PipelineArguments, PictureArguments {
  bool json = false;
};

struct CompareArguments : CommonArguments, PipelineArguments, TextArguments {
  std::vector<std::string> sweeps;   ///< options at many values
  std::vector<std::string> fail_if;  ///< bounds that figures have to keep
  std::vector<std::string> fronts;   ///< two figures each
  int repeat = 1;
  bool json = false;
};

struct InspectArguments : CommonArguments, ReadingArguments {
  bool json = false;
};

struct ListArguments : CommonArguments {
  std::string kind;
  bool json = false;
};

struct ShowArguments : CommonArguments {
  std::string name;
  bool json = false;
};

struct SchemaArguments : CommonArguments {
  std::string product;  ///< empty: the pipeline's schema
};

struct CheckModuleArguments : CommonArguments {};

struct CalibrateArguments : CommonArguments {
  std::string costs;  ///< file that is written; empty: standard output
  int rounds = 7;
};

struct WatchArguments : CommonArguments, ReadingArguments, PipelineArguments {
  std::string output;
  std::string cache;
  double settle = .3;  ///< seconds for which a file is left alone before it is taken
};

struct JoinArguments : CommonArguments, TextArguments {
  bool json = false;
};

struct CacheArguments : CommonArguments {
  std::optional<std::uint64_t> trim;  ///< bytes that the cache is to keep at most
  bool verify = false;                ///< read it whole
  bool json = false;
};

Exit optimize(const OptimizeArguments& arguments, const Registry& registry);
Exit plan(const PlanArguments& arguments, const Registry& registry);
Exit measure(const MeasureArguments& arguments, const Registry& registry);
Exit compare(const CompareArguments& arguments, const Registry& registry);
Exit inspect(const InspectArguments& arguments, const Registry& registry);
Exit list(const ListArguments& arguments, const Registry& registry);
Exit show(const ShowArguments& arguments, const Registry& registry);
Exit schema(const SchemaArguments& arguments, const Registry& registry);
Exit check_module(const CheckModuleArguments& arguments, const Registry& registry);
Exit calibrate(const CalibrateArguments& arguments, const Registry& registry);
Exit join_reports(const JoinArguments& arguments, const Registry& registry);
Exit watch(const WatchArguments& arguments, const Registry& registry);
Exit cache(const CacheArguments& arguments, const Registry& registry);

/// Reads the arguments and calls the command.
int main(int argc, char** argv, const Registry& registry);

}  // namespace foredraw::cli
