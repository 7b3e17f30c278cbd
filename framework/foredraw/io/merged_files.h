#pragma once
// Merged draws for engines: their buffers as they are uploaded, what lies where in them, and the shaders' vertex fetch.

#include <foredraw/base/diagnostics.h>
#include <foredraw/platform/files.h>
#include <foredraw/scene/scene.h>

#include <filesystem>
#include <optional>
#include <vector>

namespace foredraw {

/// Whether the extension is one that merged draws are written as: .json, .glsl, .hlsl.
bool is_merged_output(const std::filesystem::path& path);

/// The buffers that a .json speaks of: out.json.bin beside out.json.
std::filesystem::path merged_buffer_beside(const std::filesystem::path& json);

/// The files that a scene's merged draws are written as, by the extension: what lies where (.json) and the buffers in a
/// file beside it, or functions for a vertex shader (.glsl, .hlsl). docs/merge-instances.md tells what the members mean.
/// nullopt, with an error, where nothing of the scene is merged or a shader could not address the vertices.
std::optional<std::vector<OutputFile>> encode_merged(const Scene& scene, const std::filesystem::path& target,
                                                     Diagnostics& diagnostics);

}  // namespace foredraw
