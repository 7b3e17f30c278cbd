#include <foredraw/io/text/private/file_beside.h>

#include <foredraw/io/text/private/uri.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view leads_out = "leads out of the file's folder";

bool climbs(std::string_view path) {
  for (std::size_t from = 0; from <= path.size();) {
    const std::size_t to = std::min(path.find('/', from), path.size());
    if (path.substr(from, to - from) == "..") return true;
    from = to + 1;
  }
  return false;
}

/// Whatever may lie there.
std::string_view why_no_path(std::string_view path) {
  if (path.empty()) return "is empty";
  if (path.find('\0') != std::string_view::npos) return "holds a zero byte";
  if (path.front() == '/') return "is an absolute path";
  if (path.find('\\') != std::string_view::npos) return "holds a backslash";
  const std::size_t colon = path.find(':');
  if (colon != std::string_view::npos && path.substr(0, colon).find('/') == std::string_view::npos) {
    return "has a scheme or drive of its own";
  }
  return {};
}

bool lies_within(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  const auto whole = fs::canonical(file, error);
  if (error) return false;
  const auto root = fs::canonical(folder, error);
  if (error) return false;
  const auto [root_end, at] = std::mismatch(root.begin(), root.end(), whole.begin(), whole.end());
  return root_end == root.end() && at != whole.end();
}

FileBeside refused(std::string_view why_not) {
  return {{}, std::string(why_not), "put the file beside the one that names it, and name it by a relative path"};
}

FileBeside outside(const fs::path& root) {
  if (root.empty()) return {{}, std::string(leads_out), "allow it with --root FOLDER, a folder that holds both"};
  return {{},
          fmt::format("leads out of '{}'", root.string()),
          "copy the file into that folder, or allow a larger one with --root FOLDER"};
}

}  // namespace

fs::path utf8_path(std::string_view text) { return fs::path(std::u8string(text.begin(), text.end())); }

FileBeside file_beside(std::string_view name, const FilePlaces& where) {
  if (const std::string_view why = why_no_path(name); !why.empty()) return refused(why);
  if (climbs(name) && where.root.empty()) return outside({});
  if (where.folder.empty()) {
    return {{}, "cannot be found: the file that names it has no folder", "give that file by its path", true};
  }
  fs::path path = where.folder / utf8_path(name);
  std::error_code error;
  const bool is_there = fs::is_regular_file(path, error);
  if (where.files) is_there ? where.files->there(path) : where.files->missing(path);
  if (!is_there) {
    return {{}, "is missing", "copy it there; the path counts from the folder of the file that names it", true};
  }
  if (!lies_within(path, where.root.empty() ? where.folder : where.root)) return outside(where.root);
  return {std::move(path), {}};
}

FileBeside uri_beside(std::string_view uri, const FilePlaces& where) {
  const auto name = gltf::percent_decoded(uri);
  return name ? file_beside(*name, where) : refused("is not well-formed");
}

}  // namespace foredraw
