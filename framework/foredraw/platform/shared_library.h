#pragma once
#include <filesystem>
#include <string>

namespace foredraw {

/// A shared library with all that it asks for, loaded for as long as the process lives: what it began can not be
/// undone. Throws std::runtime_error with the system's words.
class LoadedLibrary {
 public:
  explicit LoadedLibrary(const std::filesystem::path& path);

  /// NULL where it shows no such function.
  template <class Function>
  Function* function(const std::string& name) const {
    return reinterpret_cast<Function*>(symbol(name));
  }

 private:
  void* symbol(const std::string& name) const;

  void* handle_;
};

/// Where this code lies: the folder of the library or program that holds it, and that of the program that runs.
std::filesystem::path own_folder();
std::filesystem::path program_folder();

}  // namespace foredraw
