#pragma once
// How scenes are read: what every reader of a file is told beside its bytes.

#include <foredraw/base/files_read.h>
#include <foredraw/base/parallel.h>
#include <foredraw/scene/product_row.h>

#include <filesystem>
#include <memory>

namespace foredraw {

struct SceneInput {
  /// Who reads the products that a glTF file holds. What none of them knows is a foreign extension, which stays as it
  /// is.
  ProductRows products = {};

  /// Refuses what else would be read with a warning: the faults of faults.h.
  bool strict = false;

  /// Files that the scene names by a path with `..` may lie anywhere below this folder. Empty: only below the scene's
  /// own.
  std::filesystem::path root = {};

  /// Whose threads decompress what takes long.
  Executor executor = Executor(1);

  /// Is told of every file that is read or looked for; null: nobody asks.
  std::shared_ptr<FilesRead> files = nullptr;
};

}  // namespace foredraw
