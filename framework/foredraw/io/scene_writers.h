#pragma once
// The kinds of files that scenes are written as: one table, which writing, help and messages follow.

#include <foredraw/base/diagnostics.h>
#include <foredraw/io/gltf/gltf.h>
#include <foredraw/platform/files.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foredraw {

/// Scenes of meshes, or of sprites: those that were read from images and frame lists.
enum class SceneType { meshes, sprites };

struct SceneWriter {
  using Files = std::optional<std::vector<OutputFile>>;  ///< the main one first; nullopt: an error says why

  std::vector<std::string_view> extensions;  ///< in lower case, ".glb"
  bool holds_meshes = true;
  bool holds_sprites = true;
  Files (*encode)(const Scene&, const std::string& path, Diagnostics&, const GltfOutput&) = nullptr;
  /// Encodes one level of detail alone, which the scene has; null: the kind has no such files.
  Files (*encode_level)(const Scene&, std::size_t level, const std::string& path, Diagnostics&,
                        const GltfOutput&) = nullptr;
  /// Every path that may be written to, the main one first; null: the path alone.
  std::vector<std::filesystem::path> (*paths)(const std::filesystem::path&) = nullptr;

  bool holds(SceneType what) const { return what == SceneType::meshes ? holds_meshes : holds_sprites; }
};

/// By the extension, in any case; standard output is written by the first one, glTF.
const std::vector<SceneWriter>& scene_writers();

/// nullptr: scenes are not written as such files. "-" is standard output.
const SceneWriter* scene_writer_of(const std::filesystem::path& path);

/// ".glb, .gltf, .obj"
std::string extensions_written(SceneType what);

}  // namespace foredraw
