#pragma once
#include <foredraw/scene/shared.h>

#include <cstdint>
#include <string>

namespace foredraw {

using ImageId = std::uint32_t;

/// An image as it came: encoded bytes, or a reference to a file beside the scene.
struct Image {
  std::string name;
  std::string media_type;     ///< "image/png"; empty: unknown
  std::string uri;            ///< where the bytes stay outside of the scene's file; empty: `bytes` holds them
  Shared<std::byte> bytes;
};

}  // namespace foredraw
