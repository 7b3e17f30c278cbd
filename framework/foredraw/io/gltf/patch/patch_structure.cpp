// Nodes, skins, animations, materials and images put back: what was added, and what may change of the old ones. Whoever
// changes anything else of the structure is told.
#include <foredraw/io/gltf/patch/private/write.h>
#include <foredraw/io/image/images.h>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace foredraw::gltf {

namespace {

std::size_t append(const std::vector<glm::mat4>& inverse_bind_matrices, AccessorStore& store) {
  const Bytes bytes = std::as_bytes(std::span(inverse_bind_matrices));
  return store.append({Content::Kind::inverse_bind_matrices,
                       {Component::float32, 16, false, 64},
                       inverse_bind_matrices.size(),
                       Shared<std::byte>({bytes.begin(), bytes.end()})});
}

Json json_of(const Skin& skin, AccessorStore& store) {
  Json json = JsonObject{{"joints", skin.joints}};
  if (!skin.name.empty()) json["name"] = skin.name;
  if (!skin.inverse_bind_matrices.empty()) json["inverseBindMatrices"] = append(skin.inverse_bind_matrices, store);
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
        document_(source.document),
        json_(json),
        store_(store),
        diagnostics_(diagnostics) {}

  bool run() {
    if (!say(patch_nodes(scene_, was_, json_, store_, left_)) || !say(old_skins()) ||
        !say(patch_animations(scene_, was_, json_, store_, left_)) || !materials() || !images()) {
      return false;
    }
    add_nodes(scene_, was_.nodes.size(), json_, store_);
    for (std::size_t i = was_.skins.size(); i < scene_.skins.size(); ++i)
      list_in(json_, "skins")[i] = json_of(scene_.skins[i], store_);
    release_unnamed(std::move(left_), document_, json_, store_);
    return true;
  }

 private:
  bool fail(const std::string& inside, const std::string& why) {
    diagnostics_.error({.file = scene_.name, .inside = inside}, "cannot-express", why + "; this cannot be written back",
                       "leave out the stage that did it");
    return false;
  }

  bool say(const std::optional<Refusal>& refusal) { return !refusal || fail(refusal->inside, refusal->why); }

  /// Their inverse bind matrices may be others.
  std::optional<Refusal> old_skins() {
    if (scene_.skins.size() < was_.skins.size()) return Refusal{"skins", "some were removed"};
    for (std::size_t i = 0; i < was_.skins.size(); ++i) {
      const Skin& now = scene_.skins[i];
      const std::vector<glm::mat4>& matrices = now.inverse_bind_matrices;
      const std::string place = "skins[" + std::to_string(i) + ']';
      if (now.name != was_.skins[i].name || now.joints != was_.skins[i].joints)
        return Refusal{place, "its name or joints were changed"};
      if (matrices == was_.skins[i].inverse_bind_matrices) continue;
      const auto is_finite = [](const glm::mat4& matrix) { return all_finite({glm::value_ptr(matrix), 16}); };
      if (matrices.size() != now.joints.size() || !std::ranges::all_of(matrices, is_finite))
        return Refusal{place, "its inverse bind matrices are not finite, or not as many as joints"};
      const std::size_t accessor = append(matrices, store_);
      Json& json = json_["skins"][i];
      if (json.contains("inverseBindMatrices")) left_.insert(json["inverseBindMatrices"].get<std::size_t>());
      json["inverseBindMatrices"] = accessor;
    }
    return std::nullopt;
  }

  bool materials() {
    if (scene_.materials.size() < was_.materials.size()) return fail("materials", "some were removed");
    for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
      const Material& now = scene_.materials[i];
      std::size_t old = i;  // a copy of a copy stems from the file too
      while (old >= was_.materials.size() && scene_.materials[old].copy_of) old = *scene_.materials[old].copy_of;
      const bool is_old = old < was_.materials.size();
      if (i >= was_.materials.size()) {
        list_in(json_, "materials")[i] = is_old ? Json(document_.json["materials"][old]) : Json::object();
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
  const Document& document_;
  Json& json_;
  AccessorStore& store_;
  Diagnostics& diagnostics_;
  std::set<std::size_t> left_;  ///< accessors that were named, where others are now
};

}  // namespace

Json& list_in(Json& holder, const char* name) {
  Json& list = holder[name];
  if (list.is_null()) list = Json::array();
  return list;
}

bool patch_structure(const Scene& scene, const Source& source, Json& json, AccessorStore& store,
                     Diagnostics& diagnostics) {
  return StructurePatch(scene, source, json, store, diagnostics).run();
}

}  // namespace foredraw::gltf
