#include <foredraw/io/private/gltf_accessor_store.h>
#include <foredraw/io/private/gltf_write.h>

#include <algorithm>

namespace foredraw::gltf {

namespace {

constexpr const char* compressions[] = {"KHR_draco_mesh_compression", "EXT_meshopt_compression",
                                        "KHR_meshopt_compression"};

/// The extension's value taken out of an object; null where it has none.
Json take_extension(Json& holder, const char* name) {
  const auto extensions = holder.find("extensions");
  if (extensions == holder.end() || !extensions->is_object() || !extensions->contains(name)) return {};
  Json value = (*extensions)[name];
  extensions->erase(name);
  if (extensions->empty()) holder.erase("extensions");
  return value;
}

/// Everything that held the extension loses it. Views that only the extension knew of go with it.
bool drop_extension(Json& json, const char* name, AccessorStore& store) {
  bool dropped = false;
  for (const char* kind : {"bufferViews", "buffers"}) {
    for (std::size_t i = 0; json.contains(kind) && i < json[kind].size(); ++i) {
      dropped = !take_extension(json[kind][i], name).is_null() || dropped;
    }
  }
  for (std::size_t m = 0; json.contains("meshes") && m < json["meshes"].size(); ++m) {
    for (Json& primitive : json["meshes"][m]["primitives"]) {
      const Json value = take_extension(primitive, name);
      const auto view = value.find("bufferView");
      if (view != value.end() && view->is_number_unsigned()) store.forget_view(view->get<std::size_t>());
      dropped = !value.is_null() || dropped;
    }
  }
  const auto used = json.find("extensionsUsed");
  if (used == json.end()) return dropped;
  if (const auto listed = std::find(used->begin(), used->end(), Json(name)); listed != used->end()) used->erase(listed);
  if (used->empty()) json.erase("extensionsUsed");
  return dropped;
}

/// A compressed copy beside the plain data would go on showing what was before.
void drop_compressed_copies(Json& json, AccessorStore& store, const Document& document, Diagnostics& diagnostics) {
  bool dropped = false;
  for (const char* name : compressions) dropped = drop_extension(json, name, store) || dropped;
  if (!dropped) return;
  diagnostics.note({.file = document.name, .inside = "extensionsUsed"}, "compressed-copy-dropped",
                   "the compressed copy of the geometry is left out, as it no longer fits; the plain data is written");
}

bool names_a_buffer(const Json& value) {
  if (value.is_object() && value.contains("buffer")) return true;
  return value.is_structured() && std::any_of(value.begin(), value.end(), names_a_buffer);
}

/// All buffers become one. An extension that we do not know must not be left pointing at another.
bool may_join_buffers(const Json& value) {
  if (!value.is_structured()) return true;
  for (const auto& [key, part] : value.items()) {
    if (value.is_object() && key == "extensions" && part.is_object()) {
      for (const auto& [name, held] : part.items()) {
        if (!is_known_extension(name) && names_a_buffer(held)) return false;
      }
    }
    if (!may_join_buffers(part)) return false;
  }
  return true;
}

}  // namespace

std::optional<Written> patched(const Scene& scene, const Source& source, const std::filesystem::path& target,
                               bool may_stay, Diagnostics& diagnostics) {
  const Document& document = source.document;
  Written written;
  written.json = document.json;
  written.further_chunks = document.further_chunks;
  AccessorStore store(document, written.json);
  if (!patch_structure(scene, source, written.json, store, diagnostics)) return std::nullopt;
  if (!patch_meshes(scene, source, written.json, store, diagnostics)) return std::nullopt;
  relocate_images(written.json, document, target, diagnostics);
  written.changed = !may_stay || store.changed() || written.json != document.json;
  if (!written.changed) return written;
  if (document.buffers.size() > 1 && !may_join_buffers(document.json)) {
    diagnostics.error({.file = document.name, .inside = "buffers"}, "cannot-express",
                      "the file has several buffers, and an extension that is not known here refers to them by number",
                      "pack the file into one .glb first");
    return std::nullopt;
  }
  drop_compressed_copies(written.json, store, document, diagnostics);
  written.buffer = store.lay_out();
  return written;
}

}  // namespace foredraw::gltf
