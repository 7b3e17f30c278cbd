#include <foredraw/io/scene_file.h>

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/gltf/patch/private/stand_ins.h>
#include <foredraw/io/imported_file.h>
#include <foredraw/io/scene_kinds.h>
#include <foredraw/io/scene_writers.h>
#include <foredraw/io/sprite/sprite_files.h>
#include <foredraw/io/text/private/file_kind.h>
#include <foredraw/scene/levels.h>

#include <algorithm>
#include <iterator>

namespace foredraw {

namespace {

namespace fs = std::filesystem;

fs::path folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

Stamp stamp_of(const Stamp& file, const Scene& scene) {
  std::vector<Stamp> stamps{file};
  for (const Draw& draw : scene.draws) {
    for (const Level& level : draw.levels) {
      stamps.push_back(level.vertices->stamp());
      for (const IndexStream& stream : level.orders) stamps.push_back(stream.indices.stamp());
    }
  }
  return combine(stamps);
}

/// As they are put into their places, the very first one last: so that none comes before those that it names, the main
/// file of each further scene goes behind its others.
void append(std::vector<OutputFile> files, std::vector<OutputFile>& all) {
  if (!all.empty() && !files.empty()) std::rotate(files.begin(), files.begin() + 1, files.end());
  std::ranges::move(files, std::back_inserter(all));
}

}  // namespace

bool is_gltf_file(const fs::path& path) { return lower_extension(path) == ".glb" || lower_extension(path) == ".gltf"; }

bool is_scene_file(const fs::path& path) {
  const SceneKind* kind = scene_kind_of(path);
  return kind != nullptr && kind->holds == Holds::meshes;
}

std::optional<SceneFile> read_scene(const std::string& path, Diagnostics& diagnostics, const SceneInput& how) {
  if (path.empty()) {
    diagnostics.error({}, "no-such-file", "the input's name is empty",
                      "give the path of a scene, an image or a frame list, or -");
    return std::nullopt;
  }
  const bool is_standard = path == "-";
  auto bytes = is_standard ? read_standard_input(diagnostics)
                           : read_file(path, diagnostics, FileRead::all_of_it, how.files.get());
  if (!bytes) return std::nullopt;
  const std::size_t length = bytes->size();
  const Stamp stamp = content_hash(*bytes);
  SceneBytes file{std::move(*bytes), is_standard ? "standard input" : path, is_standard ? fs::path() : folder_of(path)};
  const SceneKind* kind = is_standard ? nullptr : scene_kind_of(path);
  const bool is_imported = !is_standard && kind == nullptr && is_imported_file(path);
  auto scene = is_imported ? read_imported(path, diagnostics, how, import_limits())
                           : (kind == nullptr ? scene_kinds().front() : *kind).read(std::move(file), diagnostics, how);
  if (!scene) return std::nullopt;
  const Stamp whole = stamp_of(stamp, *scene);
  const std::uint64_t with_buffers = std::max<std::uint64_t>(length, scene->source ? scene->source->bytes() : 0);
  return SceneFile{std::move(*scene), with_buffers, whole};
}

bool can_write_scene(const std::string& path, const std::string& input, Diagnostics& diagnostics) {
  const bool is_of_sprites = input != "-" && is_sprite_input(input);
  const SceneType what = is_of_sprites ? SceneType::sprites : SceneType::meshes;
  const SceneWriter* writer = scene_writer_of(path);
  if (writer != nullptr && writer->holds(what)) return true;
  const std::string hint = "give the output one of the extensions " + extensions_written(what) + ", or - for a GLB";
  if (writer == nullptr) {
    diagnostics.error({.file = path}, "unknown-kind", "scenes cannot be written as this kind of file", hint);
  } else {
    diagnostics.error({.file = path}, "unknown-kind",
                      is_of_sprites ? "this kind of file cannot hold sprites" : "this kind of file holds only sprites",
                      is_of_sprites ? hint : hint + ", or use an image or a frame list as input");
  }
  return false;
}

std::optional<std::vector<OutputFile>> encode_scene(const Scene& scene, const std::string& path,
                                                    Diagnostics& diagnostics, const GltfOutput& as) {
  const SceneWriter* writer = scene_writer_of(path);
  const bool seeks_sprites = writer != nullptr && !writer->holds_meshes;  // in the scene, whatever its name is
  if (!seeks_sprites && !can_write_scene(path, scene.name, diagnostics)) return std::nullopt;
  return writer->encode(scene, path, diagnostics, as);
}

std::optional<std::vector<OutputFile>> encode_level(const Scene& scene, std::size_t level, const std::string& path,
                                                    Diagnostics& diagnostics, const GltfOutput& as) {
  if (const std::size_t most = most_levels(scene); level >= most) {
    diagnostics.error({.file = path}, "no-such-level", "no draw has a level " + std::to_string(level),
                      most < 2 ? "no stage made levels of detail: use a pipeline that does, such as @levels"
                               : "the coarsest is level " + std::to_string(most - 1));
    return std::nullopt;
  }
  const SceneWriter* writer = scene_writer_of(path);
  if (writer != nullptr && writer->encode_level != nullptr) {
    return writer->encode_level(scene, level, path, diagnostics, as);
  }
  diagnostics.error({.file = path}, "unknown-kind", "a single level of detail cannot be written as this kind of file",
                    "give the output one of the extensions " + extensions_written(SceneType::meshes));
  return std::nullopt;
}

std::vector<fs::path> paths_written_for(const fs::path& path) {
  const SceneWriter* writer = scene_writer_of(path);
  return writer == nullptr || writer->paths == nullptr ? std::vector<fs::path>{path} : writer->paths(path);
}

bool write_scene(std::span<const OutputFile> files, Diagnostics& diagnostics) {
  return write_scenes({{files.begin(), files.end()}}, diagnostics);
}

bool write_scenes(std::vector<std::vector<OutputFile>> scenes, Diagnostics& diagnostics) {
  std::vector<OutputFile> first, all;
  std::vector<fs::path> others;
  for (auto& files : scenes) {
    for (const OutputFile& file : std::span(files).subspan(1)) others.push_back(file.path);
    append(gltf::stand_ins(files), first);
    append(std::move(files), all);
  }
  if (!first.empty() && !write_files(first, diagnostics)) return false;
  if (!write_files(all, diagnostics)) return false;
  for (const fs::path& other : others) gltf::remove_stand_ins({other, {}});  // those of a run that was killed, too
  return true;
}

}  // namespace foredraw
