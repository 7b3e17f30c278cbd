#pragma once
// Where the files of a folder go, and whether they leave each other alone there.

#include <foredraw/base/diagnostics.h>
#include <foredraw/job/outputs.h>

#include <filesystem>
#include <string>
#include <vector>

namespace foredraw::cli {

/// Where the scene goes: to the same place in the output folder, as its own kind where that is glTF, sprites as a frame
/// list, else as a GLB.
std::filesystem::path output_of(const std::filesystem::path& scene, const std::filesystem::path& folder);

/// Where things go, of several inputs.
struct FolderOutputs {
  std::string folder;                 ///< each scene by itself; empty: nowhere
  std::vector<std::string> gathered;  ///< files of sprites that hold those of all scenes
};

FolderOutputs outputs_in(const std::vector<std::string>& words, const ProductRows& rows, Diagnostics& diagnostics);

/// "prop.glb" and "prop.obj" would both become "prop.glb"; and no file may become what another has yet to be read from:
/// any file of the folder `from`, but for those below the output folder. `scenes`: their paths below `from`; none where
/// they go nowhere.
bool outputs_meet(const std::vector<std::filesystem::path>& scenes, const std::filesystem::path& from,
                  const FolderOutputs& outputs, Diagnostics& diagnostics);

}  // namespace foredraw::cli
