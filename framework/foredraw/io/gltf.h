#pragma once
// glTF 2.0, read and written: .gltf with its files, .glb. The only user of tinygltf.

#include <foredraw/base/diagnostics.h>
#include <foredraw/platform/files.h>
#include <foredraw/scene/scene.h>

#include <filesystem>
#include <optional>
#include <span>

namespace foredraw {

/// Reads a file. nullopt, with a diagnostic that names file and place, where it can not be read whole and right.
std::optional<Scene> read_gltf(const std::filesystem::path& path, Diagnostics& diagnostics);

/// Reads bytes of either kind; `name` is what diagnostics call them, and files beside are looked for in `folder`
/// (empty: there are none).
std::optional<Scene> read_gltf(std::span<const std::byte> bytes, const std::string& name,
                               const std::filesystem::path& folder, Diagnostics& diagnostics);

/// The files that a scene is written as: one for a target ending in .glb, else the .gltf and its .bin beside it. What
/// no stage touched comes out as it was in the file that the scene was read from; a scene that was not read from a file
/// is written anew. Nothing is written to disk here.
std::optional<std::vector<OutputFile>> encode_gltf(const Scene& scene, const std::filesystem::path& target,
                                                   Diagnostics& diagnostics);

}  // namespace foredraw
