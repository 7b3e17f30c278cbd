#include "source_tree.h"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace foredraw::architecture {

namespace {

bool is_left_by_builds(const std::string& folder) {
  return folder == ".git" || folder == ".cache" || folder == "node_modules" || folder == "build" ||
         folder.starts_with("build-");
}

}  // namespace

std::vector<SourceFile> source_files(const std::filesystem::path& root) {
  std::vector<SourceFile> files;
  for (auto entry = std::filesystem::recursive_directory_iterator(root); entry != end(entry); ++entry) {
    const std::string name = entry->path().filename().string();
    if (entry->is_directory()) {
      if (is_left_by_builds(name)) entry.disable_recursion_pending();
      continue;
    }
    if (name == ".git") continue;  // a file, where the tree is one of several of one repository
    const bool is_link = entry->is_symlink();
    files.push_back(
        {entry->path().lexically_relative(root).generic_string(), is_link ? 0 : entry->file_size(), is_link});
  }
  std::sort(files.begin(), files.end(), [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool is_text(std::string_view content) { return content.find('\0') == std::string_view::npos; }

std::vector<std::string> parts_of(std::string_view path) {
  std::vector<std::string> parts;
  for (const auto& part : std::filesystem::path(path)) parts.push_back(part.string());
  return parts;
}

bool is_cpp(std::string_view path) { return path.ends_with(".h") || path.ends_with(".cpp"); }

}  // namespace foredraw::architecture
