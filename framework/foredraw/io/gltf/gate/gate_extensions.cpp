// Checks of what the file requires: what can not be understood here is refused by name, with the remedy.
#include <foredraw/io/gltf/gate/private/gate.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace foredraw::gltf {

namespace {

std::set<std::string> names(Gate& gate, const char* key) {
  std::set<std::string> result;
  const Json* list = gate.array(gate.json(), key, {});
  for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
    if ((*list)[i].is_string()) {
      result.insert((*list)[i].get<std::string>());
    } else {
      gate.error(at(key, i), "wrong-type", "must be a string");
    }
  }
  return result;
}

/// The meshes without their primitives of points and lines, which no stage touches: Gaussian splats are such points.
Json meshes_of_triangles(const Gate& gate) {
  Json meshes = gate.all("meshes");
  for (Json& mesh : meshes) {
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array()) continue;
    for (Json& primitive : *primitives) {
      const auto mode = primitive.is_object() ? primitive.find("mode") : primitive.end();
      if (mode != primitive.end() && mode->is_number_unsigned() && *mode < 4) primitive = nullptr;
    }
  }
  return meshes;
}

/// The extensions that triangles have, or what moves or holds them; sorted.
std::vector<std::string> extensions_of_triangles(const Gate& gate) {
  Json held = JsonObject{{"meshes", meshes_of_triangles(gate)}};
  for (const char* kind : {"accessors", "animations", "buffers", "bufferViews", "nodes", "skins"})
    held[kind] = gate.all(kind);
  return extensions_in(held);
}

}  // namespace

void check_extensions(Gate& gate) {
  const std::set<std::string> required = names(gate, "extensionsRequired");
  names(gate, "extensionsUsed");
  std::optional<std::vector<std::string>> shaping;  // where it is asked for
  for (const std::string& name : required) {
    if (gate.document().knows_extension(name)) continue;
    if (!shaping) shaping = extensions_of_triangles(gate);
    if (!std::ranges::binary_search(*shaping, name)) {
      gate.fault("required-extension", "extensionsRequired", fmt::format("the extension '{}' is not known", name));
    } else {
      gate.error("extensionsRequired", "unsupported-extension",
                 fmt::format("the file requires the extension '{}', which is not supported", name),
                 "export the file without that extension");
    }
  }
}

}  // namespace foredraw::gltf
