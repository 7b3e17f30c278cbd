#pragma once
// The outputs of a job: the scene, or by kind:FILE something else of it.

#include <foredraw/base/diagnostics.h>
#include <foredraw/platform/files.h>
#include <foredraw/scene/output_settings.h>
#include <foredraw/scene/product_row.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace foredraw {

struct JobOutput {
  std::string kind;  ///< "remap", "sprites", "level2", or a product's name; empty: the scene, by its path
  std::string path;
  std::shared_ptr<const ProductRow> row = {};  ///< of a product
  std::optional<std::size_t> level = {};       ///< of detail, alone

  /// As the run leaves it.
  bool is_scene() const { return kind.empty() || kind == "sprites"; }
};

/// "kind:FILE" taken apart. What stands before the first colon and is no kind belongs to the path.
JobOutput typed_output(const std::string& word, const ProductRows& rows);

/// Reads what was typed. A path without a kind is the scene's, or of the one kind that has such files; where several
/// have, an error says which. `input`: where the scene comes from.
std::vector<JobOutput> outputs_of(const std::vector<std::string>& words, const std::string& input,
                                  const ProductRows& rows, Diagnostics& diagnostics);

/// Every path that is written to for it.
std::vector<std::filesystem::path> paths_written_for(const JobOutput& output);

/// "remap, sprites", the products' names, and "levelN".
std::string kinds_text(const ProductRows& rows);

/// True if each scene among the outputs can be written as that kind of file; diagnostics say why not.
bool can_write(const std::vector<JobOutput>& outputs, const std::string& input, Diagnostics& diagnostics);

/// True if the folders of the files exist, so that nothing is computed in vain. Empty names are no files.
bool have_folders(const std::vector<std::string>& files, Diagnostics& diagnostics);

/// The files of the output, the main one first; nullopt, with an error. `rows` write the products.
std::optional<std::vector<OutputFile>> encode(const Scene& scene, const JobOutput& output,
                                              const OutputSettings& settings, const ProductRows& rows,
                                              Diagnostics& diagnostics);

/// Files of sprites, each of which holds those of all the scenes.
std::optional<std::vector<OutputFile>> encode_together(std::span<const Scene> scenes,
                                                       const std::vector<std::string>& paths, Diagnostics& diagnostics);

}  // namespace foredraw
