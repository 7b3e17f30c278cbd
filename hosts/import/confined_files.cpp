#include "confined_files.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <vector>

namespace foredraw::import {

namespace fs = std::filesystem;

namespace {

std::string in_small_letters(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

/// Of other systems and programs, too: "C:\\art\\leaf.png"; "//leaf.png", as Blender begins where the scene lies; and
/// of "leaf.png""http://a.net/leaf.png", as X3D lists places, the first.
fs::path from_folder(std::string named) {
  named.erase(std::min(named.find("\"\""), named.size()));
  std::ranges::replace(named, '\\', '/');
  if (named.starts_with("//")) named.erase(0, 2);
  return named;
}

/// A path and its ends: "C:/art/leaf.png", "art/leaf.png", "leaf.png". Of a long one, the shortest.
std::vector<fs::path> ends_of(const fs::path& path) {
  constexpr std::size_t most = 10;
  const std::vector<fs::path> parts(path.begin(), path.end());
  std::vector<fs::path> ends{path};
  for (std::size_t first = std::max<std::size_t>(parts.size(), most + 1) - most; first < parts.size(); ++first) {
    fs::path end;
    for (std::size_t i = first; i < parts.size(); ++i) end /= parts[i];
    ends.push_back(std::move(end));
  }
  return ends;
}

}  // namespace

ConfinedFiles::ConfinedFiles(const fs::path& scene, const fs::path& root, Told& told)
    : scene_(fs::weakly_canonical(scene)),
      folder_(fs::absolute(scene).parent_path()),
      root_(fs::weakly_canonical(root.empty() ? folder_ : root)),
      told_(told) {}

bool ConfinedFiles::may_read(const fs::path& file) const {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(file, error);
  if (error) return false;
  if (real == scene_) return true;
  const fs::path own = fs::weakly_canonical(folder_, error);
  for (const fs::path& top : {own, root_}) {
    const fs::path from_top = real.lexically_relative(top);
    if (!from_top.empty() && *from_top.begin() != "..") return true;
  }
  return false;
}

bool ConfinedFiles::Exists(const char* file) const {
  std::error_code error;
  const bool is_there = may_read(file) && fs::is_regular_file(file, error);
  if (!is_there && may_read(file)) told_.missing.insert(file);
  return is_there;
}

Assimp::IOStream* ConfinedFiles::Open(const char* file, const char* mode) {
  if (mode == nullptr || *mode != 'r' || !Exists(file)) return nullptr;
  std::error_code error;
  if (fs::weakly_canonical(file, error) != scene_) told_.read.insert(file);
  return DefaultIOSystem::Open(file, mode);
}

/// As the path says from the scene's folder on, but for capitals of names; empty: there is none.
fs::path ConfinedFiles::in_other_capitals(const fs::path& path) const {
  std::error_code error;
  fs::path at = folder_;
  for (const fs::path& part : path) {
    fs::path next = at / part;
    if (!fs::exists(next, error)) {
      next.clear();
      for (fs::directory_iterator one(at, error), end; !error && one != end; one.increment(error)) {
        const bool is_same = in_small_letters(one->path().filename().string()) == in_small_letters(part.string());
        if (is_same && (next.empty() || one->path() < next)) next = one->path();
      }
    }
    if (next.empty()) return {};
    at = std::move(next);
  }
  return at;
}

ConfinedFiles::Found ConfinedFiles::found(const std::string& named) const {
  Found found;
  const auto is_there = [&](const fs::path& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return false;
    if (may_read(file)) {
      told_.read.insert(file.string());
      found = {file, false};
      return true;
    }
    found.is_outside = true;
    return false;
  };
  if (named.empty()) return found;
  for (const fs::path& path : ends_of(from_folder(named))) {
    const fs::path file = folder_ / path;
    if (is_there(file)) return found;
    if (!may_read(file)) continue;
    if (const fs::path other = in_other_capitals(path); !other.empty() && is_there(other)) return found;
    told_.missing.insert(file.string());
  }
  return found;
}

std::string ConfinedFiles::content(const fs::path& file) const {
  std::ifstream from(file, std::ios::binary);
  std::ostringstream text;
  text << from.rdbuf();
  return text.str();
}

}  // namespace foredraw::import
