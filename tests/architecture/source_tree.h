#pragma once
// The files of the project, as the rules look at them.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace foredraw::architecture {

/// One for each offence: "plugins/orderers/x/x.cpp:3: what is wrong and what to do".
using Breaches = std::vector<std::string>;

struct SourceFile {
  std::string path;  ///< from the project's root, with '/'
  std::uintmax_t size = 0;
  bool is_link = false;
};

/// Every file below `root`, by name, without what builds leave behind (build folders, node_modules) and .git.
std::vector<SourceFile> source_files(const std::filesystem::path& root);

std::string text_of(const std::filesystem::path& file);
bool is_text(std::string_view content);  ///< holds no zero byte

std::vector<std::string> parts_of(std::string_view path);  ///< "a/b/c.h": a, b, c.h
bool is_cpp(std::string_view path);                        ///< .h or .cpp

}  // namespace foredraw::architecture
