#include <foredraw/io/gltf/gltf.h>

#include <foredraw/io/gltf/gate/private/gate.h>
#include <foredraw/io/gltf/private/kept_meshes.h>
#include <foredraw/io/gltf/private/levels.h>
#include <foredraw/io/gltf/private/products.h>
#include <foredraw/io/gltf/private/source.h>

namespace foredraw {

namespace {

std::optional<Scene> read(Shared<std::byte> file, const std::string& name, const std::filesystem::path& folder,
                          Diagnostics& diagnostics, const SceneInput& how) {
  auto document = gltf::open_document(std::move(file), name, folder, how, diagnostics);
  if (!document) return std::nullopt;
  Scene scene = gltf::scene_of(*document);
  std::vector<gltf::Ladder> ladders = gltf::lod_ladders(scene, *document, diagnostics);
  ladders.insert(ladders.end(), document->ladders.begin(), document->ladders.end());
  gltf::fold_levels(scene, ladders);
  gltf::find_kept_meshes(scene, *document);
  if (!gltf::read_products(*document, scene, how.strict, diagnostics)) return std::nullopt;
  scene.source = std::make_shared<const gltf::Source>(std::move(*document), gltf::unfolded(scene));
  return scene;
}

}  // namespace

std::optional<Scene> read_gltf(const std::filesystem::path& path, Diagnostics& diagnostics, const SceneInput& how) {
  auto bytes = read_file(path, diagnostics, FileRead::all_of_it, how.files.get());
  if (!bytes) return std::nullopt;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  return read(Shared<std::byte>(std::move(*bytes)), path.string(), folder, diagnostics, how);
}

std::optional<Scene> read_gltf(std::vector<std::byte> bytes, const std::string& name,
                               const std::filesystem::path& folder, Diagnostics& diagnostics, const SceneInput& how) {
  return read(Shared<std::byte>(std::move(bytes)), name, folder, diagnostics, how);
}

}  // namespace foredraw
