// Who names which entry of which list.
#include <foredraw/io/gltf/patch/private/list_care.h>

#include <algorithm>

namespace foredraw::gltf {

namespace {

using Visit = std::function<void(const char* list, Json& number, Tie tie)>;

template <class See>
void each_in(Json& holder, const char* key, See see) {
  const auto found = holder.find(key);
  if (found == holder.end() || !found->is_array()) return;
  for (Json& one : *found) see(one);
}

void name_one(Json& holder, const char* key, const char* list, const Visit& visit) {
  const auto found = holder.find(key);
  if (found != holder.end() && found->is_number_unsigned()) visit(list, *found, Tie::uses);
}

/// Of an object's extension, if it is an object.
Json* extension_in(Json& holder, const char* name) {
  if (extension_of(holder, name) == nullptr) return nullptr;
  Json& value = holder["extensions"][name];
  return value.is_object() ? &value : nullptr;
}

void name_coarser(Json& holder, const char* list, const Visit& visit) {
  Json* lod = extension_in(holder, "MSFT_lod");
  if (lod != nullptr) each_in(*lod, "ids", [&](Json& number) { visit(list, number, Tie::uses); });
}

/// Extensions hold uses of textures, too, all called something with "Texture".
void name_textures(Json& value, const Visit& visit) {
  if (!value.is_object()) return;
  for (auto&& [name, part] : value.items()) {
    if (name == "extras" || !part.is_object()) continue;
    if (name.ends_with("Texture")) name_one(part, "index", "textures", visit);
    name_textures(part, visit);
  }
}

constexpr const char* image_holders[] = {"KHR_texture_basisu", "EXT_texture_webp", "EXT_texture_avif",
                                         "MSFT_texture_dds"};

}  // namespace

bool names_seen_entries(std::string_view extension) {
  static constexpr std::string_view names[] = {"KHR_texture_transform",   "KHR_lights_punctual",
                                               "EXT_lights_image_based",  "KHR_mesh_quantization",
                                               "KHR_animation_pointer",   "KHR_draco_mesh_compression",
                                               "EXT_meshopt_compression", "KHR_meshopt_compression",
                                               "EXT_mesh_gpu_instancing", "KHR_node_visibility",
                                               "KHR_node_hoverability",   "KHR_node_selectability",
                                               "FB_ngon_encoding",        "MSFT_lod",
                                               "GODOT_single_root"};
  const auto is = [&](std::string_view name) { return name == extension; };
  return extension.starts_with("KHR_materials_") || extension.starts_with("KHR_xmp") ||
         extension.starts_with("FOREDRAW_") || std::ranges::any_of(names, is) || std::ranges::any_of(image_holders, is);
}

void each_entry_named(Json& json, const Visit& visit) {
  each_in(json, "scenes",
          [&](Json& scene) { each_in(scene, "nodes", [&](Json& number) { visit("nodes", number, Tie::holds); }); });
  each_in(json, "nodes", [&](Json& node) {
    each_in(node, "children", [&](Json& number) { visit("nodes", number, Tie::holds); });
    name_one(node, "mesh", "meshes", visit);
    name_one(node, "skin", "skins", visit);
    name_one(node, "camera", "cameras", visit);
    name_coarser(node, "nodes", visit);
  });
  each_in(json, "skins", [&](Json& skin) {
    each_in(skin, "joints", [&](Json& number) { visit("nodes", number, Tie::uses); });
    name_one(skin, "skeleton", "nodes", visit);
  });
  each_in(json, "animations", [&](Json& animation) {
    each_in(animation, "channels", [&](Json& channel) { name_one(channel["target"], "node", "nodes", visit); });
  });
  each_primitive(json, [&](Json& primitive) {
    name_one(primitive, "material", "materials", visit);
    if (Json* variants = extension_in(primitive, "KHR_materials_variants")) {
      each_in(*variants, "mappings", [&](Json& mapping) {
        if (mapping.is_object()) name_one(mapping, "material", "materials", visit);
      });
    }
  });
  each_in(json, "materials", [&](Json& material) {
    name_textures(material, visit);
    name_coarser(material, "materials", visit);
  });
  each_in(json, "textures", [&](Json& texture) {
    name_one(texture, "sampler", "samplers", visit);
    name_one(texture, "source", "images", visit);
    for (const char* holder : image_holders) {
      if (Json* extension = extension_in(texture, holder)) name_one(*extension, "source", "images", visit);
    }
  });
  if (Json* lights = extension_in(json, "EXT_lights_image_based")) {
    each_in(*lights, "lights", [&](Json& light) {
      if (!light.is_object()) return;
      each_in(light, "specularImages", [&](Json& faces) {
        for (Json& number : faces) {
          if (number.is_number_unsigned()) visit("images", number, Tie::uses);
        }
      });
    });
  }
}

}  // namespace foredraw::gltf
