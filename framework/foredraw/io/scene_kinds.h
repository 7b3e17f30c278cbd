#pragma once
// The kinds of files that scenes are read from: one table, which reading, help and messages follow.

#include <foredraw/base/diagnostics.h>
#include <foredraw/io/reading/scene_input.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foredraw {

/// A file's content, and where it came from.
struct SceneBytes {
  std::vector<std::byte> bytes;
  std::string name;              ///< what diagnostics call it: the path
  std::filesystem::path folder;  ///< where files beside it are looked for; empty: there are none
};

enum class Holds { meshes, image, frame_list };

struct SceneKind {
  std::vector<std::string_view> extensions;  ///< in small letters, ".glb"
  Holds holds = Holds::meshes;
  std::optional<Scene> (*read)(SceneBytes, Diagnostics&, const SceneInput&) = nullptr;
};

/// By the extension, in any case; what no kind has is read as the first one, glTF.
const std::vector<SceneKind>& scene_kinds();

/// nullptr: scenes are not read from such files.
const SceneKind* scene_kind_of(const std::filesystem::path& path);

/// ".glb, .gltf, .obj"
std::string extensions_that_hold(Holds holds);

}  // namespace foredraw
