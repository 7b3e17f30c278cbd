// Accessors that hold the same, made one.
#include <foredraw/io/gltf/layout/private/layout.h>
#include <foredraw/io/gltf/patch/private/write.h>
#include <foredraw/io/gltf/private/rows.h>

#include <map>

namespace foredraw::gltf {

namespace {

/// What each accessor is of a primitive: an attribute's name, or "indices"; empty: nothing. One kind never stands for
/// another, since they lie in different views.
std::vector<std::string> kinds_of_accessors(const Json& json) {
  std::vector<std::string> kinds(json["accessors"].size());
  each_primitive(json, [&](const Json& primitive) {
    const auto attributes = [&](const Json& names) {
      for (const auto& [name, number] : names.items()) kinds[number.get<std::size_t>()] = name;
    };
    attributes(primitive["attributes"]);
    for (const Json& target : primitive.value("targets", Json::array())) attributes(target);
    if (primitive.contains("indices")) kinds[primitive["indices"].get<std::size_t>()] = "indices";
  });
  return kinds;
}

/// All that the accessor says, and its rows; empty where these do not lie plain in the first buffer.
std::string all_of(const Json& accessor, const Json& json, const LaidOut& laid_out) {
  const auto format =
      format_of(accessor["type"].get<std::string>(), accessor["componentType"].get<std::uint64_t>(), false);
  if (!format || accessor.contains("sparse") || !accessor.contains("bufferView")) return {};
  const Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
  if (view["buffer"] != 0 || view.contains("extensions")) return {};
  const std::size_t first = view.value("byteOffset", std::size_t{0}) + accessor.value("byteOffset", std::size_t{0});
  const auto count = accessor["count"].get<std::size_t>();
  std::vector<std::byte> rows(count * format->bytes);
  copy_rows(rows.data(), format->bytes, laid_out.bytes.data() + first,
            view.value("byteStride", std::size_t{format->bytes}), format->bytes, count);
  Json rest = accessor;
  for (const char* key : {"bufferView", "byteOffset", "name"}) rest.erase(key);
  return rest.dump() + to_text(content_hash(std::span<const std::byte>(rows)));
}

}  // namespace

void join_accessors(Json& json, const LaidOut& laid_out) {
  if (!json.contains("accessors") || !json.contains("bufferViews")) return;
  const std::vector<std::string> kinds = kinds_of_accessors(json);
  std::map<std::string, std::size_t> first;
  std::vector<std::size_t> to(kinds.size());
  for (std::size_t a = 0; a < to.size(); ++a) {
    const std::string content = all_of(json["accessors"][a], json, laid_out);
    to[a] = content.empty() ? a : first.try_emplace(kinds[a] + ' ' + content, a).first->second;
  }
  each_accessor_named(json, [&](Json& number) { number = to[number.get<std::size_t>()]; });
}

}  // namespace foredraw::gltf
