#include "refusals.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace foredraw::import {

namespace {

/// "FBX 6.1" of 6100.
std::string version_of_fbx(unsigned long number) {
  return "FBX " + std::to_string(number / 1000) + '.' + std::to_string(number / 100 % 10);
}

std::optional<std::string> reason_in_fbx(const std::string& begin) {
  constexpr std::string_view mark = "Kaydara FBX Binary  ";
  constexpr std::string_view key = "FBXVersion:";
  constexpr std::size_t place = 23;  // of the version, in 32 bits from the lowest byte on
  unsigned long version = 0;
  if (begin.starts_with(mark)) {
    if (begin.size() < place + 4) return "it ends within its first line";
    for (std::size_t i = 4; i-- > 0;) version = version << 8 | static_cast<unsigned char>(begin[place + i]);
  } else if (const auto at = begin.find(key); at != std::string::npos) {
    version = std::strtoul(begin.c_str() + at + key.size(), nullptr, 10);
  } else if (!begin.starts_with(';') && begin.find("FBX") == std::string::npos) {
    return "it does not begin as FBX files do";
  }
  if (version == 0 || version >= 7100) return std::nullopt;
  return "it is " + version_of_fbx(version) + ", and FBX is read from 7.1 (2011) on";
}

std::optional<std::string> reason_in_blend(const std::string& begin) {
  if (begin.starts_with("\x28\xb5\x2f\xfd")) return "Blender 3.0 or newer saved it, and .blend is read up to 2.79";
  if (begin.starts_with("\x1f\x8b")) return std::nullopt;  // packed, by any version
  if (!begin.starts_with("BLENDER")) return "it does not begin as .blend files do";
  if (begin.size() < 12) return "it ends within its first line";
  const std::string version = begin.substr(9, 3);
  if (!std::ranges::all_of(version, [](char c) { return c >= '0' && c <= '9'; }) || version <= "279") {
    return std::nullopt;
  }
  return "Blender " + version.substr(0, 1) + '.' + version.substr(1) + " saved it, and .blend is read up to 2.79";
}

}  // namespace

std::optional<std::string> reason_in(const std::filesystem::path& file) {
  std::ifstream from(file, std::ios::binary);
  std::string begin(4096, '\0');
  from.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(from.gcount()));
  if (begin.empty()) return "it is empty";
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (extension == ".fbx") return reason_in_fbx(begin);
  if (extension == ".blend") return reason_in_blend(begin);
  return std::nullopt;
}

std::string plain_words(const std::string& assimps) {
  if (assimps.empty()) return "it holds no scene";
  if (assimps.find("mNumMeshes is 0") != std::string::npos) return "it holds no meshes";
  return assimps;
}

}  // namespace foredraw::import
