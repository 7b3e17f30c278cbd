// Checks of what the file requires: what can not be understood here is refused by name, with the remedy.
#include <foredraw/io/gltf/private/gate.h>

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

/// Whether something that is drawn, or its bytes, has the extension.
bool shapes_what_is_drawn(const Gate& gate, const std::string& name) {
  constexpr const char* drawn[] = {"accessors", "animations", "buffers", "bufferViews", "meshes", "nodes", "skins"};
  return std::ranges::any_of(drawn, [&](const char* kind) {
    const std::vector<std::string> held = extensions_in({{kind, gate.all(kind)}});
    return std::ranges::binary_search(held, name);
  });
}

}  // namespace

void check_extensions(Gate& gate) {
  const std::set<std::string> required = names(gate, "extensionsRequired");
  names(gate, "extensionsUsed");
  for (const std::string& name : required) {
    if (gate.document().knows_extension(name)) continue;
    if (!shapes_what_is_drawn(gate, name)) {
      gate.fault("required-extension", "extensionsRequired", fmt::format("the extension '{}' is not known", name));
    } else {
      gate.error("extensionsRequired", "unsupported-extension",
                 fmt::format("the file requires the extension '{}', which is not supported", name),
                 "export the file without that extension");
    }
  }
}

}  // namespace foredraw::gltf
