// Checks of what the file requires: what can not be understood here is refused by name, with the remedy.
#include <foredraw/io/gltf/private/gate.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace foredraw::gltf {

namespace {

constexpr const char* draco = "KHR_draco_mesh_compression";
constexpr const char* decode = "decode it first, for instance with `gltf-transform copy in.glb out.glb`";

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

bool lacks_bytes(Gate& gate, const Json& number) {
  const Json& accessors = gate.all("accessors");
  return number.is_number_unsigned() && number.get<std::uint64_t>() < accessors.size() &&
         !accessors[number.get<std::size_t>()].contains("bufferView");
}

bool depends_on_draco(Gate& gate, const Json& primitive) {
  if (!primitive.is_object() || extension_of(primitive, draco) == nullptr) return false;
  if (primitive.contains("indices") && lacks_bytes(gate, primitive["indices"])) return true;
  const auto attributes = primitive.find("attributes");
  if (attributes == primitive.end() || !attributes->is_object()) return false;
  for (const auto& [semantic, number] : attributes->items()) {
    if (lacks_bytes(gate, number)) return true;
  }
  return false;
}

void refuse_draco(Gate& gate, const std::string& place) {
  gate.error(place, "unsupported-extension",
             fmt::format("{}: the data is compressed and has no uncompressed copy", draco), decode);
}

/// Whether something that is drawn, or its bytes, has the extension.
bool shapes_what_is_drawn(const Gate& gate, const std::string& name) {
  constexpr const char* drawn[] = {"accessors", "animations", "buffers", "bufferViews", "meshes", "nodes", "skins"};
  return std::ranges::any_of(drawn, [&](const char* kind) {
    const std::vector<std::string> held = extensions_in({{kind, gate.all(kind)}});
    return std::ranges::binary_search(held, name);
  });
}

void check_draco(Gate& gate) {
  const Json& meshes = gate.all("meshes");
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const auto primitives = meshes[m].find("primitives");
    if (primitives == meshes[m].end() || !primitives->is_array()) continue;
    for (std::size_t p = 0; p < primitives->size(); ++p) {
      if (!depends_on_draco(gate, (*primitives)[p])) continue;
      refuse_draco(gate, at(in(at("meshes", m), "primitives"), p));
      return;
    }
  }
}

}  // namespace

void check_extensions(Gate& gate) {
  const std::set<std::string> required = names(gate, "extensionsRequired");
  names(gate, "extensionsUsed");
  for (const std::string& name : required) {
    if (name == draco) {
      refuse_draco(gate, "extensionsRequired");
    } else if (gate.document().knows_extension(name)) {
      continue;
    } else if (!shapes_what_is_drawn(gate, name)) {
      gate.fault("required-extension", "extensionsRequired", fmt::format("the extension '{}' is not known", name));
    } else {
      gate.error("extensionsRequired", "unsupported-extension",
                 fmt::format("the file requires the extension '{}', which is not supported", name),
                 "export the file without that extension");
    }
  }
  if (!required.contains(draco)) check_draco(gate);
}

}  // namespace foredraw::gltf
