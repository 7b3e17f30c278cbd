// Nodes, skins, animations, materials and images put back: additions, changed materials and images, and nodes without
// the mesh that they had. Nothing else of the structure may change, and whoever changes it is told.
#include <foredraw/io/gltf/private/instances.h>
#include <foredraw/io/gltf/private/write.h>
#include <foredraw/io/image/images.h>
#include <foredraw/scene/walk.h>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace foredraw::gltf {

namespace {

std::vector<NodeId> sorted(std::vector<NodeId> nodes) {
  std::ranges::sort(nodes);
  return nodes;
}

/// The children may come in another sequence.
bool same_but_for_mesh(const Node& a, const Node& b) {
  return a.name == b.name && a.transform.translation == b.transform.translation &&
         a.transform.rotation == b.transform.rotation && a.transform.scale == b.transform.scale &&
         a.matrix == b.matrix && a.skin == b.skin && a.weights == b.weights && a.instances == b.instances &&
         sorted(a.children) == sorted(b.children);
}

bool same(const Skin& a, const Skin& b) {
  return a.name == b.name && a.joints == b.joints && a.inverse_bind_matrices == b.inverse_bind_matrices;
}

Json numbers(const float* from, int count) {
  Json result = Json::array();
  for (int i = 0; i < count; ++i) result.push_back(from[i]);
  return result;
}

/// The list of that name, which is made where there is none: what the library makes of null can not be freed where
/// memory runs out in it.
Json& list_in(Json& holder, const char* name) {
  Json& list = holder[name];
  if (list.is_null()) list = Json::array();
  return list;
}

Json json_of(const Node& node) {
  Json json = Json::object();
  if (!node.name.empty()) json["name"] = node.name;
  if (node.matrix) {
    json["matrix"] = numbers(glm::value_ptr(*node.matrix), 16);
  } else {
    const Transform& t = node.transform;
    if (t.translation != glm::vec3(0)) json["translation"] = numbers(glm::value_ptr(t.translation), 3);
    if (t.rotation != glm::quat(1, 0, 0, 0))
      json["rotation"] = {t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w};
    if (t.scale != glm::vec3(1)) json["scale"] = numbers(glm::value_ptr(t.scale), 3);
  }
  if (node.mesh) json["mesh"] = *node.mesh;
  if (node.skin) json["skin"] = *node.skin;
  if (!node.weights.empty()) json["weights"] = node.weights;
  if (!node.children.empty()) json["children"] = node.children;
  return json;
}

Json json_of(const Skin& skin, AccessorStore& store) {
  Json json = JsonObject{{"joints", skin.joints}};
  if (!skin.name.empty()) json["name"] = skin.name;
  if (skin.inverse_bind_matrices.empty()) return json;
  const Bytes bytes = std::as_bytes(std::span(skin.inverse_bind_matrices));
  const Content matrices{Content::Kind::inverse_bind_matrices,
                         {Component::float32, 16, false, 64},
                         skin.inverse_bind_matrices.size(),
                         Shared<std::byte>({bytes.begin(), bytes.end()})};
  json["inverseBindMatrices"] = store.append(matrices);
  return json;
}

std::string media_type_of(std::span<const std::byte> bytes) {
  const auto starts = [&](std::initializer_list<unsigned char> with) {
    return bytes.size() >= with.size() && std::equal(with.begin(), with.end(), bytes.begin(),
                                                     [](unsigned char a, std::byte b) { return std::byte{a} == b; });
  };
  if (starts({0x89, 'P', 'N', 'G'})) return "image/png";
  if (starts({0xFF, 0xD8, 0xFF})) return "image/jpeg";
  return {};
}

class StructurePatch {
 public:
  StructurePatch(const Scene& scene, const Source& source, Json& json, AccessorStore& store, Diagnostics& diagnostics)
      : scene_(scene),
        was_(source.as_read),
        json_as_read_(source.document.json),
        json_(json),
        store_(store),
        diagnostics_(diagnostics) {}

  bool run() {
    bool said = old_nodes();
    said = unchanged(scene_.skins, was_.skins, "skins") && said;
    said = animations() && said;
    if (!said || !materials() || !images()) return false;
    add_nodes();
    for (std::size_t i = was_.skins.size(); i < scene_.skins.size(); ++i)
      list_in(json_, "skins")[i] = json_of(scene_.skins[i], store_);
    return true;
  }

 private:
  bool fail(const std::string& inside, const std::string& why) {
    diagnostics_.error({.file = scene_.name, .inside = inside}, "cannot-express", why + "; this cannot be written back",
                       "leave out the stage that did it");
    return false;
  }

  template <class T>
  bool unchanged(const std::vector<T>& now, const std::vector<T>& was, const char* kind) {
    if (now.size() < was.size()) return fail(kind, "some were removed");
    for (std::size_t i = 0; i < was.size(); ++i) {
      if (!same(now[i], was[i])) return fail(std::string(kind) + '[' + std::to_string(i) + ']', "it was changed");
    }
    return true;
  }

  bool animations() {
    if (scene_.animations.size() < was_.animations.size()) return fail("animations", "some were removed");
    const auto changed = patch_animations(scene_.animations, was_.animations, json_, store_);
    return !changed || fail(*changed, "channels were added or moved, or all are gone");
  }

  bool old_nodes() {
    if (scene_.nodes.size() < was_.nodes.size()) return fail("nodes", "some were removed");
    for (std::size_t i = 0; i < was_.nodes.size(); ++i) {
      if (!old_node(i, scene_.nodes[i], was_.nodes[i])) return false;
    }
    return old_roots();
  }

  /// They may come in another sequence.
  bool old_roots() {
    std::vector<NodeId> now = scene_.roots;
    std::erase_if(now, [&](NodeId root) { return root >= was_.nodes.size(); });
    if (now == was_.roots) return true;
    if (sorted(now) != sorted(was_.roots)) return fail("the scene's roots", "some were added or removed");
    json_["scenes"][json_.value("scene", std::size_t{0})]["nodes"] = now;
    return true;
  }

  /// As it was, but for the sequence of its children; or without its mesh, which another node may draw.
  bool old_node(std::size_t i, const Node& now, const Node& was) {
    const std::string place = "nodes[" + std::to_string(i) + ']';
    if (!same_but_for_mesh(now, was)) return fail(place, "it was changed");
    if (now.children != was.children) json_["nodes"][i]["children"] = now.children;
    if (now.mesh == was.mesh) return true;
    const bool is_drawn_plainly = !was.skin && was.weights.empty() && was.instances.empty();
    if (now.mesh || !is_drawn_plainly) return fail(place, "it was changed");
    if (was.keeps_mesh) {
      return fail(place,
                  "its mesh was removed, but an extension or a further scene refers to it, or no scene shows it");
    }
    json_["nodes"][i].erase("mesh");
    return true;
  }

  void add_nodes() {
    for (std::size_t i = was_.nodes.size(); i < scene_.nodes.size(); ++i) {
      list_in(json_, "nodes")[i] = json_of(scene_.nodes[i]);
      if (const auto instances = scene_.nodes[i].instances.view(); !instances.empty()) {
        json_["nodes"][i]["extensions"][mesh_gpu_instancing] = instancing_of(instances, store_);
        // Who does not know it would show one where there are many, also in a file that could do without it so far.
        for (const char* list : {"extensionsUsed", "extensionsRequired"}) listed(json_[list], mesh_gpu_instancing);
      }
    }
    for (const NodeId root : roots_of(scene_)) {
      if (root < was_.nodes.size() || !scene_.nodes[root].is_shown) continue;  // a coarser node is in no scene
      if (!json_.contains("scene")) json_["scene"] = 0;
      Json& scene = list_in(json_, "scenes")[json_["scene"].get<std::size_t>()];
      if (scene.is_null()) scene = Json::object();
      list_in(scene, "nodes").push_back(root);
    }
  }

  bool materials() {
    if (scene_.materials.size() < was_.materials.size()) return fail("materials", "some were removed");
    for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
      const Material& now = scene_.materials[i];
      std::size_t old = i;  // a copy of a copy stems from the file too
      while (old >= was_.materials.size() && scene_.materials[old].copy_of) old = *scene_.materials[old].copy_of;
      const bool is_old = old < was_.materials.size();
      if (i >= was_.materials.size()) {
        list_in(json_, "materials")[i] = is_old ? Json(json_as_read_["materials"][old]) : Json::object();
      }
      const Material was = is_old ? was_.materials[old] : Material{};
      put_material(i, now, was, json_);
    }
    return true;
  }

  bool images() {
    if (scene_.images.size() < was_.images.size()) return fail("images", "some were removed");
    for (std::size_t i = 0; i < scene_.images.size(); ++i) {
      const bool is_new = i >= was_.images.size();
      if (!image(i, scene_.images[i], is_new ? Image{} : was_.images[i])) return false;
    }
    return true;
  }

  bool image(std::size_t i, const Image& now, const Image& was) {
    if (i >= was_.images.size()) list_in(json_, "images")[i] = Json::object();
    Json& json = json_["images"][i];
    if (now.name != was.name) json["name"] = now.name;
    if (!now.uri.empty() && now.uri != was.uri) {
      if (json.contains("bufferView"))
        return fail("images[" + std::to_string(i) + "]", "its bytes were replaced by a file name");
      json["uri"] = now.uri;
    }
    if (now.is_texels) {
      const auto bytes = now.bytes.view();
      store_.set_image(i, Shared<std::byte>(encode_png({*now.facts, {bytes.begin(), bytes.end()}})));
      json["mimeType"] = "image/png";
    } else if (now.uri.empty() && !(now.bytes == was.bytes)) {
      const std::string type = now.media_type.empty() ? media_type_of(now.bytes.view()) : now.media_type;
      if (type.empty() || now.bytes.empty()) return fail("images[" + std::to_string(i) + "]", "its type is unknown");
      store_.set_image(i, now.bytes);
      json["mimeType"] = type;
    }
    return true;
  }

  const Scene& scene_;
  const Scene& was_;
  const Json& json_as_read_;
  Json& json_;
  AccessorStore& store_;
  Diagnostics& diagnostics_;
};

}  // namespace

bool patch_structure(const Scene& scene, const Source& source, Json& json, AccessorStore& store,
                     Diagnostics& diagnostics) {
  return StructurePatch(scene, source, json, store, diagnostics).run();
}

}  // namespace foredraw::gltf
