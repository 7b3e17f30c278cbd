#pragma once
// The files that a file names by paths: which of them may be opened, and where they lie. Private to io.

#include <foredraw/base/files_read.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace foredraw {

/// Where the files may lie that a file names.
struct FilePlaces {
  std::filesystem::path folder;     ///< of the file that names them; empty: it was not read from a folder
  std::filesystem::path root = {};  ///< a path with `..` may lead to anywhere below it; empty: it must not have any
  std::shared_ptr<FilesRead> files = nullptr;  ///< who is told of what is looked for
};

/// A file that is there and may be opened, or why not.
struct FileBeside {
  std::filesystem::path path;
  std::string why_not;      ///< "is missing"; empty where it may be opened
  std::string hint = {};    ///< what to do then
  bool is_missing = false;  ///< it could be opened if it were there
};

/// By a relative path in UTF-8, with slashes. All symbolic links followed, the file lies in the folder or below, or in
/// the root.
FileBeside file_beside(std::string_view name, const FilePlaces& where);

/// By a path as a URI writes it.
FileBeside uri_beside(std::string_view uri, const FilePlaces& where);

/// A path in UTF-8, on any system.
std::filesystem::path utf8_path(std::string_view text);

}  // namespace foredraw
