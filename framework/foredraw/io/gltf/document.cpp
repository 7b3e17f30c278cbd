#include <foredraw/io/gltf/private/document.h>
#include <foredraw/io/gltf/private/each_extension.h>
#include <foredraw/io/gltf/private/rows.h>
#include <foredraw/io/text/private/uri.h>

#include <algorithm>
#include <set>

namespace foredraw::gltf {

namespace {

std::size_t rows_of_matrix(std::string_view type) {
  return type == "MAT2" ? 2 : type == "MAT3" ? 3 : type == "MAT4" ? 4 : 0;
}

Bytes rows_from(const Document& document, const Rows& rows) {
  return document.views[rows.view].bytes.subspan(rows.offset);
}

/// The elements where they lie, if they lie there without gaps.
std::optional<Bytes> tight_bytes(const Document& document, const Accessor& accessor) {
  if (!accessor.rows || accessor.rows->stride != accessor.format.bytes || accessor.sparse) return std::nullopt;
  return rows_from(document, *accessor.rows).first(accessor.bytes());
}

std::uint32_t load_index(const std::byte* from, std::size_t bytes) {
  std::uint32_t value = 0;
  std::memcpy(&value, from, bytes);  // little-endian, as glTF is and every machine that we build for
  return value;
}

}  // namespace

std::vector<std::byte> elements(const Document& document, const Accessor& accessor) {
  if (const auto bytes = tight_bytes(document, accessor)) return {bytes->begin(), bytes->end()};
  const std::size_t element = accessor.format.bytes;
  std::vector<std::byte> result(accessor.bytes());
  if (accessor.rows) {
    const Bytes from = rows_from(document, *accessor.rows);
    copy_rows(result.data(), element, from.data(), accessor.rows->stride, element, accessor.count);
  }
  if (accessor.sparse) {
    const Bytes indices = rows_from(document, accessor.sparse->indices);
    const Bytes values = rows_from(document, accessor.sparse->values);
    const std::size_t width = foredraw::bytes_of(accessor.sparse->index);
    for (std::size_t i = 0; i < accessor.sparse->count; ++i) {
      const std::size_t to = load_index(indices.data() + i * width, width);
      std::memcpy(result.data() + to * element, values.data() + i * element, element);
    }
  }
  return result;
}

std::vector<float> decoded_elements(const Document& document, const Accessor& accessor) {
  std::vector<std::byte> bytes = elements(document, accessor);
  std::vector<float> values;
  if (accessor.format.component == Component::float32) {
    values.resize(bytes.size() / sizeof(float));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }
  const VertexStream stream{"", accessor.format, Shared<std::byte>(std::move(bytes))};
  values.reserve(accessor.count * accessor.format.components);
  for (std::size_t i = 0; i < accessor.count; ++i) {
    for (std::size_t c = 0; c < accessor.format.components; ++c) values.push_back(decode_component(stream, i, c));
  }
  return values;
}

std::vector<std::uint32_t> index_elements(const Document& document, const Accessor& accessor) {
  if (const auto bytes = tight_bytes(document, accessor)) return widened(*bytes, accessor.format.bytes);
  return widened(elements(document, accessor), accessor.format.bytes);
}

std::uint32_t greatest_index(const Document& document, const Accessor& accessor) {
  if (const auto bytes = tight_bytes(document, accessor)) return greatest(*bytes, accessor.format.bytes);
  return greatest(elements(document, accessor), accessor.format.bytes);
}

std::uint32_t restart_of(Component indices) {
  return indices == Component::uint8 ? 0xffu : indices == Component::uint16 ? 0xffffu : 0xffffffffu;
}

std::optional<Format> format_of(std::string_view type, std::uint64_t component_type, bool normalized) {
  Format format;
  switch (component_type) {
    case 5120: format.component = Component::int8; break;
    case 5121: format.component = Component::uint8; break;
    case 5122: format.component = Component::int16; break;
    case 5123: format.component = Component::uint16; break;
    case 5125: format.component = Component::uint32; break;
    case 5126: format.component = Component::float32; break;
    default: return std::nullopt;
  }
  format.normalized = normalized;
  const std::size_t width = foredraw::bytes_of(format.component);
  if (const std::size_t n = rows_of_matrix(type)) {
    format.components = static_cast<std::uint8_t>(n * n);
    format.bytes = static_cast<std::uint16_t>(n * ((n * width + 3) / 4 * 4));
    return format;
  }
  if (type == "SCALAR") {
    format.components = 1;
  } else if (type.size() == 4 && type.substr(0, 3) == "VEC" && type[3] >= '2' && type[3] <= '4') {
    format.components = static_cast<std::uint8_t>(type[3] - '0');
  } else {
    return std::nullopt;
  }
  format.bytes = static_cast<std::uint16_t>(format.components * width);
  return format;
}

const Json* extension_of(const Json& holder, std::string_view name) {
  const auto extensions = holder.find("extensions");
  if (extensions == holder.end() || !extensions->is_object()) return nullptr;
  const auto found = extensions->find(name);
  return found == extensions->end() ? nullptr : &*found;
}

Json take_extension(Json& holder, std::string_view name) {
  if (extension_of(holder, name) == nullptr) return {};
  Json& extensions = holder["extensions"];
  const auto found = extensions.find(name);
  Json value = std::move(*found);
  extensions.erase(found);
  if (extensions.empty()) holder.erase("extensions");
  return value;
}

bool has_extension(const Json& json, std::string_view name) {
  bool found = extension_of(json, name) != nullptr;
  each_primitive(json, [&](const Json& primitive) { found = found || extension_of(primitive, name) != nullptr; });
  return found;
}

void take_extension_everywhere(Json& json, std::string_view name) {
  take_extension(json, name);
  each_primitive(json, [&](Json& primitive) { take_extension(primitive, name); });
}

std::size_t listed(Json& list, const Json& value) {
  if (!list.is_array()) list = Json::array();
  const auto found = std::find(list.begin(), list.end(), value);
  if (found != list.end()) return static_cast<std::size_t>(found - list.begin());
  list.push_back(value);
  return list.size() - 1;
}

void list_extension(Json& json, const char* list, const std::string& name) { listed(json[list], name); }

void unlist_extension(Json& json, std::string_view name) {
  for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
    const auto names = json.find(list);
    if (names == json.end() || !names->is_array()) continue;
    const auto listed = std::find(names->begin(), names->end(), Json(name));
    if (listed != names->end()) names->erase(listed);
    if (names->empty()) json.erase(list);
  }
}

std::uint64_t bytes_read(const Document& document) {
  std::uint64_t bytes = document.file.size();
  for (std::size_t i = 0; i < document.buffers.size(); ++i) {
    const Json& buffer = document.json["buffers"][i];
    const bool beside = buffer.contains("uri") && !is_data_uri(buffer["uri"].get<std::string>());
    if (beside) bytes += document.buffers[i].bytes.size();
  }
  return bytes;
}

std::vector<std::string> extensions_in(const Json& json) {
  std::set<std::string> names;
  if (const auto used = json.find("extensionsUsed"); used != json.end() && used->is_array()) {
    for (const Json& name : *used) {
      if (name.is_string()) names.insert(name.get<std::string>());
    }
  }
  each_extension(json, [&](const std::string& name, const Json&) { names.insert(name); });
  return {names.begin(), names.end()};
}

bool Document::knows_extension(std::string_view name) const {
  // Families that refer to textures, images, nodes or materials alone, none of which is ever renumbered.
  static constexpr std::string_view families[] = {"KHR_materials_", "KHR_texture_",  "KHR_lights_", "EXT_texture_",
                                                  "EXT_lights_",    "MSFT_texture_", "KHR_xmp",     "KHR_node_"};
  static constexpr std::string_view names[] = {
      "KHR_mesh_quantization",      mesh_gpu_instancing,       "KHR_animation_pointer",   "MSFT_lod",
      "KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression", "FB_ngon_encoding",
      "GODOT_single_root",          "FOREDRAW_levels",         "AGI_articulations"};
  return std::any_of(std::begin(families), std::end(families),
                     [&](std::string_view family) { return name.substr(0, family.size()) == family; }) ||
         std::find(std::begin(names), std::end(names), name) != std::end(names) ||
         std::ranges::any_of(products, [&](const auto& row) { return row->card().extension == name; });
}

bool Document::knows_all_extensions() const {
  return std::ranges::all_of(extensions_in(json), [this](const std::string& name) { return knows_extension(name); });
}

}  // namespace foredraw::gltf
