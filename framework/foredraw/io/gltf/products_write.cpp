// Products written.
#include <foredraw/io/gltf/private/products.h>
#include <foredraw/io/gltf/private/rows.h>
#include <foredraw/io/text/private/extension_json.h>
#include <foredraw/io/gltf/private/write.h>

#include <algorithm>
#include <map>

namespace foredraw::gltf {

namespace {

class Writer final : public ExtensionWriter {
 public:
  /// `free`: accessors that only the row named so far, which take on what it names now; those that do not are left.
  Writer(const Scene& scene, const std::string& extension, const Document& document, Json& json, AccessorStore& store,
         std::set<std::size_t>& free)
      : extension_(extension), document_(document), may_move_(document.knows_all_extensions()), json_(json), store_(store),
        free_(free), primitives_(scene.draws.size(), nullptr) {
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
      for (std::size_t p = 0; p < scene.meshes[m].draws.size(); ++p) {
        primitives_[scene.meshes[m].draws[p]] = &json["meshes"][m]["primitives"][p];
      }
    }
  }

  void put_on_file(ExtensionValue value) override { json_["extensions"][extension_] = json_of(value); }

  void put_on_draw(DrawId draw, ExtensionValue value) override {
    if (Json* primitive = primitives_[draw]) (*primitive)["extensions"][extension_] = json_of(value);
  }

  AccessorRef accessor(const AccessorData& data) override {
    const bool are_vertices = data.use != AccessorData::Use::other;
    return put({are_vertices ? Content::Kind::vertices : Content::Kind::other, data.format, data.count, data.bytes,
                data.use == AccessorData::Use::positions});
  }

  AccessorRef indices(std::span<const std::uint32_t> indices) override {
    return put(index_content(indices, Component::uint16));
  }

  void share_vertices(DrawId draw, const std::vector<std::pair<std::string, AccessorRef>>& attributes,
                      std::uint32_t first) override {
    if (!may_move_ || primitives_[draw] == nullptr) return;
    for (const auto& [semantic, number] : (*primitives_[draw])["attributes"].items()) {
      for (const auto& [name, whole] : attributes) {
        if (name == semantic) store_.lay_within(number.get<std::size_t>(), whole.number, first);
      }
    }
  }

 private:
  AccessorRef put(const Content& content) {
    for (const auto& [number, held] : taken_) {
      if (same_content(held, content)) return {number};
    }
    const auto found = std::ranges::find_if(free_, [&](std::size_t number) { return document_.accessors[number].format == content.format; });
    // Vertices, of which others may be a part, are laid out anew.
    if (found == free_.end() || content.kind == Content::Kind::vertices) return {store_.append(content)};
    const std::size_t number = *found;
    free_.erase(found);
    store_.redefine(number, content);
    taken_.emplace(number, content);
    return {number};
  }

  std::string extension_;
  const Document& document_;
  bool may_move_;
  Json& json_;
  AccessorStore& store_;
  std::set<std::size_t>& free_;
  std::map<std::size_t, Content> taken_;
  std::vector<Json*> primitives_;  ///< [draw]; null: no mesh holds it
};

bool stays(const ProductRow& row, const Scene& scene, const Scene& was) {
  const auto draws_of = [](const Mesh& mesh) -> const std::vector<DrawId>& { return mesh.draws; };
  return scene.products.same(row.card().name, was.products) &&
         std::ranges::equal(scene.meshes, was.meshes, {}, draws_of, draws_of) && row.is_written_alike(scene, was);
}

/// Those of `gone` that nobody else names.
std::set<std::size_t> freed(const std::set<std::size_t>& gone, const ProductRows& others, const Document& document) {
  if (gone.empty()) return {};
  std::set<std::size_t> used = used_elsewhere(document);
  used.merge(used_by_primitives(document.json));
  used.merge(used_by_products(document.json, others));
  std::set<std::size_t> free;
  for (const std::size_t accessor : gone) {
    const bool is_there = accessor < document.accessors.size() && document.accessors[accessor].count > 0;
    if (is_there && !used.contains(accessor)) free.insert(accessor);
  }
  return free;
}

}  // namespace

void patch_products(const Scene& scene, const Source& source, const ProductRows& rows, Json& json, AccessorStore& store,
                    Diagnostics& diagnostics) {
  const Document& document = source.document;
  std::set<std::size_t> gone = document.let_go;
  ProductRows staying, written;
  for (const auto& row : rows) {
    const bool alike = stays(*row, scene, source.as_read);
    (alike ? staying : written).push_back(row);
    if (!alike) gone.merge(used_by_product(document.json, *row));
  }
  std::set<std::size_t> free = freed(gone, staying, document);
  for (const auto& row : written) {
    const ProductCard card = row->card();
    take_extension_everywhere(json, card.extension);
    const std::string wrong = scene.products.has(card.name) ? row->difference(scene) : std::string();
    if (!wrong.empty()) {
      diagnostics.warning({.file = scene.name}, card.name + "-left-out",
                          "the " + card.title + " are not written: " + wrong, card.remedy);
    } else if (scene.products.has(card.name)) {
      Writer writer(scene, card.extension, document, json, store, free);
      row->write(scene, writer);
    }
    if (has_extension(json, card.extension)) {
      list_extension(json, "extensionsUsed", card.extension);
    } else {
      unlist_extension(json, card.extension);
    }
  }
  for (const std::size_t accessor : free) store.release(accessor);
  scene.products.each([&](const std::string& name) {
    if (std::ranges::any_of(rows, [&](const auto& row) { return row->card().name == name; })) return;
    diagnostics.warning({.file = scene.name}, "product-left-out", "no row tells how '" + name + "' is written; it is left out",
                        "hand the writer the rows of the registry that made it");
  });
}

}  // namespace foredraw::gltf
