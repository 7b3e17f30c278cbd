// Products read: their extensions are optional, so what is wrong in one costs it alone.
#include <foredraw/io/gltf/private/products.h>
#include <foredraw/io/text/private/extension_json.h>

#include <map>

namespace foredraw::gltf {

namespace {

class Reader final : public ExtensionReader {
 public:
  Reader(const Document& document, const Scene& scene, const std::string& extension) : document_(document) {
    if (const Json* json = extension_of(document.json, extension)) file_ = value_of(*json);
    for (DrawId draw = 0; draw < scene.draws.size(); ++draw) {
      const auto& [mesh, number] = *scene.draws[draw].origin;
      const Json& primitive = document.json["meshes"][mesh]["primitives"][number];
      const Json* json = extension_of(primitive, extension);
      if (json != nullptr) draws_.emplace(draw, OnDraw{value_of(*json), primitive.value("mode", 4) == 4});
    }
  }

  bool is_empty() const { return !file_ && draws_.empty(); }

  const ExtensionValue* of_file() const override { return file_ ? &*file_ : nullptr; }

  const ExtensionValue* of_draw(DrawId draw) const override {
    const auto found = draws_.find(draw);
    return found == draws_.end() ? nullptr : &found->second.value;
  }

  bool is_list(DrawId draw) const override {
    const auto found = draws_.find(draw);
    return found != draws_.end() && found->second.is_list;
  }

  std::uint64_t bytes() const override {
    std::uint64_t sum = 0;
    for (const Accessor& accessor : document_.accessors) sum += accessor.bytes();
    return sum;
  }

  std::optional<AccessorData> accessor(std::size_t number) override {
    if (number >= document_.accessors.size() || document_.accessors[number].count == 0) return std::nullopt;
    const Accessor& accessor = document_.accessors[number];
    const auto [made, is_new] = bytes_.try_emplace(number);
    if (is_new) made->second = Shared<std::byte>(elements(document_, accessor));
    return AccessorData{accessor.format, accessor.count, made->second};
  }

 private:
  const Document& document_;
  std::optional<ExtensionValue> file_;
  struct OnDraw {
    ExtensionValue value;
    bool is_list = false;
  };
  std::map<DrawId, OnDraw> draws_;
  std::map<std::size_t, Shared<std::byte>> bytes_;  ///< each accessor's once, however often it is named
};

/// What is wrong with the first of them; empty: all that the extension names is there.
std::string broken_accessor(const Document& document, const ProductCard& card) {
  if (document.broken.empty()) return {};
  for (const std::size_t number : used_by_product(document.json, card)) {
    const auto found = document.broken.find(number);
    if (found != document.broken.end()) return found->second;
  }
  return {};
}

}  // namespace

bool read_products(Document& document, Scene& scene, bool strict, Diagnostics& diagnostics) {
  bool all_hold = true;
  for (const auto& row : document.products) {
    const ProductCard& card = row->card();
    Reader reader(document, scene, card.extension);
    if (reader.is_empty()) continue;
    Scene with = scene;
    std::string wrong = broken_accessor(document, card);
    if (wrong.empty()) wrong = row->read(reader, with);
    if (wrong.empty()) wrong = row->difference(with);
    if (wrong.empty()) {
      scene = std::move(with);
      continue;
    }
    tell_taken_out(document.name, card, wrong, strict, diagnostics);
    take_out(document, card);
    all_hold = false;
  }
  mark_held_draws(scene, document.products);
  return all_hold || !strict;
}

}  // namespace foredraw::gltf
