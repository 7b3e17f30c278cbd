#include <foredraw/io/gltf/private/material_stamps.h>
#include <foredraw/io/mesh/private/materials.h>

#include <foredraw/io/mesh/private/obj.h>
#include <foredraw/io/mesh/private/text.h>
#include <foredraw/io/text/private/file_kind.h>
#include <foredraw/io/text/private/uri.h>
#include <foredraw/platform/files.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace foredraw::mesh_files {

namespace {

namespace fs = std::filesystem;

/// Not by a list in braces, which leaks where memory runs out, nor by a member of null, which can not be freed then.
Json object_of(const char* key, Json value) {
  Json object = Json::object();
  object[key] = std::move(value);
  return object;
}

/// A path as libraries write it, with either slash, to one that may be opened; empty, with a fault, where it may not.
std::string path_beside(std::string_view written, const char* what, const Where& told_at, const FilePlaces& where,
                        Faults& faults) {
  std::string path(written);
  std::ranges::replace(path, '\\', '/');
  const FileBeside beside = file_beside(path, where);
  if (beside.why_not.empty()) return path;
  faults.found("missing-file", told_at, fmt::format("the {} {} {}", what, shown(written), beside.why_not));
  return {};
}

class LibraryReader {
 public:
  LibraryReader(const FilePlaces& where, Faults& faults, Diagnostics& diagnostics)
      : where_(where), faults_(faults), diagnostics_(diagnostics) {}

  void read(const std::string& path) {
    const auto bytes =
        read_file(where_.folder / utf8_path(path), diagnostics_, FileRead::all_of_it, where_.files.get());
    if (!bytes) return;
    name_ = path;
    std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    text = without_mark(text);
    while (!text.empty()) {
      std::string_view rest = take_line(text);
      const std::string_view key = take_token(rest);
      if (key == "newmtl") begin(obj_name(rest));
      if (is_open_) line(key, rest.substr(0, comment_in(rest)));
    }
  }

  MaterialLibrary library;

 private:
  /// The first of several materials of a name is the one that counts.
  void begin(const std::string& name) {
    is_open_ = !name.empty() && names_.insert(name).second;
    if (!is_open_) return;
    library.materials.push_back({.name = name});
    Json& json = library.json.emplace_back(object_of("name", name));
    json["pbrMetallicRoughness"] = object_of("metallicFactor", 0);
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
    const std::string path = path_beside(written, "texture", {.file = name_}, where_, faults_);
    if (path.empty()) return;
    const std::string extension = lower_extension(utf8_path(path));
    if (extension != ".png" && extension != ".jpg" && extension != ".jpeg") {
      diagnostics_.warning({.file = name_}, "left-out",
                           fmt::format("the texture {} is left out: glTF supports only PNG and JPEG", shown(written)));
      return;
    }
    const std::string uri = gltf::percent_encoded(path);
    const auto [found, is_new] = image_numbers_.try_emplace(uri, library.images.size());
    if (is_new) library.images.push_back({.uri = uri});
    library.json.back()["pbrMetallicRoughness"]["baseColorTexture"] = object_of("index", found->second);
  }

  const FilePlaces& where_;
  Faults& faults_;
  Diagnostics& diagnostics_;
  std::string name_;
  std::set<std::string> names_;
  std::map<std::string, std::size_t> image_numbers_;  // by URI
  bool is_open_ = false;
  std::array<float, 4> color_{1, 1, 1, 1};
};

/// A line may name several libraries, and a name may hold spaces: the whole is one where there is such a file.
std::vector<std::string> names_on(const std::string& line, const FilePlaces& where) {
  std::string_view rest = std::string_view(line).substr(0, comment_in(line));
  for (const std::string& whole : {line, std::string(trimmed(rest))}) {
    if (file_beside(whole, where).why_not.empty()) return {whole};
  }
  std::vector<std::string> names;
  for (std::string_view name = take_token(rest); !name.empty(); name = take_token(rest)) names.emplace_back(name);
  return names;
}

void find_unknown(std::span<const Material> materials, const std::string& obj, Faults& faults) {
  for (const Material& material : materials) {
    if (faults.found_again("unknown-material")) continue;
    faults.found("unknown-material", {.file = obj},
                 fmt::format("{} is in none of the material libraries that were read", shown(material.name)));
  }
}

/// glTF allows a texture only where there are coordinates for it: draws without any get the material without it.
void part_from_textures(Json& materials, Scene& scene) {
  std::map<MaterialId, MaterialId> without;
  for (Draw& draw : scene.draws) {
    if (!draw.material || draw.traits.has(traits::uv0)) continue;
    const MaterialId textured = *draw.material;
    if (!materials[textured].contains("pbrMetallicRoughness") ||
        !materials[textured]["pbrMetallicRoughness"].contains("baseColorTexture")) {
      continue;
    }
    const auto [found, is_new] = without.try_emplace(textured, static_cast<MaterialId>(materials.size()));
    draw.material = found->second;
    if (!is_new) continue;
    Json plain = materials[textured];
    plain["pbrMetallicRoughness"].erase("baseColorTexture");
    materials.push_back(std::move(plain));
    const Material same = scene.materials[textured];
    scene.materials.push_back(same);
  }
}

}  // namespace

MaterialLibrary read_libraries(const std::vector<std::string>& names, const std::string& obj, const FilePlaces& where,
                               Faults& faults, Diagnostics& diagnostics) {
  LibraryReader reader(where, faults, diagnostics);
  std::set<std::string> done;
  for (const std::string& line : names) {
    for (const std::string& name : names_on(line, where)) {
      if (!done.insert(name).second) continue;
      const std::string path = path_beside(name, "material library", {.file = obj}, where, faults);
      if (!path.empty()) reader.read(path);
    }
  }
  return std::move(reader.library);
}

std::shared_ptr<const gltf::Source> gltf_source_of(Json materials, Scene& scene, const fs::path& folder,
                                                   Faults& faults) {
  find_unknown(std::span(scene.materials).subspan(materials.size()), scene.name, faults);
  for (std::size_t i = materials.size(); i < scene.materials.size(); ++i) {
    materials.push_back(object_of("name", scene.materials[i].name));
  }
  part_from_textures(materials, scene);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) gltf::add_stamps(scene.materials[i], materials[i]);
  gltf::Document document;
  document.name = scene.name;
  document.folder = folder;
  document.json = object_of("asset", object_of("version", "2.0"));
  document.json["asset"]["generator"] = "foredraw";
  if (!materials.empty()) document.json["materials"] = std::move(materials);
  if (!scene.images.empty()) document.json["textures"] = Json::array(), document.json["images"] = Json::array();
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    document.json["textures"].push_back(object_of("source", i));
    document.json["images"].push_back(object_of("uri", scene.images[i].uri));
  }
  Scene as_read;
  as_read.materials = scene.materials;
  as_read.images = scene.images;
  return std::make_shared<const gltf::Source>(std::move(document), std::move(as_read));
}

}  // namespace foredraw::mesh_files
