#include "gltf_document.h"

#include <foredraw/base/content_hash.h>
#include <foredraw/platform/files.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace foredraw::bench {

namespace {

namespace fs = std::filesystem;
using Json = GltfDocument::Json;
using Bytes = std::vector<std::byte>;

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

std::string without_name(Json value) {
  if (value.is_object()) value.erase("name");
  return value.dump();
}

}  // namespace

std::vector<std::byte> contents(const fs::path& path) {
  Diagnostics diagnostics;
  auto bytes = read_file(path, diagnostics);
  if (!bytes) throw std::runtime_error(to_text(diagnostics));
  return std::move(*bytes);
}

GltfDocument::Opened GltfDocument::opened(const fs::path& file) {
  const Bytes bytes = contents(file);
  const char* text = reinterpret_cast<const char*>(bytes.data());
  if (file.extension() == ".glb") {
    if (bytes.size() < 20) throw std::runtime_error(file.string() + ": it is too short for a .glb");
    const std::size_t end = 20 + std::size_t{word_at(bytes, 12)};
    if (bytes.size() < end + 8) throw std::runtime_error(file.string() + ": it has no buffer");
    return {file.string(), Json::parse(text + 20, text + end),
            Bytes(bytes.begin() + static_cast<std::ptrdiff_t>(end) + 8, bytes.end())};
  }
  Json json = Json::parse(text, text + bytes.size());
  Bytes buffer = contents(file.parent_path() / json.at("buffers").at(0).at("uri").get<std::string>());
  return {file.string(), std::move(json), std::move(buffer)};
}

std::span<const std::byte> GltfDocument::Opened::view(std::size_t number) const {
  const Json& view = json.at("bufferViews").at(number);
  const auto offset = view.value("byteOffset", std::size_t{0}), length = view.at("byteLength").get<std::size_t>();
  if (offset > buffer.size() || length > buffer.size() - offset) {
    throw std::runtime_error(name + ": a buffer view does not lie in the buffer");
  }
  return std::span(buffer).subspan(offset, length);
}

std::size_t GltfDocument::add(const char* kind, Json value) {
  json[kind].push_back(std::move(value));
  return json[kind].size() - 1;
}

std::size_t GltfDocument::add_view(std::span<const std::byte> bytes, const Json& like) {
  bin_.resize((bin_.size() + 3) / 4 * 4);
  Json view{{"buffer", 0}, {"byteOffset", bin_.size()}, {"byteLength", bytes.size()}};
  for (const char* key : {"byteStride", "target"}) {
    if (like.contains(key)) view[key] = like[key];
  }
  bin_.insert(bin_.end(), bytes.begin(), bytes.end());
  return add("bufferViews", std::move(view));
}

std::size_t GltfDocument::add_bounded(std::span<const float> values, const char* type, int target) {
  const std::size_t made = add_values(values, type, target), width = components(type);
  std::vector<float> least(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(width)), most = least;
  for (std::size_t i = 0; i < values.size(); ++i) {
    least[i % width] = std::min(least[i % width], values[i]);
    most[i % width] = std::max(most[i % width], values[i]);
  }
  json["accessors"][made]["min"] = least;
  json["accessors"][made]["max"] = most;
  return made;
}

std::size_t GltfDocument::add_once(const char* kind, const Json& value) {
  const auto [known, is_new] = once_.try_emplace(kind + without_name(value), json[kind].size());
  if (is_new) json[kind].push_back(value);
  return known->second;
}

std::size_t GltfDocument::add_image(std::span<const std::byte> bytes, Json image) {
  const auto [known, is_new] = once_.try_emplace("image bytes " + to_text(content_hash(bytes)), 0);
  if (is_new) known->second = add_view(bytes);
  image["bufferView"] = known->second;
  return add_once("images", image);
}

std::vector<std::byte> GltfDocument::glb() const {
  Json json = this->json;
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
