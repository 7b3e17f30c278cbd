#pragma once
// Files of rows in this folder, each row a name and what is expected under it: where a change is meant,
// FOREDRAW_UPDATE_GOLDEN=1 writes them anew; read the difference before it is committed.

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

namespace foredraw::testing {

class GoldenRows {
 public:
  /// `heading` is the text above the rows; each of its lines begins with '#'.
  GoldenRows(const std::string& file, std::string heading)
      : file_(project_file("tests/golden/" + file)), heading_(std::move(heading)) {
    std::ifstream stream(file_);
    for (std::string line; std::getline(stream, line);) {
      const std::size_t tab = line.find('\t');
      if (tab != std::string::npos && line[0] != '#') rows_[line.substr(0, tab)] = line.substr(tab + 1);
    }
  }

  /// An update rewrites the whole file, so no other test may have it in hand: see CMakeLists.txt.
  void expect(const std::string& name, const std::string& row) {
    if (std::getenv("FOREDRAW_UPDATE_GOLDEN") != nullptr) {
      rows_[name] = row;
      std::ofstream stream(file_);
      stream << heading_;
      for (const auto& [key, value] : rows_) stream << key << '\t' << value << '\n';
    }
    EXPECT_EQ(rows_[name], row) << "if this change is meant: FOREDRAW_UPDATE_GOLDEN=1";
  }

 private:
  std::filesystem::path file_;
  std::string heading_;
  std::map<std::string, std::string> rows_;
};

}  // namespace foredraw::testing
