#pragma once
#include <foredraw/scene/shared.h>

#include <cstdint>
#include <optional>
#include <string>

namespace foredraw {

using ImageId = std::uint32_t;

/// What an image's header says of its texels.
struct ImageFacts {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  int channels = 0;  ///< 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA
  int bits = 0;      ///< of a channel, as they are stored
  bool is_float = false;
  friend bool operator==(const ImageFacts&, const ImageFacts&) = default;
};

/// An image as it came: encoded bytes, or a reference to a file beside the scene. Or as a stage made it: texels, which
/// are encoded when somebody writes them.
struct Image {
  std::string name;
  std::string media_type;  ///< "image/png"; empty: unknown
  std::string uri;         ///< where the bytes stay outside of the scene's file; empty: `bytes` holds them
  Shared<std::byte> bytes;
  bool is_texels = false;           ///< the bytes are those of Texels, as the facts say
  std::optional<ImageFacts> facts;  ///< none: of a kind that is not known here, damaged, or not in the file
};

}  // namespace foredraw
