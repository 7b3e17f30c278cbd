#include <foredraw/io/private/mesh_materials.h>

#include <foredraw/io/private/gltf_uri.h>
#include <foredraw/io/private/mesh_text.h>
#include <foredraw/platform/files.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw::mesh_files {

namespace {

namespace fs = std::filesystem;
using gltf::Json;

fs::path utf8_path(const std::string& text) { return fs::path(std::u8string(text.begin(), text.end())); }

/// A path as libraries write it, with either slash, to one that may be opened; empty, with a warning, where it may not.
std::string path_beside(std::string_view written, const char* what, const std::string& told_of, const fs::path& folder,
                        Diagnostics& diagnostics) {
  std::string path(written);
  std::ranges::replace(path, '\\', '/');
  std::string why_not = gltf::why_not_beside(path);
  std::error_code error;
  if (why_not.empty() && (folder.empty() || !fs::is_regular_file(folder / utf8_path(path), error)))
    why_not = "is not there";
  if (why_not.empty() && !gltf::lies_within(folder / utf8_path(path), folder))
    why_not = "leads out of the file's folder";
  if (why_not.empty()) return path;
  diagnostics.warning({.file = told_of}, "left-out",
                      fmt::format("the {} {} {}; it is left out", what, shown(written), why_not));
  return {};
}

class LibraryReader {
 public:
  LibraryReader(const fs::path& folder, Diagnostics& diagnostics) : folder_(folder), diagnostics_(diagnostics) {}

  void read(const std::string& path) {
    const auto bytes = read_file(folder_ / utf8_path(path), diagnostics_);
    if (!bytes) return;
    name_ = path;
    std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    while (!text.empty()) {
      std::string_view rest = take_line(text);
      rest = rest.substr(0, rest.find('#'));
      const std::string_view key = take_token(rest);
      if (key == "newmtl") begin(name_in(rest));
      if (is_open_) line(key, rest);
    }
  }

  MaterialLibrary library;

 private:
  /// The first of several materials of a name is the one that counts.
  void begin(const std::string& name) {
    is_open_ = !name.empty() && std::ranges::none_of(library.materials, [&](auto& m) { return m.name == name; });
    if (!is_open_) return;
    library.materials.push_back({.name = name});
    library.json.push_back({{"name", name}, {"pbrMetallicRoughness", {{"metallicFactor", 0}}}});
    color_ = {1, 1, 1, 1};
  }

  void line(std::string_view key, std::string_view rest) {
    if (key == "Kd") {
      std::array<float, 3> color{};
      for (float& c : color) {
        if (!number(take_token(rest), c)) return;
      }
      std::copy(color.begin(), color.end(), color_.begin());
      put_color();
    } else if (key == "d" || key == "Tr") {
      float value = 0;
      if (!number(take_token(rest), value)) return;
      color_[3] = key == "d" ? value : 1 - value;
      if (color_[3] < 1) blend();
      put_color();
    } else if (key == "map_d") {
      blend();
    } else if (key == "map_Kd") {
      texture(trimmed(rest));
    }
  }

  static bool number(std::string_view token, float& value) {
    if (!read_float(token, value).empty()) return false;
    value = std::clamp(value, 0.0f, 1.0f);
    return true;
  }

  void blend() {
    library.materials.back().alpha_mode = AlphaMode::blend;
    library.json.back()["alphaMode"] = "BLEND";
  }

  void put_color() { library.json.back()["pbrMetallicRoughness"]["baseColorFactor"] = color_; }

  void texture(std::string_view written) {
    if (written.starts_with('-')) written = written.substr(written.find_last_of(" \t") + 1);  // options before the name
    const std::string path = path_beside(written, "texture", name_, folder_, diagnostics_);
    if (path.empty()) return;
    const std::string extension = lower_case(utf8_path(path).extension().string());
    if (extension != ".png" && extension != ".jpg" && extension != ".jpeg") {
      diagnostics_.warning({.file = name_}, "left-out",
                           fmt::format("the texture {} is left out: glTF knows PNG and JPEG", shown(written)));
      return;
    }
    const std::string uri = gltf::percent_encoded(path);
    auto& images = library.images;
    auto found = std::ranges::find_if(images, [&](const Image& image) { return image.uri == uri; });
    if (found == images.end()) found = images.insert(images.end(), {.uri = uri});
    library.json.back()["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", found - images.begin()}};
  }

  const fs::path& folder_;
  Diagnostics& diagnostics_;
  std::string name_;
  bool is_open_ = false;
  std::array<float, 4> color_{1, 1, 1, 1};
};

}  // namespace

MaterialLibrary read_libraries(const std::vector<std::string>& names, const std::string& obj, const fs::path& folder,
                               Diagnostics& diagnostics) {
  LibraryReader reader(folder, diagnostics);
  std::vector<std::string> done;
  for (const std::string& name : names) {
    if (std::ranges::count(done, name) > 0) continue;
    done.push_back(name);
    const std::string path = path_beside(name, "material library", obj, folder, diagnostics);
    if (!path.empty()) reader.read(path);
  }
  return std::move(reader.library);
}

std::shared_ptr<const gltf::Source> gltf_source_of(const Json& materials, const Scene& scene, const fs::path& folder) {
  gltf::Document document;
  document.name = scene.name;
  document.folder = folder;
  document.json = {{"asset", {{"version", "2.0"}, {"generator", "foredraw"}}}};
  for (const Json& material : materials) document.json["materials"].push_back(material);
  for (std::size_t i = materials.size(); i < scene.materials.size(); ++i) {
    document.json["materials"].push_back({{"name", scene.materials[i].name}});
  }
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    document.json["textures"].push_back({{"source", i}});
    document.json["images"].push_back({{"uri", scene.images[i].uri}});
  }
  Scene as_read;
  as_read.materials = scene.materials;
  as_read.images = scene.images;
  return std::make_shared<const gltf::Source>(std::move(document), std::move(as_read));
}

}  // namespace foredraw::mesh_files
