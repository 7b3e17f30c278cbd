#include "folder_outputs.h"

#include "file_runs.h"

#include <foredraw/io/scene_file.h>
#include <foredraw/io/sprite/sprite_files.h>

#include <fmt/format.h>

#include <set>
#include <unordered_map>

namespace foredraw::cli {

namespace {

namespace fs = std::filesystem;

/// Where paths lead to, there or not. Of many files in a few folders, the system is asked once for each folder; and
/// texts take a tenth of the memory of paths.
class Places {
 public:
  std::string of(const fs::path& file) {
    std::error_code error;
    const fs::path whole = (here_ / file).lexically_normal();
    const auto [at, is_new] = folders_.try_emplace(whole.parent_path().string());
    if (is_new) at->second = looked_at(whole.parent_path());
    const std::string name = whole.filename().string();
    return at->second.links.contains(name) ? fs::weakly_canonical(whole, error).string() : at->second.place + name;
  }

 private:
  struct Folder {
    std::string place;            ///< with a slash behind it
    std::set<std::string> links;  ///< in it
  };

  static Folder looked_at(const fs::path& folder) {
    std::error_code error;
    Folder found{fs::weakly_canonical(folder, error).string() + '/', {}};
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
      std::error_code gone;
      if (at->is_symlink(gone)) found.links.insert(at->path().filename().string());
    }
    return found;
  }

  static fs::path here() {
    std::error_code error;
    return fs::current_path(error);
  }

  fs::path here_ = here();
  std::unordered_map<std::string, Folder> folders_;
};

constexpr std::size_t an_input = ~std::size_t{0};

}  // namespace

fs::path output_of(const fs::path& scene, const fs::path& folder) {
  fs::path output = folder / scene;
  if (is_sprite_input(scene)) return output.replace_extension(".json");
  return is_gltf_file(output) ? output : output.replace_extension(".glb");
}

FolderOutputs outputs_in(const std::vector<std::string>& words, const ProductRows& rows, Diagnostics& diagnostics) {
  FolderOutputs result;
  for (const std::string& word : words) {
    const JobOutput output = typed_output(word, rows);
    if (!output.is_scene()) {
      diagnostics.error({.file = output.path}, "bad-arguments",
                        "holds the " + output.kind + " of one scene, but the input is a folder",
                        "run foredraw on a single file for this output");
    } else if (is_sprite_output(output.path) && !is_folder(output.path)) {
      result.gathered.push_back(output.path);
    } else if (result.folder.empty()) {
      result.folder = output.path;
    } else {
      diagnostics.error({.file = output.path}, "bad-arguments", "is a second folder for the same scenes",
                        fmt::format("give -o one folder, and as further outputs only files of sprites: {}",
                                    fmt::join(sprite_output_extensions(), ", ")));
    }
  }
  return result;
}

bool outputs_meet(const std::vector<fs::path>& scenes, const fs::path& from, const FolderOutputs& outputs,
                  Diagnostics& diagnostics) {
  Places places;
  std::unordered_map<std::string, std::size_t> taken;  // by which scene, or by an input
  std::error_code error;
  for (fs::recursive_directory_iterator at(from, error), end; at != end; at.increment(error)) {
    if (at->is_directory(error) && fs::equivalent(at->path(), outputs.folder, error)) {
      at.disable_recursion_pending();
    } else if (at->is_regular_file(error)) {
      taken.emplace(places.of(at->path()), an_input);
    }
  }
  const auto name_of = [&](std::size_t taker) {
    return taker < scenes.size() ? scenes[taker].string() : "all sprites";
  };
  const auto take = [&](const fs::path& output, std::size_t taker) {
    for (const fs::path& file : foredraw::paths_written_for(output)) {
      const auto [at, is_new] = taken.emplace(places.of(file), taker);
      if (is_new) continue;
      const bool is_input = at->second == an_input;
      const std::string who =
          is_input ? "an input and the output of " : "the outputs of " + name_of(at->second) + " and ";
      diagnostics.error({.file = file.string()}, "outputs-meet", who + name_of(taker) + " would both have this name",
                        is_input ? "give -o another folder" : "give one of them another name");
      return;  // that further files of the two meet is the same
    }
  };
  for (std::size_t i = 0; i < scenes.size(); ++i) take(output_of(scenes[i], outputs.folder), i);
  for (const std::string& file : outputs.gathered) take(file, scenes.size());
  return diagnostics.has_errors();
}

}  // namespace foredraw::cli
