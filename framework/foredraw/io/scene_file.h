#pragma once
// Scenes by path. "-" is standard input or output; the extension picks the kind.

#include <foredraw/base/diagnostics.h>
#include <foredraw/io/gltf.h>
#include <foredraw/platform/files.h>
#include <foredraw/scene/scene.h>

#include <cstdint>
#include <optional>
#include <string>

namespace foredraw {

struct SceneFile {
  Scene scene;
  std::uint64_t bytes = 0;  ///< of the file itself, without those beside it
};

std::optional<SceneFile> read_scene(const std::string& path, Diagnostics& diagnostics);

/// Whether scenes can be written to a path of this kind; a diagnostic says why not.
bool can_write_scene(const std::string& path, Diagnostics& diagnostics);

/// The files that the scene is written as, the main one first; for "-" one GLB whose path is "-". Nothing is written
/// here.
std::optional<std::vector<OutputFile>> encode_scene(const Scene& scene, const std::string& path,
                                                    Diagnostics& diagnostics,
                                                    Compression compression = Compression::keep);

}  // namespace foredraw
