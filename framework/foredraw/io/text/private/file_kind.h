#pragma once
// Kinds of files, told by their names. Private to io.

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace foredraw {

/// The extension in small letters: ".glb" of "Rock.GLB".
inline std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension;
}

}  // namespace foredraw
