#pragma once
// Sprites to files of several kinds. Private to io.

#include <foredraw/io/sprite/private/drawn_sprites.h>

#include <foredraw/base/diagnostics.h>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace foredraw::sprites {

/// A scene and what is drawn of it.
struct Sheet {
  const Scene* scene = nullptr;
  const SpriteSource* source = nullptr;  ///< none: the scene was made elsewhere
  std::vector<DrawnSprite> sprites;
};

/// The image's file as a list in the target's folder names it; where there is none, the image's name.
std::string image_beside(const Sheet& sheet, std::size_t image, const std::filesystem::path& target);

/// How the triangles of all of them run as the picture is seen: "counter-clockwise", "clockwise" or "either".
std::string winding_of(std::span<const Sheet> sheets);

// Each makes the whole text; nullopt, with an error, where it can not be made.
std::optional<std::string> list_text(std::span<const Sheet> sheets, const std::filesystem::path& target,
                                     Diagnostics& diagnostics);
std::optional<std::string> header_text(std::span<const Sheet> sheets, const std::filesystem::path& target,
                                       Diagnostics& diagnostics);
std::optional<std::string> page_text(std::span<const Sheet> sheets, const std::filesystem::path& target,
                                     Diagnostics& diagnostics);

}  // namespace foredraw::sprites
