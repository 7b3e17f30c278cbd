#include <foredraw/io/gltf/private/instances.h>

#include <map>

namespace foredraw::gltf {

namespace {

/// As many as each of the accessors has elements. What is not given is as in a node.
std::vector<Transform> instances_of(const Json& attributes, const Document& document) {
  const auto accessor = [&](const Json& number) -> const Accessor& {
    return document.accessors[number.get<std::size_t>()];
  };
  std::vector<Transform> instances(accessor(*attributes.begin()).count);
  const auto read = [&](const char* semantic, auto put) {
    const auto found = attributes.find(semantic);
    if (found == attributes.end()) return;
    const std::size_t components = accessor(*found).format.components;
    const std::vector<float> values = decoded_elements(document, accessor(*found));
    for (std::size_t i = 0; i < instances.size(); ++i) put(instances[i], &values[components * i]);
  };
  read("TRANSLATION", [](Transform& to, const float* v) { to.translation = {v[0], v[1], v[2]}; });
  read("ROTATION", [](Transform& to, const float* v) { to.rotation = glm::quat(v[3], v[0], v[1], v[2]); });
  read("SCALE", [](Transform& to, const float* v) { to.scale = {v[0], v[1], v[2]}; });
  return instances;
}

/// [instance * components + component]
struct Columns {
  explicit Columns(std::span<const Transform> instances) {
    for (const Transform& t : instances) {
      translations.insert(translations.end(), {t.translation.x, t.translation.y, t.translation.z});
      rotations.insert(rotations.end(), {t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w});
      scales.insert(scales.end(), {t.scale.x, t.scale.y, t.scale.z});
    }
  }

  std::vector<float> translations, rotations, scales;
};

}  // namespace

void add_instances(Scene& scene, const Document& document) {
  std::map<Json, Shared<Transform>> known;  // nodes that name the same accessors share them
  for (NodeId i = 0; i < scene.nodes.size(); ++i) {
    const Json* instancing = extension_of(document.json["nodes"][i], mesh_gpu_instancing);
    if (instancing == nullptr) continue;
    const Json& attributes = instancing->at("attributes");
    const auto [made, is_new] = known.try_emplace(attributes);
    if (is_new) made->second = Shared<Transform>(instances_of(attributes, document));
    scene.nodes[i].instances = made->second;
  }
}

void patch_instancing(std::span<const Transform> now, std::span<const Transform> was, Json& attributes,
                      AccessorStore& store, std::set<std::size_t>& left) {
  const auto put = [&](const char* semantic, const std::vector<float>& values, const std::vector<float>& before) {
    // Where there is no attribute, nothing says how many instances there are.
    if (values == before && !attributes.empty()) return;
    if (attributes.contains(semantic)) left.insert(attributes[semantic].get<std::size_t>());
    const auto components = static_cast<std::uint8_t>(values.size() / now.size());
    const Bytes bytes = std::as_bytes(std::span(values));
    attributes[semantic] =
        store.append({Content::Kind::other,
                      {Component::float32, components, false, static_cast<std::uint16_t>(4 * components)},
                      now.size(),
                      Shared<std::byte>({bytes.begin(), bytes.end()})});
  };
  const Columns columns(now), before(was);
  put("TRANSLATION", columns.translations, before.translations);
  put("ROTATION", columns.rotations, before.rotations);
  put("SCALE", columns.scales, before.scales);
}

Json instancing_of(std::span<const Transform> instances, AccessorStore& store) {
  Json attributes = Json::object();
  std::set<std::size_t> none;
  patch_instancing(instances, std::vector<Transform>(instances.size()), attributes, store, none);
  return JsonObject{{"attributes", std::move(attributes)}};
}

}  // namespace foredraw::gltf
