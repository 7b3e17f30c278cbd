#pragma once
// Which scenes have to be made again when a file changes.

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace foredraw::cli {

/// Paths are absolute and without "..", so that each file has one name.
class Dependants {
 public:
  /// What the scene was made from, or would have been if it were there, takes the place of what was told before. It
  /// depends on itself anyway.
  void set(const std::string& scene, const std::vector<std::string>& files);
  void forget(const std::string& scene);

  bool knows(const std::string& scene) const { return files_.contains(scene); }
  std::size_t size() const { return files_.size(); }
  /// Which files the scene depends on; it has to be known.
  const std::vector<std::string>& files_of(const std::string& scene) const { return files_.at(scene); }
  /// Which scenes depend on the file.
  const std::set<std::string>& of(const std::string& file) const;
  /// Every file that a scene depends on, in the folder and those below it.
  std::vector<std::string> below(const std::string& folder) const;

 private:
  std::map<std::string, std::vector<std::string>> files_;
  std::map<std::string, std::set<std::string>> scenes_;
};

/// As Dependants wants it.
std::string one_name(const std::filesystem::path& path);

}  // namespace foredraw::cli
