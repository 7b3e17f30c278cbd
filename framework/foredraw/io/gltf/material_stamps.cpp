#include <foredraw/io/gltf/private/material_stamps.h>

#include <map>
#include <string_view>

namespace foredraw::gltf {

namespace {

/// Its keys in the sequence of letters, whatever the file's was.
Json sorted(const Json& json) {
  if (!json.is_structured()) return json;
  Json result(json.type());
  if (json.is_array()) {
    for (const Json& element : json) result.push_back(sorted(element));
    return result;
  }
  std::map<std::string_view, const Json*> members;
  for (const auto& [key, value] : json.items()) members.emplace(key, &value);
  for (const auto& [key, value] : members) result[std::string(key)] = sorted(*value);
  return result;
}

Stamp stamp_of(const Json& json) {
  const std::string text = sorted(json).dump(-1, ' ', false, Json::error_handler_t::replace);
  return content_hash(std::span<const char>(text));
}

bool is_numbers(const Json& value) {
  return value.is_number() || (value.is_array() && !value.empty() && value.front().is_number());
}

/// Without factors, cutoffs and numbers of textures: what a shader reads, and not what it is built for. Which set of
/// texture coordinates is one of the latter.
Json without_numbers(const Json& json) {
  if (!json.is_object()) return json;
  Json result = Json::object();
  for (const auto& [key, value] : json.items()) {
    if (is_numbers(value) && key != "texCoord") continue;
    result[key] = without_numbers(value);
  }
  // Most exporters say what holds anyway.
  if (result.value("texCoord", Json(1)) == 0) result.erase("texCoord");
  return result;
}

}  // namespace

void add_stamps(Material& material, const Json& json) {
  Json nameless = json;
  nameless.erase("name");
  nameless.erase("extras");
  material.look = stamp_of(nameless);
  if (nameless.contains("pbrMetallicRoughness") && without_numbers(nameless["pbrMetallicRoughness"]).empty()) {
    nameless.erase("pbrMetallicRoughness");
  }
  material.kind = stamp_of(without_numbers(nameless));
}

}  // namespace foredraw::gltf
