#include <foredraw/io/side_files.h>

#include <foredraw/io/text/extension_text.h>
#include <foredraw/io/text/private/file_kind.h>

#include <algorithm>

namespace foredraw {

namespace {

struct BytesOf {
  int indent;
  std::vector<std::byte> operator()(std::vector<std::byte> bytes) const { return bytes; }
  std::vector<std::byte> operator()(const std::string& text) const {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
  }
  std::vector<std::byte> operator()(const ExtensionValue& value) const {
    return (*this)(json_text(value, indent) + '\n');
  }
};

}  // namespace

std::optional<SideFileKind> side_file_kind(const ProductRow& row, const std::filesystem::path& path) {
  for (const SideFileKind& kind : row.card().side_files) {
    if (kind.extension == lower_extension(path)) return kind;
  }
  return std::nullopt;
}

std::vector<std::filesystem::path> paths_of_side_file(const ProductRow& row, const std::filesystem::path& path) {
  std::vector<std::filesystem::path> paths{path};
  const auto kind = side_file_kind(row, path);
  if (kind && !kind->beside.empty()) (paths.emplace_back(path)) += kind->beside;
  return paths;
}

std::optional<std::vector<OutputFile>> encode_side_file(const Scene& scene, const ProductRow& row,
                                                        const std::filesystem::path& path, Diagnostics& diagnostics) {
  const ProductCard& card = row.card();
  if (!scene.products.has(card.name)) {
    diagnostics.error({.file = path.string()}, "nothing-made",
                      "cannot be written: " + scene.name + " has no " + card.title,
                      "add a stage that makes them; if one ran, its notes say why it made none");
    return std::nullopt;
  }
  const auto paths = paths_of_side_file(row, path);
  try {
    const std::u8string beside = paths.back().filename().u8string();
    SideFile file = row.side_file(scene, lower_extension(path), std::string(beside.begin(), beside.end()));
    std::vector<OutputFile> files{{path, std::visit(BytesOf{file.indent}, std::move(file.content))}};
    if (paths.size() > 1) files.push_back({paths.back(), std::move(file.beside)});
    return files;
  } catch (const Refusal& refusal) {
    diagnostics.error({.file = path.string()}, refusal.code, refusal.what(), refusal.hint);
    return std::nullopt;
  }
}

}  // namespace foredraw
