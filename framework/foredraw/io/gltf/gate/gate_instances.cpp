// Checks of how often nodes draw: EXT_mesh_gpu_instancing, and the number of draws in all.
#include <foredraw/io/gltf/gate/private/gate.h>

#include <fmt/format.h>

namespace foredraw::gltf {

namespace {

bool is_float_or_small_fraction(const Format& format) {
  if (format.component == Component::float32) return true;
  return format.normalized && (format.component == Component::int8 || format.component == Component::int16);
}

/// Of an accessor that places instances.
void check_format(Gate& gate, const std::string& semantic, const Format& format, std::size_t number,
                  const std::string& place) {
  const bool turns = semantic == "ROTATION";
  if (!turns && semantic != "TRANSLATION" && semantic != "SCALE") return;  // for whoever gave it its name
  if (turns ? format.components == 4 && is_float_or_small_fraction(format)
            : format.components == 3 && format.component == Component::float32) {
    return;
  }
  gate.error(place, "accessor-type",
             fmt::format("accessor {} must be {}", number,
                         turns ? "VEC4 of floats, or of normalized 8- or 16-bit integers" : "VEC3 of floats"));
}

void check_attributes(Gate& gate, const Json& attributes, const std::string& place) {
  if (attributes.empty()) gate.error(place, "out-of-range", "must not be empty");
  std::optional<std::size_t> count;
  for (const auto& [semantic, value] : attributes.items()) {
    const auto number = gate.reference(value, "accessors", in(place, semantic));
    const Accessor* accessor = gate.accessor(number);
    if (accessor == nullptr) continue;
    check_format(gate, semantic, accessor->format, *number, in(place, semantic));
    if (!count) count = accessor->count;
    if (*count == accessor->count) continue;
    gate.error(
        in(place, semantic), "unequal-counts",
        fmt::format("accessor {} has {} elements, but the first attribute has {}", *number, accessor->count, *count));
  }
}

/// How often a node draws its mesh.
std::uint64_t instances(const Gate& gate, const Json& node) {
  const Json* instancing = extension_of(node, mesh_gpu_instancing);
  if (instancing == nullptr) return 1;
  return gate.accessor((*instancing)["attributes"].begin()->get<std::size_t>())->count;
}

/// A mesh of many primitives on many nodes is drawn their product of times, all of which are seen and judged one by
/// one.
void check_draw_calls(Gate& gate) {
  constexpr std::uint64_t most = 1 << 22;
  std::uint64_t draws = 0;
  const Json& nodes = gate.all("nodes");
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].contains("mesh")) continue;
    draws += gate.all("meshes")[nodes[i]["mesh"].get<std::size_t>()]["primitives"].size() * instances(gate, nodes[i]);
    if (draws <= most) continue;
    gate.error(at("nodes", i), "too-many-draws",
               fmt::format("the nodes up to this one draw more than {} primitives", most));
    return;
  }
}

}  // namespace

void check_instances(Gate& gate) {
  const Json& nodes = gate.all("nodes");
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (extension_of(nodes[i], mesh_gpu_instancing) == nullptr) continue;
    const std::string extensions = in(at("nodes", i), "extensions");
    const std::string place = in(extensions, mesh_gpu_instancing);
    const Json* instancing = gate.object(nodes[i]["extensions"], mesh_gpu_instancing, extensions);
    if (instancing == nullptr) continue;
    gate.required(*instancing, "attributes", place);
    const Json* attributes = gate.object(*instancing, "attributes", place);
    if (attributes != nullptr) check_attributes(gate, *attributes, in(place, "attributes"));
  }
  if (gate.sound()) check_draw_calls(gate);
}

}  // namespace foredraw::gltf
