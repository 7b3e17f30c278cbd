#pragma once
// Meshes in OBJ, PLY, OFF and STL, read into flat arrays, and written back to their own kind or made anew.

#include <foredraw/base/diagnostics.h>
#include <foredraw/io/reading/scene_input.h>
#include <foredraw/platform/files.h>
#include <foredraw/scene/scene.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace foredraw {

enum class MeshKind { obj, ply, off, stl };

/// By the extension, in any case; nullopt: it is another kind of file.
std::optional<MeshKind> mesh_kind_of(const std::filesystem::path& path);

/// ".obj"
std::string_view extension_of(MeshKind kind);
std::vector<std::string_view> mesh_extensions();  ///< of all kinds

/// Reads bytes; `name` is what diagnostics call them, and an OBJ's material libraries are looked for in `folder`
/// (empty: there are none). nullopt, with an error that names file and line (or byte), where they can not be read whole
/// and right; what is mended or left out is told by warnings and notes. Safe to call from several threads.
std::optional<Scene> read_mesh_file(std::span<const std::byte> bytes, MeshKind kind, const std::string& name,
                                    const std::filesystem::path& folder, Diagnostics& diagnostics,
                                    const SceneInput& how = {});

/// The file that a scene was read from, its faces and vertices in the scene's order and all else as it was: byte for
/// byte where nothing moved. nullopt, with an error, where the scene did not come from a file of this kind, or where
/// more than the order was changed.
std::optional<OutputFile> encode_mesh_file(const Scene& scene, MeshKind kind, const std::filesystem::path& target,
                                           Diagnostics& diagnostics);

/// A file made anew of the triangles that the scene shows, wherever it came from: as its nodes place them, meshes with
/// skins as they are bound. An OBJ has positions, texture coordinates, normals and the names of draws and materials; a
/// PLY the same without names, and colours; OFF and STL positions alone. nullopt, with an error, where none is shown.
std::optional<OutputFile> encode_new_mesh_file(const Scene& scene, MeshKind kind, const std::filesystem::path& target,
                                               Diagnostics& diagnostics);

/// The source that a glTF file of the scene is made from, if the scene was read from a mesh file; null: it was not.
std::shared_ptr<const SceneSource> source_for_gltf(const Scene& scene);

/// encode_mesh_file() for a scene that was read from a file of this kind and whose order alone was changed; any other
/// scene as encode_new_mesh_file(), with a warning that names what the file does not hold.
std::optional<OutputFile> encode_as_mesh_file(const Scene& scene, MeshKind kind, const std::filesystem::path& target,
                                              Diagnostics& diagnostics);

}  // namespace foredraw
