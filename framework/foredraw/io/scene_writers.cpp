#include <foredraw/io/scene_writers.h>

#include <foredraw/base/counted.h>
#include <foredraw/io/gltf/patch/private/write.h>
#include <foredraw/io/mesh/mesh_files.h>
#include <foredraw/io/sprite/sprite_files.h>
#include <foredraw/io/text/private/file_kind.h>
#include <foredraw/scene/levels.h>

#include <algorithm>

namespace foredraw {

namespace {

namespace fs = std::filesystem;
using Files = SceneWriter::Files;

Files one_file(std::optional<OutputFile> file) {
  if (!file) return std::nullopt;
  std::vector<OutputFile> files;
  files.push_back(std::move(*file));
  return files;
}

/// As the writer of glTF does for what was glTF: no output is larger than its input without a word.
void report_growth(std::uint64_t before, const std::vector<OutputFile>& files, Diagnostics& diagnostics) {
  std::uint64_t after = 0;
  for (const OutputFile& file : files) after += file.bytes.size();
  if (before == 0 || after <= before) return;
  diagnostics.note({.file = files.front().path.string()}, "output-grew",
                   "the output has " + counted(after) + " bytes; the input had " + counted(before),
                   "the input has another format, or writes its numbers with fewer characters");
}

Files gltf_files(const Scene& scene, const std::string& path, Diagnostics& diagnostics, const GltfOutput& as) {
  const bool is_standard = path == "-";
  auto written = sprites_for_gltf(scene, path, diagnostics);
  if (!written) return std::nullopt;
  const auto source = source_for_gltf(scene);
  if (source) {
    Scene patched = *written;
    patched.source = source;
    written = std::make_shared<const Scene>(std::move(patched));
  }
  auto files = encode_gltf(*written, is_standard ? "standard output.glb" : path, diagnostics, as);
  if (!files || !spares_its_inputs(scene, *files, diagnostics)) return std::nullopt;
  if (source) report_growth(scene.source->bytes(), *files, diagnostics);
  if (!is_standard) return files;
  if (files->size() > 1) {
    diagnostics.error(
        {.file = "standard output"}, "several-files", "the scene takes several files, but standard output holds one",
        "give -o the name of a file, or leave out compressed data and its copies with --compression none");
    return std::nullopt;
  }
  files->front().path = path;
  return files;
}

Files gltf_level(const Scene& scene, std::size_t level, const std::string& path, Diagnostics& diagnostics,
                 const GltfOutput& as) {
  const auto has_nodes = [&](const Draw& draw) {
    return std::ranges::any_of(draw.levels, [](const Level& one) { return one.origin.has_value(); });
  };
  if (std::ranges::none_of(scene.draws, has_nodes)) return gltf_files(at_level(scene, level), path, diagnostics, as);
  diagnostics.error({.file = path}, "cannot-express",
                    "the file's levels are nodes of their own (MSFT_lod), which stay in it as they came",
                    "give this output the extension .obj, .ply, .off or .stl");
  return std::nullopt;
}

std::vector<fs::path> gltf_paths(const fs::path& path) {
  std::vector<fs::path> paths{path};
  if (path == "-") return paths;
  if (!gltf::is_glb(path)) paths.push_back(gltf::buffer_beside(path));
  paths.push_back(gltf::fallback_beside(path, 0));
  return paths;
}

Files mesh_file(const Scene& scene, const std::string& path, Diagnostics& diagnostics, const GltfOutput&) {
  auto files = one_file(encode_as_mesh_file(scene, mesh_kind_of(path).value(), path, diagnostics));
  if (!files) return std::nullopt;
  scene.products.each([&](const std::string& name) {
    diagnostics.warning({.file = path}, "product-left-out",
                        "this kind of file cannot hold '" + name + "'; it is left out",
                        "write the scene as .glb too, or -o " + name + ":FILE");
  });
  if (scene.source) report_growth(scene.source->bytes(), *files, diagnostics);
  return files;
}

Files mesh_level(const Scene& scene, std::size_t level, const std::string& path, Diagnostics& diagnostics,
                 const GltfOutput&) {
  return one_file(encode_new_mesh_file(at_level(scene, level), mesh_kind_of(path).value(), path, diagnostics));
}

Files sprite_file(const Scene& scene, const std::string& path, Diagnostics& diagnostics, const GltfOutput&) {
  return one_file(encode_sprites({&scene, 1}, path, diagnostics));
}

}  // namespace

const std::vector<SceneWriter>& scene_writers() {
  static const std::vector<SceneWriter> writers{
      {.extensions = {".glb", ".gltf"}, .encode = gltf_files, .encode_level = gltf_level, .paths = gltf_paths},
      {.extensions = mesh_extensions(), .holds_sprites = false, .encode = mesh_file, .encode_level = mesh_level},
      {.extensions = sprite_output_extensions(), .holds_meshes = false, .encode = sprite_file}};
  return writers;
}

const SceneWriter* scene_writer_of(const fs::path& path) {
  if (path == "-") return &scene_writers().front();
  const std::string extension = lower_extension(path);
  for (const SceneWriter& writer : scene_writers()) {
    if (std::ranges::find(writer.extensions, extension) != writer.extensions.end()) return &writer;
  }
  return nullptr;
}

std::string extensions_written(SceneType what) {
  std::string text;
  for (const SceneWriter& writer : scene_writers()) {
    if (!writer.holds(what)) continue;
    for (const std::string_view extension : writer.extensions) text.append(text.empty() ? "" : ", ").append(extension);
  }
  return text;
}

}  // namespace foredraw
