#include "confined_files.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace foredraw::import {

namespace fs = std::filesystem;

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

fs::path ConfinedFiles::found(const std::string& named) const {
  std::string path = named;
  std::ranges::replace(path, '\\', '/');
  std::error_code error;
  for (const fs::path& file : {folder_ / path, folder_ / fs::path(path).filename()}) {
    if (!may_read(file)) continue;
    if (fs::is_regular_file(file, error)) {
      told_.read.insert(file.string());
      return file;
    }
    told_.missing.insert(file.string());
  }
  return {};
}

std::string ConfinedFiles::content(const fs::path& file) const {
  std::ifstream from(file, std::ios::binary);
  std::ostringstream text;
  text << from.rdbuf();
  return text.str();
}

}  // namespace foredraw::import
