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

/// What was typed.
struct Arguments {
  std::vector<std::string> inputs;
  std::vector<std::string> outputs;    ///< of an optimize that is being run: one at least; "kind:FILE" or a path
  std::vector<std::string> pipelines;  ///< none: @default
  std::vector<std::string> set;
  std::string with;                 ///< evaluators to measure with instead of the pipeline's
  std::vector<std::string> sweeps;  ///< options at many values
  std::string report;
  std::string csv;
  std::string html;
  std::vector<std::string> fail_if;  ///< bounds that figures have to keep
  std::vector<std::string> fronts;   ///< two figures each
  std::string baseline;              ///< a stored report: what changed since is told, and figures are held against it
  Settings written_as;               ///< of output_words(), instead of the pipeline's
  std::string heat_maps;             ///< folder of pictures
  std::string heat_map_view = "worst";
  std::string kind;
  std::string name;
  int threads = 0;
  int repeat = 1;
  std::string costs;               ///< file that a calibration writes; empty: standard output
  int rounds = 7;                  ///< of a calibration
  std::uint64_t memory_limit = 0;  ///< in bytes; 0: none
  bool json = false;
  bool strict = false;                         ///< refuse files with faults that would be mended
  std::string root;                            ///< folder that files named by `..` may lie in
  std::vector<std::string> modules;            ///< files, and folders of them
  bool modules_inside = false;                 ///< in the program's own process
  double module_seconds = 0;                   ///< of a call; 0: as usual
  std::uint64_t module_memory = 0;             ///< bytes of a module's process; 0: as usual
  std::string depfile;                         ///< where rules of Make go
  std::string cache;                           ///< folder of earlier results
  std::optional<Shard> shard;                  ///< the part of a folder that is worked on
  std::optional<std::uint64_t> trim;           ///< bytes that a cache is to keep at most
  bool verify = false;                         ///< read a cache whole
  double settle = .3;                          ///< seconds for which a watched file is left alone before it is taken
  const Interruption* interruption = nullptr;  ///< of commands that may take long: where Ctrl-C is told

  const std::atomic<bool>* cancel() const { return interruption == nullptr ? nullptr : &interruption->came(); }
  bool is_cancelled() const { return interruption != nullptr && interruption->came(); }
};

Exit optimize(const Arguments& arguments, const Registry& registry);
Exit plan(const Arguments& arguments, const Registry& registry);
Exit measure(const Arguments& arguments, const Registry& registry);
Exit compare(const Arguments& arguments, const Registry& registry);
Exit inspect(const Arguments& arguments, const Registry& registry);
Exit list(const Arguments& arguments, const Registry& registry);
Exit show(const Arguments& arguments, const Registry& registry);
Exit schema(const Arguments& arguments, const Registry& registry);
Exit check_module(const Arguments& arguments, const Registry& registry);
Exit calibrate(const Arguments& arguments, const Registry& registry);
Exit join_reports(const Arguments& arguments, const Registry& registry);
Exit watch(const Arguments& arguments, const Registry& registry);
Exit cache(const Arguments& arguments, const Registry& registry);

/// Reads the arguments and calls the command.
int main(int argc, char** argv, const Registry& registry);

}  // namespace foredraw::cli
