#include "dependants.h"

namespace foredraw::cli {

void Dependants::set(const std::string& scene, const std::vector<std::string>& files) {
  forget(scene);
  std::vector<std::string>& own = files_[scene];
  own = files;
  own.push_back(scene);
  for (const std::string& file : own) scenes_[file].insert(scene);
}

void Dependants::forget(const std::string& scene) {
  const auto known = files_.find(scene);
  if (known == files_.end()) return;
  for (const std::string& file : known->second) {
    const auto at = scenes_.find(file);
    if (at == scenes_.end()) continue;  // it was named twice
    at->second.erase(scene);
    if (at->second.empty()) scenes_.erase(at);
  }
  files_.erase(known);
}

const std::set<std::string>& Dependants::of(const std::string& file) const {
  static const std::set<std::string> none;
  const auto at = scenes_.find(file);
  return at == scenes_.end() ? none : at->second;
}

std::vector<std::string> Dependants::below(const std::string& folder) const {
  const std::string begin = folder + '/';
  std::vector<std::string> files;
  for (auto at = scenes_.lower_bound(begin); at != scenes_.end() && at->first.starts_with(begin); ++at) {
    files.push_back(at->first);
  }
  return files;
}

std::string one_name(const std::filesystem::path& path) {
  std::error_code error;
  std::string name = std::filesystem::absolute(path, error).lexically_normal().string();
  while (name.size() > 1 && name.ends_with('/')) name.pop_back();
  return name;
}

}  // namespace foredraw::cli
