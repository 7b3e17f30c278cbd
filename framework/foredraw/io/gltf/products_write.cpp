// Products written.
#include <foredraw/io/gltf/patch/private/write.h>
#include <foredraw/io/gltf/private/products.h>
#include <foredraw/io/gltf/private/rows.h>
#include <foredraw/io/text/private/extension_json.h>

#include <algorithm>
#include <map>

namespace foredraw::gltf {

namespace {

class Writer final : public ExtensionWriter {
 public:
  /// `free`: accessors that only the row named so far, which take on what it names now; those that do not are left.
  /// `is_same`: the product is as it was read, and something else that it writes is not.
  Writer(const Scene& scene, const std::string& extension, bool is_same, const Document& document, Json& json,
         AccessorStore& store, std::set<std::size_t>& free)
      : extension_(extension),
        is_same_(is_same),
        document_(document),
        may_move_(document.knows_all_extensions()),
        json_(json),
        store_(store),
        free_(free),
        origins_(scene.draws.size()),
        is_put_(scene.draws.size(), false) {
    for (std::uint32_t m = 0; m < scene.meshes.size(); ++m) {
      for (std::uint32_t p = 0; p < scene.meshes[m].draws.size(); ++p) origins_[scene.meshes[m].draws[p]] = {m, p};
    }
  }

  void put_on_file(ExtensionValue value) override {
    json_["extensions"][extension_] = json_of(value);
    is_on_file_ = true;
  }

  void put_on_draw(DrawId draw, ExtensionValue value) override {
    if (!origins_[draw]) return;  // no mesh holds it
    primitive(draw)["extensions"][extension_] = json_of(value);
    is_put_[draw] = true;
  }

  /// Takes out what the file said and nobody put again; what was put stands where it stood.
  void take_the_rest() {
    if (!is_on_file_) take_extension(json_, extension_);
    for (DrawId draw = 0; draw < origins_.size(); ++draw) {
      if (origins_[draw] && !is_put_[draw]) take_extension(primitive(draw), extension_);
    }
  }

  AccessorRef accessor(const AccessorData& data) override {
    const bool are_vertices = data.use != AccessorData::Use::other;
    return put({are_vertices ? Content::Kind::vertices : Content::Kind::other, data.format, data.count, data.bytes,
                data.use == AccessorData::Use::positions});
  }

  AccessorRef indices(std::span<const std::uint32_t> indices) override {
    return put(index_content(never_empty(indices), Component::uint16));
  }

  void share_vertices(DrawId draw, const std::vector<std::pair<std::string, AccessorRef>>& attributes,
                      std::uint32_t first) override {
    if (!may_move_ || !origins_[draw]) return;
    for (const auto& [semantic, number] : primitive(draw)["attributes"].items()) {
      for (const auto& [name, whole] : attributes) {
        if (name == semantic) store_.lay_within(number.get<std::size_t>(), whole.number, first);
      }
    }
  }

 private:
  Json& primitive(DrawId draw) {
    return json_["meshes"][origins_[draw]->mesh]["primitives"][origins_[draw]->primitive];
  }

  /// An accessor with this content: one that holds it, for indices one that is free, or a new one.
  AccessorRef put(const Content& content) {
    for (const auto& [number, held] : taken_) {
      if (same_content(held, content)) return {number};
    }
    if (const auto number = store_.appended(content)) return {*number};
    const auto is_of_format = [&](std::size_t number) { return document_.accessors[number].format == content.format; };
    const auto holds_it = [&](std::size_t number) {
      const Accessor& accessor = document_.accessors[number];
      return is_of_format(number) && accessor.count == content.count &&
             std::ranges::equal(elements(document_, accessor), content.bytes.view());
    };
    const bool may_stay = is_same_ && content.kind != Content::Kind::vertices;
    auto found = may_stay ? std::ranges::find_if(free_, holds_it) : free_.end();
    const bool stays = found != free_.end();
    if (!stays && content.kind == Content::Kind::indices) found = std::ranges::find_if(free_, is_of_format);
    if (found == free_.end()) return {store_.append(content)};
    const std::size_t number = *found;
    free_.erase(found);
    if (!stays) store_.redefine(number, content);
    taken_.emplace(number, content);
    return {number};
  }

  std::string extension_;
  bool is_same_;
  const Document& document_;
  bool may_move_;
  Json& json_;
  AccessorStore& store_;
  std::set<std::size_t>& free_;
  std::map<std::size_t, Content> taken_;
  std::vector<std::optional<DrawOrigin>> origins_;  ///< [draw] its place in `json`
  std::vector<bool> is_put_;
  bool is_on_file_ = false;
};

bool stays(const ProductRow& row, const Scene& scene, const Scene& was) {
  const auto draws_of = [](const Mesh& mesh) -> const std::vector<DrawId>& { return mesh.draws; };
  return scene.products.same(row.card().name, was.products) &&
         std::ranges::equal(scene.meshes, was.meshes, {}, draws_of, draws_of) && row.is_written_alike(scene, was);
}

}  // namespace

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

void patch_products(const Scene& scene, const Scene& of_levels, const Source& source, const ProductRows& rows,
                    Json& json, AccessorStore& store, Diagnostics& diagnostics) {
  const Document& document = source.document;
  std::set<std::size_t> gone = document.let_go;
  ProductRows staying, written;
  for (const auto& row : rows) {
    const bool alike = stays(*row, scene, source.as_read);
    (alike ? staying : written).push_back(row);
    if (!alike) gone.merge(used_by_product(document.json, row->card()));
  }
  std::set<std::size_t> free = freed(gone, staying, document);
  for (const auto& row : written) {
    const ProductCard& card = row->card();
    const bool is_same = scene.products.same(card.name, source.as_read.products);
    Writer writer(scene, card.extension, is_same, document, json, store, free);
    const std::string wrong = scene.products.has(card.name) ? row->difference(of_levels) : std::string();
    if (!wrong.empty()) {
      diagnostics.warning({.file = scene.name}, card.name + "-left-out",
                          "the " + card.title + " are not written: " + wrong, card.remedy);
    } else if (scene.products.has(card.name)) {
      row->write(scene, writer);
    }
    writer.take_the_rest();
    if (has_extension(json, card.extension)) {
      list_extension(json, "extensionsUsed", card.extension);
    } else {
      unlist_extension(json, card.extension);
    }
  }
  for (const std::size_t accessor : free) store.release(accessor);
  each_primitive(json, [](Json& primitive) {
    const auto extensions = primitive.find("extensions");
    if (extensions != primitive.end() && extensions->is_null())
      primitive.erase(extensions);  // nobody told of its orders
  });
  scene.products.each([&](const std::string& name) {
    if (std::ranges::any_of(rows, [&](const auto& row) { return row->card().name == name; })) return;
    diagnostics.warning({.file = scene.name}, "product-left-out",
                        "the writer does not know the product '" + name + "'; it is left out",
                        "pass the product rows of the registry whose plugin made it");
  });
}

}  // namespace foredraw::gltf
