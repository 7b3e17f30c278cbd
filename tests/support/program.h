#pragma once
// The program, run in a folder of its own as its users run it.

#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace foredraw::testing {

inline std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline void put(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// AddressSanitizer keeps terabytes mapped, and ends a program that gets no memory: no limit can be set below it.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool is_sanitized = true;
#elif defined(__has_feature)
inline constexpr bool is_sanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
inline constexpr bool is_sanitized = false;
#endif

/// A test with a folder that is empty at first and gone at last.
class InFolder : public ::testing::Test {
 private:
  TestFolder own_;

 protected:
  /// Sorted.
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
      names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }

  const std::filesystem::path folder_ = own_.path();
};

struct Ended {
  int code = 0;
  std::string out;
  std::string err;
};

#ifdef FOREDRAW_PROGRAM
/// Runs `foredraw arguments` in the folder, with a shell's quoting and redirections; `before` goes before the command:
/// "ulimit -v 1000;".
inline Ended run_program(const std::filesystem::path& folder, const std::string& arguments,
                         const std::string& before = {}) {
  const std::filesystem::path streams = folder.string() + ".streams";
  std::filesystem::create_directories(streams);
  const std::string command = "(cd '" + folder.string() + "' && " + before + " '" FOREDRAW_PROGRAM "' " + arguments +
                              ") >'" + (streams / "out").string() + "' 2>'" + (streams / "err").string() +
                              "' </dev/null";
  const int status = std::system(command.c_str());
  Ended ended{WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(streams / "out"), content(streams / "err")};
  std::filesystem::remove_all(streams);
  return ended;
}
#endif

}  // namespace foredraw::testing
