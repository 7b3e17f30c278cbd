#include <foredraw/io/scene_kinds.h>

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/mesh/mesh_files.h>
#include <foredraw/io/sprite/sprite_files.h>
#include <foredraw/io/text/private/file_kind.h>

#include <algorithm>

namespace foredraw {

namespace {

std::optional<Scene> gltf_scene(SceneBytes file, Diagnostics& diagnostics, const SceneInput& how) {
  return read_gltf(std::move(file.bytes), file.name, file.folder, diagnostics, how);
}

std::optional<Scene> mesh_scene(SceneBytes file, Diagnostics& diagnostics, const SceneInput& how) {
  return read_mesh_file(file.bytes, mesh_kind_of(file.name).value(), file.name, file.folder, diagnostics, how);
}

std::optional<Scene> image_scene(SceneBytes file, Diagnostics& diagnostics, const SceneInput&) {
  return read_sprite_image(std::move(file.bytes), file.name, diagnostics);
}

std::optional<Scene> list_scene(SceneBytes file, Diagnostics& diagnostics, const SceneInput& how) {
  return read_sprite_list(file.bytes, file.name, file.folder, diagnostics, how);
}

}  // namespace

const std::vector<SceneKind>& scene_kinds() {
  static const std::vector<SceneKind> kinds{{{".glb", ".gltf"}, Holds::meshes, gltf_scene},
                                            {mesh_extensions(), Holds::meshes, mesh_scene},
                                            {sprite_image_extensions(), Holds::image, image_scene},
                                            {{".json"}, Holds::frame_list, list_scene}};
  return kinds;
}

const SceneKind* scene_kind_of(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  for (const SceneKind& kind : scene_kinds()) {
    if (std::ranges::find(kind.extensions, extension) != kind.extensions.end()) return &kind;
  }
  return nullptr;
}

std::string extensions_that_hold(Holds holds) {
  std::string text;
  for (const SceneKind& kind : scene_kinds()) {
    if (kind.holds != holds) continue;
    for (const std::string_view extension : kind.extensions) text.append(text.empty() ? "" : ", ").append(extension);
  }
  return text;
}

}  // namespace foredraw
