#pragma once
// Scenes by path. "-" is standard input or output, and then glTF; the extension picks the kind.

#include <foredraw/base/diagnostics.h>
#include <foredraw/io/gltf/gltf.h>
#include <foredraw/platform/files.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace foredraw {

struct SceneFile {
  Scene scene;
  std::uint64_t bytes = 0;  ///< of the file and of the buffers beside it
  Stamp stamp;              ///< of the file, and of all triangles and vertices, wherever they came from
};

/// Whether scenes of meshes are read from files of this extension (scene_kinds.h has others); whether it is glTF's.
bool is_scene_file(const std::filesystem::path& path);
bool is_gltf_file(const std::filesystem::path& path);

/// nullopt, with a diagnostic that names file and place, where the file can not be read whole and right.
std::optional<SceneFile> read_scene(const std::string& path, Diagnostics& diagnostics, const SceneInput& how = {});

/// True if scenes can be written to a path of this kind; a diagnostic says why not. `input`: the scene's file, because
/// some kinds hold only sprites, which come from images and frame lists, and others hold only meshes (scene_writers.h).
bool can_write_scene(const std::string& path, const std::string& input, Diagnostics& diagnostics);

/// The files that the scene is written as, the main one first; for "-" one GLB whose path is "-". Nothing is written
/// here.
std::optional<std::vector<OutputFile>> encode_scene(const Scene& scene, const std::string& path,
                                                    Diagnostics& diagnostics, const GltfOutput& as = {});

/// The same of one level of detail alone: of draws that have fewer, the coarsest. glTF, or a mesh file, made anew of
/// what is shown, wherever the scene came from. nullopt, with an error, too, where no draw has that level.
std::optional<std::vector<OutputFile>> encode_level(const Scene& scene, std::size_t level, const std::string& path,
                                                    Diagnostics& diagnostics, const GltfOutput& as = {});

/// Every path that encode_scene or encode_level may write to for one, that itself first.
std::vector<std::filesystem::path> paths_written_for(const std::filesystem::path& path);

/// Writes the files of a scene, the main one first, and whatever others come with them. As write_files does it: all or
/// none, and a process that is killed meanwhile leaves the old scene or the new one whole, of however many files it is.
bool write_scene(std::span<const OutputFile> files, Diagnostics& diagnostics);

/// Several of these, or one written as several kinds: all or none. None may be empty.
bool write_scenes(std::vector<std::vector<OutputFile>> scenes, Diagnostics& diagnostics);

}  // namespace foredraw
