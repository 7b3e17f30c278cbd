// Checks of what the file requires: compressed data that has no plain copy is refused by name, with the remedy.
#include <foredraw/io/private/gltf_gate.h>

#include <fmt/format.h>

#include <set>

namespace foredraw::gltf {

namespace {

constexpr const char* draco = "KHR_draco_mesh_compression";
constexpr const char* meshopt[] = {"EXT_meshopt_compression", "KHR_meshopt_compression"};
constexpr const char* decode = "decode it first, for instance with `gltf-transform copy in.glb out.glb`";

std::set<std::string> names(Gate& gate, const char* key) {
  std::set<std::string> result;
  const Json* list = gate.array(gate.json(), key, {});
  for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
    if ((*list)[i].is_string()) {
      result.insert((*list)[i].get<std::string>());
    } else {
      gate.error(at(key, i), "wrong-type", "must be a text");
    }
  }
  return result;
}

const Json* extension(const Json& holder, const char* name) {
  const auto extensions = holder.find("extensions");
  if (extensions == holder.end() || !extensions->is_object()) return nullptr;
  const auto found = extensions->find(name);
  return found == extensions->end() ? nullptr : &*found;
}

bool lacks_bytes(Gate& gate, const Json& number) {
  const Json& accessors = gate.all("accessors");
  return number.is_number_unsigned() && number.get<std::uint64_t>() < accessors.size() &&
         !accessors[number.get<std::size_t>()].contains("bufferView");
}

bool depends_on_draco(Gate& gate, const Json& primitive) {
  if (!primitive.is_object() || extension(primitive, draco) == nullptr) return false;
  if (primitive.contains("indices") && lacks_bytes(gate, primitive["indices"])) return true;
  const auto attributes = primitive.find("attributes");
  if (attributes == primitive.end() || !attributes->is_object()) return false;
  for (const auto& [semantic, number] : attributes->items()) {
    if (lacks_bytes(gate, number)) return true;
  }
  return false;
}

void refuse(Gate& gate, const std::string& place, const std::string& name) {
  gate.error(place, "unsupported-extension", fmt::format("{}: the data is compressed and has no plain copy", name),
             decode);
}

void check_draco(Gate& gate) {
  const Json& meshes = gate.all("meshes");
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const auto primitives = meshes[m].find("primitives");
    if (primitives == meshes[m].end() || !primitives->is_array()) continue;
    for (std::size_t p = 0; p < primitives->size(); ++p) {
      if (!depends_on_draco(gate, (*primitives)[p])) continue;
      refuse(gate, at(in(at("meshes", m), "primitives"), p), draco);
      return;
    }
  }
}

void check_meshopt(Gate& gate) {
  const Json& buffers = gate.all("buffers");
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    for (const char* name : meshopt) {
      const Json* coded = extension(buffers[i], name);
      if (coded == nullptr || !coded->is_object() || buffers[i].contains("uri") || !coded->contains("fallback"))
        continue;
      refuse(gate, at("buffers", i), name);
      return;
    }
  }
}

}  // namespace

void check_extensions(Gate& gate) {
  const std::set<std::string> required = names(gate, "extensionsRequired");
  names(gate, "extensionsUsed");
  bool refused = false;
  for (const std::string& name : required) {
    if (name == draco || name == meshopt[0] || name == meshopt[1]) {
      refuse(gate, "extensionsRequired", name);
      refused = true;
    } else if (!is_known_extension(name)) {
      gate.error("extensionsRequired", "unsupported-extension",
                 fmt::format("the file can not be understood without '{}', which is not known here", name),
                 "export the file without that extension");
    }
  }
  if (refused) return;
  check_draco(gate);
  check_meshopt(gate);
}

}  // namespace foredraw::gltf
