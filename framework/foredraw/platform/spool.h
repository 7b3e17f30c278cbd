#pragma once
// Texts put aside in a file that has no name, and that goes with the process however that ends.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace foredraw {

/// Any number of threads may put and get at once.
class Spool {
 public:
  /// In the folder, or where temporary files go. Throws std::runtime_error where no file can be made there.
  explicit Spool(const std::filesystem::path& folder = {});
  ~Spool();

  struct Place {
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
  };

  /// Throws std::runtime_error where the disk is full.
  Place put(std::string_view text);
  std::string get(const Place& place) const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace foredraw
