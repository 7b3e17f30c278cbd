#pragma once
// What -o names: the scene, or by kind:FILE something else of it.

#include <foredraw/base/diagnostics.h>
#include <foredraw/scene/product_row.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foredraw::cli {

struct Output {
  std::string kind;  ///< "remap", "sprites", "level2", or a product's name; empty: the scene, by its path
  std::string path;
  std::shared_ptr<const ProductRow> row = {};  ///< of a product
  std::optional<std::size_t> level = {};       ///< of detail, alone

  /// As the run leaves it.
  bool is_scene() const { return kind.empty() || kind == "sprites"; }
};

/// "kind:FILE" taken apart. What stands before the first colon and is no kind belongs to the path.
Output typed_output(const std::string& word, const ProductRows& rows);

/// Reads what was typed. A path without a kind is the scene's, or of the one kind that has such files; where several
/// have, an error says which. `input`: where the scene comes from.
std::vector<Output> outputs_of(const std::vector<std::string>& words, const std::string& input, const ProductRows& rows,
                               Diagnostics& diagnostics);

/// Every path that is written to for it.
std::vector<std::filesystem::path> paths_written_for(const Output& output);

/// "remap, sprites", the products' names, and "levelN".
std::string kinds_text(const ProductRows& rows);

}  // namespace foredraw::cli
