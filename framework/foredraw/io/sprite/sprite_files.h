#pragma once
// Sprites: images and frame lists read as scenes, and what is written of sprites.

#include <foredraw/base/diagnostics.h>
#include <foredraw/io/reading/scene_input.h>
#include <foredraw/platform/files.h>
#include <foredraw/scene/scene.h>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foredraw {

/// Extensions of images that sprites are read from, in small letters.
std::vector<std::string_view> sprite_image_extensions();

/// Whether sprites are read from such a file: an image, or .json, a frame list.
bool is_sprite_input(const std::filesystem::path& path);
bool is_frame_list(const std::filesystem::path& path);

/// Reads an image as one sprite, or a frame list and its images as one sprite a frame. `folder`: where the images of a
/// list lie, or below the root that `how` allows. Positions are local to the frame's centre: x right, y up, z 0, one
/// unit the longer side of the image; the node puts the frame where it lies in the image, whose centre is the origin.
/// Images stay encoded; only their headers are looked at. nullopt, with errors that name file and frame, where
/// something is missing or wrong.
std::optional<Scene> read_sprite_image(std::vector<std::byte> bytes, const std::string& name, Diagnostics& diagnostics);
std::optional<Scene> read_sprite_list(std::span<const std::byte> bytes, const std::string& name,
                                      const std::filesystem::path& folder, Diagnostics& diagnostics,
                                      const SceneInput& how = {});

/// The images that a frame list names; nullopt where the file is none, such as other JSON in the same folder. A text
/// that speaks of frames and can not be read counts as one that names no image.
std::optional<std::vector<std::filesystem::path>> images_of_list(const std::filesystem::path& list);

/// True if sprites alone are written with that extension; and all such extensions.
bool is_sprite_output(const std::filesystem::path& path);
std::vector<std::string_view> sprite_output_extensions();

/// The file that the sprites of one scene, or of several, are written as, by its extension: a frame list (.json), C99
/// arrays (.h), or a page that shows all sprites (.html). Sprites are the draws with a frame; their polygons are the
/// triangles that they have now. nullopt, with an error, if a scene has none, if an image cannot be read, or if the
/// file would replace one that a scene was read from.
std::optional<OutputFile> encode_sprites(std::span<const Scene> scenes, const std::filesystem::path& target,
                                         Diagnostics& diagnostics);

/// Whether no file of these is one that the scene's sprites were read from; else an error.
bool spares_its_inputs(const Scene& scene, std::span<const OutputFile> files, Diagnostics& diagnostics);

/// The scene itself, to be outlived by it; or, of sprites, one that glTF can hold: images that are neither PNG nor JPEG
/// become PNG. None, with an error, where one has floats, which glTF has no image for.
std::shared_ptr<const Scene> sprites_for_gltf(const Scene& scene, const std::filesystem::path& target,
                                              Diagnostics& diagnostics);

}  // namespace foredraw
