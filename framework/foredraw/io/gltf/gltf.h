#pragma once
// glTF 2.0, read and written: .gltf with its files, .glb.

#include <foredraw/base/diagnostics.h>
#include <foredraw/io/reading/scene_input.h>
#include <foredraw/platform/files.h>
#include <foredraw/scene/output_settings.h>

#include <filesystem>
#include <optional>
#include <vector>

namespace foredraw {

/// Reads a file. nullopt, with a diagnostic that names file and place, where it can not be read whole and right. What
/// is compressed by Draco (KHR_draco_mesh_compression) goes out plain, unless nothing changes at all or the writer is
/// asked for Draco.
std::optional<Scene> read_gltf(const std::filesystem::path& path, Diagnostics& diagnostics, const SceneInput& how = {});

/// Reads bytes of either kind; `name` is what diagnostics call them, and files beside are looked for in `folder`
/// (empty: there are none).
std::optional<Scene> read_gltf(std::vector<std::byte> bytes, const std::string& name,
                               const std::filesystem::path& folder, Diagnostics& diagnostics,
                               const SceneInput& how = {});

struct GltfOutput {
  Compression compression = Compression::keep;
  /// What is compressed by `ext` or `khr` may start triangles at other corners, which takes less than half of the
  /// bytes.
  bool turns_corners = false;
  LevelsAs levels = LevelsAs::extension;
  ProductRows products = {};  ///< who writes them; none: those that the scene was read with
};

/// The files that a scene is written as: one for a target ending in .glb, else the .gltf and its .bin beside it; and,
/// where compressed data came with a plain copy for readers that can not decompress, that in .fallback.bin beside
/// (out.fallback.bin of out.gltf, out.glb.fallback.bin of out.glb). What no stage touched comes out as it was in the
/// file that the scene was read from; a scene that was not read from a file is written anew. A note says so where all
/// of it is longer than what was read, and by what it grew. Nothing is written to disk here.
std::optional<std::vector<OutputFile>> encode_gltf(const Scene& scene, const std::filesystem::path& target,
                                                   Diagnostics& diagnostics, const GltfOutput& as = {});

}  // namespace foredraw
