#pragma once
// What the reader of images and frame lists keeps for the writers. Private to io.

#include <foredraw/base/diagnostics.h>
#include <foredraw/io/text/private/json_tree.h>
#include <foredraw/scene/scene.h>

#include <glm/vec2.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foredraw::sprites {

/// A sprite: where it lies in its image, and of which larger one it is what was left when its empty edges were cut off.
struct FrameEntry {
  std::string name;
  SpriteFrame place;        ///< in the image, as it lies there
  bool is_turned = false;   ///< lies there turned clockwise by a quarter
  glm::ivec2 offset{0};     ///< of its upper left corner in the whole sprite, in texels
  glm::ivec2 whole{0};      ///< size of the whole sprite
  std::size_t texture = 0;  ///< number of the image, and of the list's texture
  std::size_t number = 0;   ///< among the frames of that texture

  /// Its own size, upright.
  glm::ivec2 size() const {
    const auto width = static_cast<int>(place.width), height = static_cast<int>(place.height);
    return is_turned ? glm::ivec2(height, width) : glm::ivec2(width, height);
  }
};

class SpriteSource final : public SceneSource {
 public:
  Json list;                                       ///< as it came; null: the scene was an image
  std::vector<FrameEntry> entries;                 ///< [DrawOrigin::mesh]
  std::vector<std::filesystem::path> files;        ///< every file that was read, the scene's own first
  std::vector<std::filesystem::path> image_files;  ///< [image]
  std::uint64_t length = 0;

  std::uint64_t bytes() const override { return length; }
};

/// The frames of one of a list's textures: an object by name, or an array. The list is one that was read.
inline constexpr const char* textures_key = "textures";
template <class AnyJson>
AnyJson& frames_in(AnyJson& list, std::size_t texture) {
  const auto textures = list.find(textures_key);
  return textures == list.end() ? list.at("frames") : textures->at(texture).at("frames");
}

/// A text's entries and the names of its images, or nullopt with errors that name the frame. Whether the frames lie in
/// their images is not looked at here.
struct FrameList {
  Json json;
  std::vector<FrameEntry> entries;
  std::vector<std::string> images;                     ///< as the list names them
  std::vector<std::optional<glm::ivec2>> image_sizes;  ///< as the list claims
  bool has_polygons = false;                           ///< some frame has vertices
};
std::optional<FrameList> read_frame_list(std::string_view text, const std::string& name, Diagnostics& diagnostics);

}  // namespace foredraw::sprites
