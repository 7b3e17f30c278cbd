#include "support/gltf_builder.h"

#include <cstring>

namespace foredraw::testing {

namespace {

void put_word(std::vector<std::byte>& to, std::uint32_t value) {
  to.resize(to.size() + 4);
  std::memcpy(to.data() + to.size() - 4, &value, 4);
}

std::string base64(std::span<const std::byte> bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = (bits << 8) | (i + k < bytes.size() ? std::to_integer<unsigned>(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? letters[(bits >> (18 - 6 * k)) & 63] : '=';
  }
  return text;
}

}  // namespace

std::vector<std::byte> bytes_of(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

GltfJson json_of(std::span<const std::byte> file) {
  const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  if (text.substr(0, 4) != "glTF") return GltfJson::parse(text);
  std::uint32_t length;
  std::memcpy(&length, file.data() + 12, 4);
  return GltfJson::parse(text.substr(20, length));
}

std::size_t GltfBuilder::add(const char* kind, GltfJson value) {
  json[kind].push_back(std::move(value));
  return json[kind].size() - 1;
}

std::size_t GltfBuilder::add_view(std::span<const std::byte> bytes, std::size_t stride) {
  buffer.resize((buffer.size() + 3) / 4 * 4);
  GltfJson view{{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}};
  if (stride != 0) view["byteStride"] = stride;
  buffer.insert(buffer.end(), bytes.begin(), bytes.end());
  return add("bufferViews", std::move(view));
}

std::size_t GltfBuilder::add_accessor(std::size_t view, std::size_t offset, int component_type, const std::string& type,
                                      std::size_t count) {
  return add("accessors", {{"bufferView", view},
                           {"byteOffset", offset},
                           {"componentType", component_type},
                           {"count", count},
                           {"type", type}});
}

std::size_t GltfBuilder::add_mesh(GltfJson primitive) {
  const std::size_t mesh = add("meshes", GltfJson::object());
  json["meshes"][mesh]["primitives"].push_back(std::move(primitive));
  add("nodes", {{"mesh", mesh}});
  return mesh;
}

std::vector<std::byte> glb_of(const std::string& json, std::span<const std::byte> bin) {
  std::vector<std::byte> file;
  const std::size_t text = (json.size() + 3) / 4 * 4;
  const std::size_t data = (bin.size() + 3) / 4 * 4;
  for (const std::size_t word : {std::size_t{0x46546C67}, std::size_t{2}, 20 + text + (bin.empty() ? 0 : 8 + data),
                                 text, std::size_t{0x4E4F534A}}) {
    put_word(file, static_cast<std::uint32_t>(word));
  }
  const auto chars = bytes_of(json);
  file.insert(file.end(), chars.begin(), chars.end());
  file.resize(20 + text, std::byte{' '});
  if (bin.empty()) return file;
  put_word(file, static_cast<std::uint32_t>(data));
  put_word(file, 0x004E4942);
  file.insert(file.end(), bin.begin(), bin.end());
  file.resize(28 + text + data);
  return file;
}

std::vector<std::byte> GltfBuilder::glb() const {
  GltfJson whole = json;
  if (!buffer.empty() && !whole.contains("buffers")) whole["buffers"][0]["byteLength"] = buffer.size();
  return glb_of(whole.dump(), buffer);
}

std::vector<std::byte> GltfBuilder::gltf() const {
  GltfJson whole = json;
  if (!buffer.empty()) {
    const std::string uri = "data:application/octet-stream;base64," + base64(buffer);
    whole["buffers"][0] = {{"byteLength", buffer.size()}, {"uri", uri}};
  }
  return bytes_of(whole.dump(2));
}

GltfBuilder ribbon(std::size_t squares) {
  std::vector<float> positions, uvs;
  std::vector<std::uint16_t> indices;
  for (std::size_t i = 0; i <= squares; ++i) {
    const auto x = static_cast<float>(i);
    positions.insert(positions.end(), {x, 0, 0, x, 1, 0});
    uvs.insert(uvs.end(), {x, 0, x, 1});
    const auto v = static_cast<std::uint16_t>(2 * i);
    const auto next = [&](int k) { return static_cast<std::uint16_t>(v + k); };
    if (i < squares) indices.insert(indices.end(), {v, next(2), next(1), next(1), next(2), next(3)});
  }
  GltfBuilder made;
  const std::size_t position = made.add_values(positions, "VEC3");
  made.json["accessors"][position]["min"] = {0, 0, 0};
  made.json["accessors"][position]["max"] = {squares, 1, 0};
  const std::size_t uv = made.add_values(uvs, "VEC2");
  const std::size_t index = made.add_values(indices, "SCALAR");
  made.add_mesh({{"attributes", {{"POSITION", position}, {"TEXCOORD_0", uv}}}, {"indices", index}});
  return made;
}

GltfBuilder puppet() {
  GltfBuilder made = ribbon(4);
  const std::size_t vertices = 10;
  GltfJson primitive = made.json["meshes"][0]["primitives"][0];
  primitive["attributes"]["JOINTS_0"] = made.add_values(std::vector<std::uint8_t>(4 * vertices, 1), "VEC4");
  std::vector<float> weights(4 * vertices, 0.25f);
  primitive["attributes"]["WEIGHTS_0"] = made.add_values(weights, "VEC4");

  const std::size_t target = made.add_values(std::vector<float>(3 * vertices, 0.5f), "VEC3");
  const std::vector<std::uint16_t> sparse_indices{1, 4, 9};
  const std::vector<float> sparse_values{1, 2, 3, 4, 5, 6, 7, 8, 9};
  const std::size_t places = made.add_view(std::as_bytes(std::span(sparse_indices)));
  const std::size_t moved = made.add_view(std::as_bytes(std::span(sparse_values)));
  made.json["accessors"][target]["sparse"] = {{"count", 3},
                                              {"indices", {{"bufferView", places}, {"componentType", 5123}}},
                                              {"values", {{"bufferView", moved}}}};
  primitive["targets"][0]["POSITION"] = target;

  const std::string picture = "no real picture!";
  made.add("images", {{"bufferView", made.add_view(std::as_bytes(std::span(picture)))}, {"mimeType", "image/png"}});
  made.add("samplers", GltfJson::object());
  made.add("textures", {{"source", 0}, {"sampler", 0}});
  made.add("materials", {{"name", "cloth"},
                         {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                         {"alphaMode", "MASK"},
                         {"alphaCutoff", 0.25},
                         {"doubleSided", true}});
  primitive["material"] = 0;
  made.json["meshes"][0]["primitives"][0] = primitive;

  std::vector<float> matrices(32, 0);
  for (std::size_t m = 0; m < 2; ++m) {
    for (std::size_t i = 0; i < 4; ++i) matrices[16 * m + 5 * i] = 1;
  }
  made.add("skins", {{"joints", {1, 2}}, {"inverseBindMatrices", made.add_values(matrices, "MAT4")}});
  made.json["nodes"][0]["skin"] = 0;
  made.add("nodes", {{"name", "shoulder"}, {"children", {2}}});
  made.add("nodes", {{"name", "elbow"}, {"translation", {0, 1, 0}}});
  made.add("scenes", {{"nodes", {0, 1}}});
  made.json["scene"] = 0;

  const std::size_t times = made.add_values(std::vector<float>{0, 0.5f, 1}, "SCALAR");
  made.json["accessors"][times]["min"] = {0};
  made.json["accessors"][times]["max"] = {1};
  const std::size_t turns = made.add_values(std::vector<float>{0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1}, "VEC4");
  const std::size_t weight = made.add_values(std::vector<float>{0, 1, 0}, "SCALAR");
  made.add("animations", {{"name", "wave"},
                          {"samplers", {{{"input", times}, {"output", turns}}, {{"input", times}, {"output", weight}}}},
                          {"channels",
                           {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "rotation"}}}},
                            {{"sampler", 1}, {"target", {{"node", 0}, {"path", "weights"}}}}}}});
  return made;
}

}  // namespace foredraw::testing
