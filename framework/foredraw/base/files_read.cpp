#include <foredraw/base/files_read.h>

#include <algorithm>
#include <tuple>

namespace foredraw {

namespace {

auto key_of(const FileRead& file) {
  return std::tie(file.path.native(), file.found, file.at_most, file.bytes, file.stamp);
}

}  // namespace

void FilesRead::read(const std::filesystem::path& path, std::uint64_t at_most, std::span<const std::byte> bytes) {
  add({path, FileRead::Found::content, at_most, bytes.size(), content_hash(bytes)});
}

void FilesRead::there(const std::filesystem::path& path) { add({path, FileRead::Found::there, 0, 0, {}}); }

void FilesRead::missing(const std::filesystem::path& path) { add({path, FileRead::Found::missing, 0, 0, {}}); }

std::vector<FileRead> FilesRead::all() const {
  const std::lock_guard lock(mutex_);
  std::vector<FileRead> sorted = files_;
  std::ranges::sort(sorted, [](const FileRead& a, const FileRead& b) { return key_of(a) < key_of(b); });
  std::vector<FileRead> each;
  for (FileRead& file : sorted) {
    const bool is_again = !each.empty() && each.back().path.native() == file.path.native() &&
                          (file.found == FileRead::Found::there || key_of(each.back()) == key_of(file));
    if (!is_again) each.push_back(std::move(file));
  }
  return each;
}

void FilesRead::add(FileRead file) {
  const std::lock_guard lock(mutex_);
  files_.push_back(std::move(file));
}

}  // namespace foredraw
