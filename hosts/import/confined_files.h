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

  /// Where a file that the scene names lies: by its path from the scene's folder, or, as paths of other machines lead
  /// nowhere, by its name alone in that folder. Empty: it is not there, or not where it may be read.
  std::filesystem::path found(const std::string& named) const;
  std::string content(const std::filesystem::path& file) const;

 private:
  bool may_read(const std::filesystem::path& file) const;

  std::filesystem::path scene_;
  std::filesystem::path folder_;
  std::filesystem::path root_;
  Told& told_;
};

}  // namespace foredraw::import
