#pragma once
// Scenes and images for options that name them, read through the same gate as all others.

#include <foredraw/io/reading/scene_input.h>
#include <foredraw/scene/lender.h>

#include <mutex>

namespace foredraw {

/// Reads each file once, and keeps it: for one run of a program, in which files do not change.
class FileLender final : public Lender {
 public:
  explicit FileLender(SceneInput how = {}) : how_(std::move(how)) {}

  std::optional<Loan<Scene>> scene(const std::string& path, Diagnostics& diagnostics) const override;
  std::optional<Loan<Image>> image(const std::string& path, Diagnostics& diagnostics) const override;

 private:
  SceneInput how_;
  mutable std::mutex mutex_;
  mutable Loans read_;
};

}  // namespace foredraw
