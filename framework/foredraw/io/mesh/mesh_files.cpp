#include <foredraw/io/mesh/mesh_files.h>

#include <foredraw/io/mesh/private/materials.h>
#include <foredraw/io/mesh/private/obj.h>
#include <foredraw/io/mesh/private/off.h>
#include <foredraw/io/mesh/private/ply.h>
#include <foredraw/io/mesh/private/source.h>
#include <foredraw/io/mesh/private/stl.h>
#include <foredraw/io/text/private/file_kind.h>

#include <fmt/format.h>

#include <utility>

namespace foredraw {

namespace {

using namespace mesh_files;

constexpr std::pair<MeshKind, std::string_view> extensions[] = {
    {MeshKind::obj, ".obj"}, {MeshKind::ply, ".ply"}, {MeshKind::off, ".off"}, {MeshKind::stl, ".stl"}};

bool read_polygons(MeshKind kind, const Reading& reading, PolygonMesh& mesh, std::vector<std::string>& libraries) {
  switch (kind) {
    case MeshKind::obj: return read_obj(reading, mesh, libraries);
    case MeshKind::ply: return read_ply(reading, mesh);
    case MeshKind::off: return read_off(reading, mesh);
    case MeshKind::stl: return read_stl(reading, mesh);
  }
  return false;
}

std::optional<Scene> scene_from(std::shared_ptr<MeshSource> source, const std::string& name, const FilePlaces& where,
                                Faults& faults, Diagnostics& diagnostics) {
  Reading reading{name, source->text(), diagnostics, &faults};
  const bool is_utf16 = reading.text.starts_with("\xFE\xFF") || reading.text.starts_with("\xFF\xFE");
  if (source->kind == MeshKind::obj && is_utf16) {
    reading.refuse({.file = name}, "the text is UTF-16", "save it as UTF-8");
    return std::nullopt;
  }
  // A corner takes a byte at least, so that no number of anything can leave 32 bits.
  if (reading.text.size() >= none) {
    reading.refuse({.file = name}, "the file is longer than 4 GiB");
    return std::nullopt;
  }
  PolygonMesh mesh;
  std::vector<std::string> libraries;
  if (!read_polygons(source->kind, reading, mesh, libraries)) return std::nullopt;
  MaterialLibrary library = read_libraries(libraries, name, where, faults, diagnostics);
  auto made = scene_of(mesh, std::move(library.materials), name, diagnostics);
  if (!made) return std::nullopt;
  Scene scene = std::move(made->scene);
  scene.images = std::move(library.images);
  source->records = std::move(made->draws);
  source->gltf = gltf_source_of(std::move(library.json), scene, where.folder, faults);
  source->as_read = scene;
  scene.source = std::move(source);
  return scene;
}

std::optional<std::string> reordered(const Scene& scene, const MeshSource& source, Diagnostics& diagnostics) {
  switch (source.kind) {
    case MeshKind::obj: return reordered_obj(scene, source, diagnostics);
    case MeshKind::ply: return reordered_ply(scene, source, diagnostics);
    case MeshKind::off: return reordered_off(scene, source, diagnostics);
    case MeshKind::stl: return reordered_stl(scene, source, diagnostics);
  }
  return std::nullopt;
}

}  // namespace

std::optional<MeshKind> mesh_kind_of(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  for (const auto& [kind, name] : extensions) {
    if (name == extension) return kind;
  }
  return std::nullopt;
}

std::string_view extension_of(MeshKind kind) {
  for (const auto& [known, name] : extensions) {
    if (known == kind) return name;
  }
  return {};
}

std::vector<std::string_view> mesh_extensions() {
  std::vector<std::string_view> names;
  for (const auto& [kind, name] : extensions) names.push_back(name);
  return names;
}

std::optional<Scene> read_mesh_file(std::span<const std::byte> bytes, MeshKind kind, const std::string& name,
                                    const std::filesystem::path& folder, Diagnostics& diagnostics,
                                    const SceneInput& how) {
  auto source = std::make_shared<MeshSource>();
  source->kind = kind;
  source->file = Shared<std::byte>({bytes.begin(), bytes.end()});
  Faults faults(diagnostics, how.strict);
  auto scene = scene_from(std::move(source), name, {folder, how.root, how.files}, faults, diagnostics);
  return faults.tell() ? std::move(scene) : std::nullopt;
}

std::shared_ptr<const SceneSource> source_for_gltf(const Scene& scene) {
  const auto source = std::dynamic_pointer_cast<const MeshSource>(scene.source);
  return source ? source->gltf : nullptr;
}

std::optional<OutputFile> encode_mesh_file(const Scene& scene, MeshKind kind, const std::filesystem::path& target,
                                           Diagnostics& diagnostics) {
  const auto source = std::dynamic_pointer_cast<const MeshSource>(scene.source);
  if (!source || source->kind != kind) {
    diagnostics.error({.file = target.string()}, "unknown-kind",
                      fmt::format("only a scene that was read from {0} can be written as {0}", extension_of(kind)),
                      "give the output the extension .glb, or that of the input");
    return std::nullopt;
  }
  const auto text = reordered(scene, *source, diagnostics);
  if (!text) return std::nullopt;
  const auto bytes = std::as_bytes(std::span(*text));
  return OutputFile{target, {bytes.begin(), bytes.end()}};
}

}  // namespace foredraw
