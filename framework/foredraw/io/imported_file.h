#pragma once
// Scenes of other formats, which the program foredraw-import turns into glTF in a process of its own.

#include <foredraw/base/content_hash.h>
#include <foredraw/base/diagnostics.h>
#include <foredraw/io/reading/scene_input.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace foredraw {

struct ImportLimits {
  double seconds = 300;
  std::uint64_t memory = std::uint64_t{4} << 30;  ///< bytes of data that the process may hold
  std::filesystem::path importer = {};            ///< the program foredraw-import; empty: there is none
  std::string wrong = {};  ///< what the environment says that can not be; then nothing is imported
};

/// As FOREDRAW_IMPORT_SECONDS and FOREDRAW_IMPORT_MEMORY (bytes) say; the importer is FOREDRAW_IMPORTER, or lies by the
/// program that runs, or in its installation.
ImportLimits import_limits();

/// Whether files with this extension are read by foredraw-import: ".fbx", ".dae", ".3ds", ".blend" and others.
bool is_imported_file(const std::filesystem::path& path);
/// ".3ds, .ac, .ase"
std::string imported_extensions();

/// Of the importer and the libraries that it loads: what one build reads, another may read otherwise. The stamp of
/// nothing where there is none, and of its file alone where it does not answer.
Stamp importer_stamp(const ImportLimits& limits);

/// Of a file that is there. Files that it names are read below its folder or `how.root`; `how.files` is told of them.
/// nullopt, with a diagnostic, where there is no importer, where it refuses the file, crashes, or reaches a limit.
std::optional<Scene> read_imported(const std::filesystem::path& path, Diagnostics& diagnostics, const SceneInput& how,
                                   const ImportLimits& limits);

}  // namespace foredraw
