#include <foredraw/base/counted.h>
#include <foredraw/io/gltf/codecs/private/draco_primitives.h>
#include <foredraw/io/gltf/layout/private/accessor_store.h>
#include <foredraw/io/gltf/layout/private/layout.h>
#include <foredraw/io/gltf/patch/private/list_care.h>
#include <foredraw/io/gltf/patch/private/write.h>
#include <foredraw/io/gltf/private/each_extension.h>
#include <foredraw/io/gltf/private/levels.h>
#include <foredraw/io/gltf/private/products.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw::gltf {

namespace {

/// What came compressed by Draco goes out plain: its buffers and the plain copies beside them are left out, unless
/// somebody else names them.
void leave_draco(const Document& document, AccessorStore& store) {
  const FromDraco& from = *document.from_draco;
  for (const std::size_t view : from.views) store.forget_view(view);
  for (const std::size_t accessor : freed(from.copies, document.products, document)) store.release(accessor);
  for (const std::size_t accessor : from.accessors) store.correct_range(accessor);
}

void tell_plain(const Document& document, LaidOut& laid_out, Diagnostics& diagnostics) {
  const FromDraco& from = *document.from_draco;
  laid_out.sizes.push_back({"geometry that Draco had compressed", from.coded, from.plain});
  diagnostics.note({.file = document.name}, "draco-decompressed",
                   fmt::format("the file was compressed by Draco: {} bytes of geometry become {}", counted(from.coded),
                               counted(from.plain)));
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
  return document.from_draco ||
         std::any_of(document.views.begin(), document.views.end(), [](const auto& v) { return v.compressed; });
}

bool names_a_buffer(const Json& value) {
  if (value.is_object() && value.contains("buffer")) return true;
  return value.is_structured() && std::any_of(value.begin(), value.end(), names_a_buffer);
}

/// All buffers become one. An extension that we do not know must not be left pointing at another.
bool may_join_buffers(const Document& document) {
  bool may = true;
  each_extension(document.json, [&](const std::string& name, const Json& held) {
    may = may && (document.knows_extension(name) || !names_a_buffer(held));
  });
  return may;
}

/// An object that grows copies all that its members hold, and of a document this is everything.
Json copy_with_room(const Json& from) {
  JsonObject members;
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
  patch_products(scene, of_levels, source, as.products, written.json, store, diagnostics);
  care_for_lists(scene, document, written.json, store, diagnostics);
  relocate_images(written.json, document, target, diagnostics);
  written.changed = !may_stay || document.left_out || store.changed() || written.json != document.json ||
                    !told.same_errors() || (!compress && is_compressed(document)) || all_compressed;
  if (!written.changed) return written;
  if (document.buffers.size() > 1 && !may_join_buffers(document)) {
    diagnostics.error({.file = document.name, .inside = "buffers"}, "cannot-express",
                      "the file has several buffers, and an unknown extension refers to them by index",
                      "pack the file into one .glb first");
    return std::nullopt;
  }
  if (document.from_draco) leave_draco(document, store);
  const bool may_renumber = document.knows_all_extensions();
  const bool reorders = as.compression == Compression::draco_edgebreaker;
  const bool by_draco = (as.compression == Compression::draco || reorders) && may_renumber;
  written.laid_out = store.lay_out(compress && !by_draco);
  if (document.from_draco && !by_draco) tell_plain(document, written.laid_out, diagnostics);
  if (scene.lists.leaves_out_unnamed && may_renumber) leave_out_accessors(written.json);
  if (by_draco) {
    leave_out_accessors(written.json);
    DracoOutput how{reorders, holds_products(written.json), used_by_products(written.json, document.products)};
    how.held.merge(used_by_products(written.json, as.products));
    compress_primitives(written.json, written.laid_out, how, document.name, diagnostics);
  } else if (all_compressed && may_renumber) {
    if (scene.lists.joins_equal) join_accessors(written.json, written.laid_out);
    leave_out_accessors(written.json);
    gather_views(written.json, written.laid_out);
    compress_views(written.json, written.laid_out, as.compression == Compression::khr ? khr_meshopt : ext_meshopt,
                   as.turns_corners);
  } else if (all_compressed) {
    diagnostics.note({.file = document.name, .inside = "extensionsUsed"}, "not-compressed",
                     "an unknown extension may refer to buffer views, which stay as they are");
  }
  unlist_what_is_not_used(written.json);
  told.enclose(written.json);
  return written;
}

}  // namespace foredraw::gltf
