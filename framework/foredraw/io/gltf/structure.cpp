#include <foredraw/io/gltf/private/source.h>

namespace foredraw::gltf {

namespace {

/// The members of `from` with these names.
Json only(const Json& from, std::initializer_list<const char*> keys) {
  Json result = Json::object();
  for (const char* key : keys) {
    if (const auto found = from.find(key); found != from.end()) result[key] = *found;
  }
  return result;
}

auto keeping(auto... keys) {
  return [=](const Json& from) { return only(from, {keys...}); };
}

/// Names are free text and may be of any type in a careless file.
Json named(const Json& from, Json result) {
  if (const auto name = from.find("name"); name != from.end() && name->is_string()) result["name"] = *name;
  return result;
}

/// Of many items no tree is made, only their text.
template <class F>
void each(const Json& json, const char* kind, F&& make, std::string& into) {
  const auto found = json.find(kind);
  if (found == json.end()) return;
  into += std::string(",\"") + kind + "\":[";
  for (const Json& item : *found) into += named(item, make(item)).dump() + ',';
  if (!found->empty()) into.pop_back();
  into += ']';
}

}  // namespace

std::string checked_structure(const Json& json) {
  std::string result = R"({"asset":{"version":"2.0"})";
  each(json, "bufferViews", keeping("buffer", "byteLength"), result);
  each(json, "accessors", keeping("bufferView", "componentType", "count", "type"), result);
  each(
      json, "meshes",
      [](const Json& mesh) {
        Json copy = only(mesh, {"weights"});
        for (const Json& p : mesh["primitives"]) {
          copy["primitives"].push_back(only(p, {"attributes", "targets", "indices", "material", "mode"}));
        }
        return copy;
      },
      result);
  each(json, "skins", keeping("joints", "inverseBindMatrices"), result);
  each(json, "materials", keeping("alphaMode", "alphaCutoff", "doubleSided"), result);
  each(
      json, "animations",
      [](const Json& animation) {
        Json copy = Json::object();
        for (const Json& s : animation["samplers"])
          copy["samplers"].push_back(only(s, {"input", "output", "interpolation"}));
        for (const Json& c : animation["channels"]) {
          const Json& target = c["target"];
          // What aims at no node aims by an extension at something that has no shape.
          if (!target.contains("node") || target["path"] == "pointer") continue;
          copy["channels"].push_back({{"sampler", c["sampler"]}, {"target", only(target, {"node", "path"})}});
        }
        return copy;
      },
      result);
  return result + '}';
}

}  // namespace foredraw::gltf
