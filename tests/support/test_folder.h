#pragma once
// A folder on the disk for one test.

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cerrno>
#include <filesystem>
#include <string>
#include <system_error>

namespace foredraw::testing {

/// Named after the test that runs; empty at first, and gone at last with all that it holds. No other test has it, nor
/// has the same test of another run that goes on at this time.
class TestFolder {
 public:
  TestFolder() {
    std::string path = std::filesystem::path(::testing::TempDir()) / ("foredraw-" + name_of_test() + ".XXXXXX");
    if (::mkdtemp(path.data()) == nullptr) throw std::system_error(errno, std::generic_category(), path);
    path_ = path;
  }
  ~TestFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  static std::string name_of_test() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(test->test_suite_name()) + '-' + test->name();
    for (char& c : name) c = c == '/' ? '-' : c;
    return name;
  }

  std::filesystem::path path_;
};

}  // namespace foredraw::testing
