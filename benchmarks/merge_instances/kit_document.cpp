#include "kit_document.h"

#include <foredraw/base/content_hash.h>
#include <foredraw/platform/files.h>

#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>

namespace foredraw::bench {

namespace {

namespace fs = std::filesystem;
using Json = KitDocument::Json;
using Bytes = std::vector<std::byte>;

Bytes contents(const fs::path& path) {
  Diagnostics diagnostics;
  auto bytes = read_file(path, diagnostics);
  if (!bytes) throw std::runtime_error(to_text(diagnostics));
  return std::move(*bytes);
}

std::uint32_t word_at(const Bytes& bytes, std::size_t offset) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, 4);
  return word;
}

void put_word(Bytes& to, std::size_t word) {
  const auto value = static_cast<std::uint32_t>(word);
  to.resize(to.size() + 4);
  std::memcpy(to.data() + to.size() - 4, &value, 4);
}

void put_chunk(Bytes& to, std::span<const std::byte> bytes, const char* type, char filler) {
  put_word(to, (bytes.size() + 3) / 4 * 4);
  for (int i = 0; i < 4; ++i) to.push_back(static_cast<std::byte>(type[i]));
  to.insert(to.end(), bytes.begin(), bytes.end());
  while (to.size() % 4 != 0) to.push_back(static_cast<std::byte>(filler));
}

/// A file taken apart; it has one buffer.
struct Opened {
  Json json;
  Bytes buffer;
};

Opened opened(const fs::path& file) {
  const Bytes bytes = contents(file);
  const char* text = reinterpret_cast<const char*>(bytes.data());
  if (file.extension() == ".glb") {
    if (bytes.size() < 20) throw std::runtime_error(file.string() + ": it is too short for a .glb");
    const std::size_t end = 20 + std::size_t{word_at(bytes, 12)};
    if (bytes.size() < end + 8) throw std::runtime_error(file.string() + ": it has no buffer");
    return {Json::parse(text + 20, text + end),
            Bytes(bytes.begin() + static_cast<std::ptrdiff_t>(end) + 8, bytes.end())};
  }
  Json json = Json::parse(text, text + bytes.size());
  Bytes buffer = contents(file.parent_path() / json.at("buffers").at(0).at("uri").get<std::string>());
  return {std::move(json), std::move(buffer)};
}

std::string without_name(Json value) {
  if (value.is_object()) value.erase("name");
  return value.dump();
}

}  // namespace

std::size_t KitDocument::add_view(std::span<const std::byte> bytes, const Json& like) {
  bin_.resize((bin_.size() + 3) / 4 * 4);
  Json view{{"buffer", 0}, {"byteOffset", bin_.size()}, {"byteLength", bytes.size()}};
  for (const char* key : {"byteStride", "target"}) {
    if (like.contains(key)) view[key] = like[key];
  }
  bin_.insert(bin_.end(), bytes.begin(), bytes.end());
  json_["bufferViews"].push_back(std::move(view));
  return json_["bufferViews"].size() - 1;
}

std::size_t KitDocument::add_once(const char* kind, const Json& value) {
  const auto [known, is_new] = once_.try_emplace(kind + without_name(value), json_[kind].size());
  if (is_new) json_[kind].push_back(value);
  return known->second;
}

/// What one file brings. Whatever it refers to is added when it is first referred to.
class KitDocument::Addition {
 public:
  Addition(KitDocument& to, const fs::path& file) : to_(to), file_(file), from_(opened(file)) {}

  Model model() {
    Model model{file_.stem().string(), {}};
    const Json& scene = from_.json.at("scenes").at(from_.json.value("scene", std::size_t{0}));
    add_node(scene.at("nodes").at(0).get<std::size_t>(), model);
    model.nodes[0].placement = Json::object();
    list_extensions();
    return model;
  }

 private:
  std::size_t add_node(std::size_t number, Model& model) {
    const Json& from = from_.json.at("nodes").at(number);
    const std::size_t made = model.nodes.size();
    model.nodes.emplace_back();
    for (const char* key : {"translation", "rotation", "scale"}) {
      if (from.contains(key)) model.nodes[made].placement[key] = from[key];
    }
    const std::string own = from.value("name", std::string("part"));
    const std::string name = own == model.name ? own : model.name + '/' + own;
    if (from.contains("mesh")) model.nodes[made].mesh = mesh(from["mesh"].get<std::size_t>(), name);
    if (!from.contains("children")) return made;
    for (const Json& child : from["children"]) {
      const std::size_t added = add_node(child.get<std::size_t>(), model);
      model.nodes[made].children.push_back(added);
    }
    return made;
  }

  std::size_t mesh(std::size_t number, const std::string& name) {
    const auto [known, is_new] = meshes_.try_emplace(number, to_.json_["meshes"].size());
    if (!is_new) return known->second;
    Json mesh = from_.json.at("meshes").at(number);
    mesh["name"] = name;
    for (Json& primitive : mesh.at("primitives")) {
      for (Json& attribute : primitive.at("attributes")) attribute = accessor(attribute.get<std::size_t>());
      if (primitive.contains("indices")) primitive["indices"] = accessor(primitive["indices"].get<std::size_t>());
      if (primitive.contains("material")) primitive["material"] = material(primitive["material"].get<std::size_t>());
    }
    to_.json_["meshes"].push_back(std::move(mesh));
    return known->second;
  }

  std::size_t accessor(std::size_t number) {
    const auto [known, is_new] = accessors_.try_emplace(number, 0);
    if (!is_new) return known->second;
    Json accessor = from_.json.at("accessors").at(number);
    accessor["bufferView"] = view(accessor.at("bufferView").get<std::size_t>());
    to_.json_["accessors"].push_back(std::move(accessor));
    return known->second = to_.json_["accessors"].size() - 1;
  }

  std::size_t view(std::size_t number) {
    const auto [known, is_new] = views_.try_emplace(number, 0);
    if (is_new) known->second = to_.add_view(bytes_of(number), from_.json["bufferViews"][number]);
    return known->second;
  }

  std::span<const std::byte> bytes_of(std::size_t number) const {
    const Json& view = from_.json.at("bufferViews").at(number);
    const auto offset = view.value("byteOffset", std::size_t{0}), length = view.at("byteLength").get<std::size_t>();
    if (offset > from_.buffer.size() || length > from_.buffer.size() - offset) {
      throw std::runtime_error(file_.string() + ": a buffer view does not lie in the buffer");
    }
    return std::span(from_.buffer).subspan(offset, length);
  }

  std::size_t material(std::size_t number) {
    Json material = from_.json.at("materials").at(number);
    replace_textures(material);
    return to_.add_once("materials", material);
  }

  /// "baseColorTexture", "normalTexture" and all others, also those of extensions.
  void replace_textures(Json& value) {
    if (!value.is_structured()) return;
    for (const auto& [key, part] : value.items()) {
      const bool is_texture = value.is_object() && key.ends_with("Texture") && part.contains("index");
      if (is_texture) part["index"] = texture(part["index"].get<std::size_t>());
      replace_textures(part);
    }
  }

  std::size_t texture(std::size_t number) {
    Json texture = from_.json.at("textures").at(number);
    if (texture.contains("source")) texture["source"] = image(texture["source"].get<std::size_t>());
    if (texture.contains("sampler")) {
      texture["sampler"] =
          to_.add_once("samplers", from_.json.at("samplers").at(texture["sampler"].get<std::size_t>()));
    }
    return to_.add_once("textures", texture);
  }

  std::size_t image(std::size_t number) {
    Json image = from_.json.at("images").at(number);
    Bytes bytes;
    if (image.contains("uri")) {
      bytes = contents(file_.parent_path() / image["uri"].get<std::string>());
      image.erase("uri");
    } else {
      const auto held = bytes_of(image.at("bufferView").get<std::size_t>());
      bytes.assign(held.begin(), held.end());
    }
    const std::string key = "image bytes " + to_text(content_hash(std::span<const std::byte>(bytes)));
    const auto [known, is_new] = to_.once_.try_emplace(key, 0);
    if (is_new) known->second = to_.add_view(bytes, {});
    image["bufferView"] = known->second;
    return to_.add_once("images", image);
  }

  /// Those that the file says it uses, and does.
  void list_extensions() {
    if (!from_.json.contains("extensionsUsed")) return;
    const std::string text = to_.json_.dump();
    for (const Json& name : from_.json["extensionsUsed"]) {
      if (text.find(name.dump() + ":") != std::string::npos) to_.add_once("extensionsUsed", name);
    }
  }

  KitDocument& to_;
  const fs::path file_;
  Opened from_;
  std::map<std::size_t, std::size_t> meshes_, accessors_, views_;
};

KitDocument::Model KitDocument::add(const fs::path& file) { return Addition(*this, file).model(); }

std::vector<std::byte> KitDocument::glb() const {
  Json json = json_;
  json["buffers"] = {{{"byteLength", bin_.size()}}};
  for (const char* kind : {"images", "samplers", "textures", "materials", "extensionsUsed"}) {
    if (json.contains(kind) && json[kind].empty()) json.erase(kind);
  }
  const std::string text = json.dump();
  Bytes chunks;
  put_chunk(chunks, std::as_bytes(std::span(text)), "JSON", ' ');
  put_chunk(chunks, bin_, "BIN\0", '\0');
  Bytes file;
  for (const char letter : {'g', 'l', 'T', 'F'}) file.push_back(static_cast<std::byte>(letter));
  put_word(file, 2);
  put_word(file, 12 + chunks.size());
  file.insert(file.end(), chunks.begin(), chunks.end());
  return file;
}

}  // namespace foredraw::bench
