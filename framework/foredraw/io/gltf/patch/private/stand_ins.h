#pragma once
// What makes the replacement of a .gltf with its buffers whole at every moment. Private to io.

#include <foredraw/platform/files.h>

#include <span>
#include <vector>

namespace foredraw::gltf {

/// What has to be written before the files of a scene, so that a .gltf never names a buffer of another: the same files,
/// but with other names for the buffers. Empty where nothing is in the way.
std::vector<OutputFile> stand_ins(std::span<const OutputFile> files);

/// Removes the stand-ins of a buffer's file, also those of who was killed.
void remove_stand_ins(const OutputFile& file);

}  // namespace foredraw::gltf
