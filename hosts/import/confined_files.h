#pragma once
// The files that a scene may read: those below its own folder, or below a root.

#include "told.h"

#include <assimp/DefaultIOSystem.h>

#include <filesystem>

namespace foredraw::import {

class ConfinedFiles final : public Assimp::DefaultIOSystem {
 public:
  ConfinedFiles(const std::filesystem::path& scene, const std::filesystem::path& root, Told& told);

  bool Exists(const char* file) const override;
  Assimp::IOStream* Open(const char* file, const char* mode) override;

  struct Found {
    std::filesystem::path file;  ///< empty: it is not there, or not where it may be read
    bool is_outside = false;     ///< it is there, outside of what may be read
  };
  /// Where a file that the scene names lies: by its path from the scene's folder, or, as paths of other machines lead
  /// nowhere, by the end of it: "C:\art\maps\leaf.png" is found as "maps/leaf.png" and as "leaf.png". Where no name is
  /// the same, one is found that differs in capitals alone, as systems that know no difference take it.
  Found found(const std::string& named) const;
  std::string content(const std::filesystem::path& file) const;

 private:
  std::filesystem::path in_other_capitals(const std::filesystem::path& path) const;
  bool may_read(const std::filesystem::path& file) const;

  std::filesystem::path scene_;
  std::filesystem::path folder_;
  std::filesystem::path root_;
  Told& told_;
};

}  // namespace foredraw::import
