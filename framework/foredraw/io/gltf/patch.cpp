#include <foredraw/io/gltf/private/accessor_store.h>
#include <foredraw/io/gltf/private/layout.h>
#include <foredraw/io/gltf/private/levels.h>
#include <foredraw/io/gltf/private/products.h>
#include <foredraw/io/gltf/private/write.h>

#include <algorithm>

namespace foredraw::gltf {

namespace {

constexpr const char* draco = "KHR_draco_mesh_compression";

/// A Draco stream holds a whole primitive beside its plain data, and would go on showing what was before. Views that
/// only the extension knew of go with it.
void drop_draco(Json& json, AccessorStore& store, const Document& document, Diagnostics& diagnostics) {
  bool dropped = false;
  for (std::size_t m = 0; json.contains("meshes") && m < json["meshes"].size(); ++m) {
    for (Json& primitive : json["meshes"][m]["primitives"]) {
      const Json value = take_extension(primitive, draco);
      const auto view = value.find("bufferView");
      if (view != value.end() && view->is_number_unsigned()) store.forget_view(view->get<std::size_t>());
      dropped = !value.is_null() || dropped;
    }
  }
  unlist_extension(json, draco);
  if (!dropped) return;
  diagnostics.note(
      {.file = document.name, .inside = "extensionsUsed"}, "compressed-copy-dropped",
      "the Draco copy of the geometry is left out, because it no longer matches; the uncompressed data is written");
}

void unlist_what_is_not_used(Json& json) {
  for (const char* name : meshopt_extensions) {
    const auto views = json.find("bufferViews");
    const bool used = views != json.end() && std::any_of(views->begin(), views->end(), [&](const Json& view) {
                        return extension_of(view, name) != nullptr;
                      });
    if (!used) unlist_extension(json, name);
  }
}

bool is_compressed(const Document& document) {
  const std::vector<std::string> names = extensions_in(document.json);
  return std::any_of(document.views.begin(), document.views.end(), [](const auto& v) { return v.compressed; }) ||
         std::find(names.begin(), names.end(), draco) != names.end();
}

bool names_a_buffer(const Json& value) {
  if (value.is_object() && value.contains("buffer")) return true;
  return value.is_structured() && std::any_of(value.begin(), value.end(), names_a_buffer);
}

/// All buffers become one. An extension that we do not know must not be left pointing at another.
bool may_join_buffers(const Json& value, const Document& document) {
  if (!value.is_structured()) return true;
  for (const auto& [key, part] : value.items()) {
    if (value.is_object() && key == "extensions" && part.is_object()) {
      for (const auto& [name, held] : part.items()) {
        if (!document.knows_extension(name) && names_a_buffer(held)) return false;
      }
    }
    if (!may_join_buffers(part, document)) return false;
  }
  return true;
}

/// An object that grows copies all that its members hold, and of a document this is everything.
Json copy_with_room(const Json& from) {
  Json::object_t members;
  members.reserve(from.size() + 16);
  for (const auto& [key, value] : from.items()) members.emplace_back(key, value);
  return members;
}

}  // namespace

std::optional<Written> patched(const Scene& of_levels, const Source& source, const std::filesystem::path& target,
                               bool may_stay, const GltfOutput& as, Diagnostics& diagnostics) {
  const Document& document = source.document;
  const LevelScene told(of_levels, source, as.levels, diagnostics);
  const Scene& scene = told.flat();
  const bool compress = as.compression != Compression::none;
  const bool all_compressed = compress && as.compression != Compression::keep;
  Written written;
  written.json = copy_with_room(document.json);
  written.further_chunks = document.further_chunks;
  const auto text = document.file.view();
  const std::size_t last = text.empty() ? 0 : text.size() - 1;
  written.compact = !text.empty() && !document.binary && std::ranges::count(text.first(last), std::byte{'\n'}) == 0;
  AccessorStore store(document, written.json);
  if (!patch_structure(scene, source, written.json, store, diagnostics)) return std::nullopt;
  told.put_lods(written.json);
  if (!patch_meshes(scene, source, as.products, written.json, store, diagnostics)) return std::nullopt;
  patch_products(scene, source, as.products, written.json, store, diagnostics);
  relocate_images(written.json, document, target, diagnostics);
  written.changed = !may_stay || document.left_out || store.changed() || written.json != document.json ||
                    !told.same_errors() || (!compress && is_compressed(document)) || all_compressed;
  if (!written.changed) return written;
  if (document.buffers.size() > 1 && !may_join_buffers(document.json, document)) {
    diagnostics.error({.file = document.name, .inside = "buffers"}, "cannot-express",
                      "the file has several buffers, and an unknown extension refers to them by index",
                      "pack the file into one .glb first");
    return std::nullopt;
  }
  drop_draco(written.json, store, document, diagnostics);
  written.laid_out = store.lay_out(compress);
  if (all_compressed && document.knows_all_extensions()) {
    compress_views(written.json, written.laid_out, as.compression == Compression::khr ? khr_meshopt : ext_meshopt);
  } else if (all_compressed) {
    diagnostics.note({.file = document.name, .inside = "extensionsUsed"}, "not-compressed",
                     "an unknown extension may refer to buffer views, which stay as they are");
  }
  unlist_what_is_not_used(written.json);
  told.enclose(written.json);
  return written;
}

}  // namespace foredraw::gltf
