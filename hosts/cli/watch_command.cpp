// Watches a folder and keeps the outputs up to date.

#include "watched_folder.h"

namespace foredraw::cli {

namespace {

namespace fs = std::filesystem;

/// The folder that everything goes to; empty, with errors, where it can not be.
std::string out_for(const WatchArguments& arguments, const Registry& registry, Diagnostics& diagnostics) {
  const std::string& from = arguments.inputs[0];
  if (!is_folder(from)) {
    std::error_code error;
    diagnostics.error({.file = from}, "bad-arguments",
                      fs::exists(from, error) ? "is no folder, which watch needs" : "there is no such folder",
                      "name the folder that you work in");
    return {};
  }
  const FolderOutputs outputs = outputs_in({arguments.output}, registry.products(), diagnostics);
  if (diagnostics.has_errors()) return {};
  std::error_code error;
  if (!outputs.gathered.empty() || outputs.folder == "-" ||
      (fs::exists(outputs.folder, error) && !is_folder(outputs.folder))) {
    diagnostics.error({.file = arguments.output}, "bad-arguments", "is not a folder, which watch writes to",
                      "give -o the name of a folder; it is created if it does not exist");
  } else if (fs::equivalent(from, outputs.folder, error)) {
    diagnostics.error({.file = outputs.folder}, "bad-arguments", "is the input folder itself",
                      "give -o another folder; it may lie in the input folder");
  } else {
    make_folder(outputs.folder, diagnostics);
  }
  return diagnostics.has_errors() ? std::string() : outputs.folder;
}

}  // namespace

Exit watch(const WatchArguments& arguments, const Registry& registry) {
  Diagnostics diagnostics;
  const std::string out = out_for(arguments, registry, diagnostics);
  if (diagnostics.has_errors()) return refuse(diagnostics);
  const Executor executor(arguments.threads);
  auto workshop = Workshop::opened(arguments, registry, executor, diagnostics);
  if (!workshop) return refuse(diagnostics);
  return WatchedFolder(arguments, registry, out, std::move(workshop), executor).keep_up();
}

}  // namespace foredraw::cli
