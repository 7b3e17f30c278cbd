#include <foredraw/io/scene_file.h>

#include <foredraw/base/counted.h>
#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/gltf/patch/private/stand_ins.h>
#include <foredraw/io/gltf/patch/private/write.h>
#include <foredraw/io/imported_file.h>
#include <foredraw/io/mesh/mesh_files.h>
#include <foredraw/io/mesh/private/source.h>
#include <foredraw/io/scene_kinds.h>
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

/// As the writer of glTF does for what was glTF: no output is larger than its input without a word.
void tell_growth(std::uint64_t before, const std::vector<OutputFile>& files, Diagnostics& diagnostics) {
  std::uint64_t after = 0;
  for (const OutputFile& file : files) after += file.bytes.size();
  if (after <= before) return;
  diagnostics.note({.file = files.front().path.string()}, "output-grew",
                   "the output has " + counted(after) + " bytes; the input had " + counted(before),
                   "the input has another format, or writes its numbers with fewer characters");
}

/// The file that was read, in the scene's order; made anew where a stage made other triangles.
std::optional<OutputFile> encode_mesh_file_or_new(const Scene& scene, MeshKind kind, const std::string& path,
                                                  Diagnostics& diagnostics) {
  Diagnostics told;
  auto file = encode_mesh_file(scene, kind, path, told);
  if (!file && std::ranges::find(told.all(), "other-triangles", &Diagnostic::code) != told.all().end()) {
    file = encode_new_mesh_file(scene, kind, path, diagnostics);
    if (!file) return std::nullopt;
    diagnostics.warning(
        {.file = path}, "made-anew",
        "more than the order was changed, so the file is made anew: it holds the triangles that are drawn, "
        "and nothing else of the input",
        "write a .glb to keep the rest");
    return file;
  }
  for (const Diagnostic& one : told.all()) diagnostics.add(one);
  return file;
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
  if (path == "-" || is_gltf_file(path)) return true;
  const bool is_of_sprites = input != "-" && is_sprite_input(input);
  if (is_of_sprites && is_sprite_output(path)) return true;
  const auto mesh_kind = mesh_kind_of(path);
  if (mesh_kind && input != "-" && mesh_kind == mesh_kind_of(input)) return true;
  if (mesh_kind) {
    diagnostics.error(
        {.file = path}, "unknown-kind",
        "only a scene that was read from " + std::string(extension_of(*mesh_kind)) + " can be written as one",
        "give the output the extension .glb, or that of the input");
  } else if (is_sprite_output(path)) {
    diagnostics.error({.file = path}, "unknown-kind", "this kind of file holds only sprites",
                      "give the output the extension .glb, or use an image or a frame list as input");
  } else if (is_of_sprites) {
    diagnostics.error({.file = path}, "unknown-kind", "sprites cannot be written as this kind of file",
                      "use .glb, .gltf, " + sprite_output_extensions());
  } else {
    diagnostics.error({.file = path}, "unknown-kind",
                      "scenes can be written as .glb or .gltf, or as the kind of the input",
                      "give the output one of these extensions, or - for a GLB on standard output");
  }
  return false;
}

std::optional<std::vector<OutputFile>> encode_scene(const Scene& scene, const std::string& path,
                                                    Diagnostics& diagnostics, const GltfOutput& as) {
  if (is_sprite_output(path)) {
    auto file = encode_sprites({&scene, 1}, path, diagnostics);
    return file ? std::optional(std::vector<OutputFile>{std::move(*file)}) : std::nullopt;
  }
  if (!can_write_scene(path, scene.name, diagnostics)) return std::nullopt;
  const bool is_standard = path == "-";
  const auto mesh_source = std::dynamic_pointer_cast<const mesh_files::MeshSource>(scene.source);
  if (const auto mesh_kind = mesh_kind_of(path)) {
    auto file = encode_mesh_file_or_new(scene, *mesh_kind, path, diagnostics);
    if (!file) return std::nullopt;
    scene.products.each([&](const std::string& name) {
      diagnostics.warning({.file = path}, "product-left-out",
                          "this kind of file cannot hold '" + name + "'; it is left out",
                          "write the scene as .glb too, or -o " + name + ":FILE");
    });
    std::vector<OutputFile> files{std::move(*file)};
    if (mesh_source) tell_growth(mesh_source->bytes(), files, diagnostics);
    return files;
  }
  auto for_gltf = sprites_for_gltf(scene, path, diagnostics);
  if (!for_gltf) return std::nullopt;
  if (mesh_source) {
    Scene as_gltf = *for_gltf;
    as_gltf.source = mesh_source->gltf;
    for_gltf = std::make_shared<const Scene>(std::move(as_gltf));
  }
  auto files = encode_gltf(*for_gltf, is_standard ? "standard output.glb" : path, diagnostics, as);
  if (files && !spares_its_inputs(scene, *files, diagnostics)) return std::nullopt;
  if (files && mesh_source) tell_growth(mesh_source->bytes(), *files, diagnostics);
  if (!files || !is_standard) return files;
  if (files->size() > 1) {
    diagnostics.error(
        {.file = "standard output"}, "several-files", "the scene takes several files, but standard output holds one",
        "give -o the name of a file, or leave out compressed data and its copies with --compression none");
    return std::nullopt;
  }
  files->front().path = path;
  return files;
}

std::optional<std::vector<OutputFile>> encode_level(const Scene& scene, std::size_t level, const std::string& path,
                                                    Diagnostics& diagnostics, const GltfOutput& as) {
  if (const std::size_t most = most_levels(scene); level >= most) {
    diagnostics.error({.file = path}, "no-such-level", "no draw has a level " + std::to_string(level),
                      most < 2 ? "no stage made levels of detail: use a pipeline that does, such as @levels"
                               : "the coarsest is level " + std::to_string(most - 1));
    return std::nullopt;
  }
  const Scene alone = at_level(scene, level);
  const auto mesh_kind = mesh_kind_of(path);
  if (!mesh_kind) {
    const auto has_nodes = [&](const Draw& draw) {
      return std::ranges::any_of(draw.levels, [](const Level& one) { return one.origin.has_value(); });
    };
    if (std::ranges::none_of(scene.draws, has_nodes)) return encode_scene(alone, path, diagnostics, as);
    diagnostics.error({.file = path}, "cannot-express",
                      "the file's levels are nodes of their own (MSFT_lod), which stay in it as they came",
                      "give this output the extension .obj, .ply, .off or .stl");
    return std::nullopt;
  }
  auto file = encode_new_mesh_file(alone, *mesh_kind, path, diagnostics);
  if (!file) return std::nullopt;
  return std::vector<OutputFile>{std::move(*file)};
}

std::vector<fs::path> paths_written_for(const fs::path& path) {
  std::vector<fs::path> paths{path};
  if (!is_gltf_file(path)) return paths;
  if (!gltf::is_glb(path)) paths.push_back(gltf::buffer_beside(path));
  paths.push_back(gltf::fallback_beside(path, 0));
  return paths;
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
