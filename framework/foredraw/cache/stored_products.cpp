#include <foredraw/cache/private/stored_products.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>

namespace foredraw::archive {

namespace {

/// References to accessors as a reader finds them: as their numbers.
ExtensionValue with_numbers(const ExtensionValue& value) {
  if (const auto* accessor = std::get_if<AccessorRef>(&value.any())) return accessor->number;
  if (const auto* list = value.list()) return listed(*list, with_numbers);
  if (const auto* members = value.members()) {
    ExtensionValue::Members numbered;
    for (const auto& [name, held] : *members) numbered.emplace_back(name, with_numbers(held));
    return numbered;
  }
  return value;
}

bool is_same_data(const AccessorData& a, const AccessorData& b) {
  return a.format == b.format && a.count == b.count && a.use == b.use && a.bytes == b.bytes;
}

class Writer final : public ExtensionWriter {
 public:
  explicit Writer(StoredProduct& to) : to_(to) {}

  void put_on_file(ExtensionValue value) override { to_.of_file = with_numbers(value); }
  void put_on_draw(DrawId draw, ExtensionValue value) override { to_.of_draws.emplace_back(draw, with_numbers(value)); }
  AccessorRef accessor(const AccessorData& data) override {
    auto [at, end] = by_stamp_.equal_range(data.bytes.stamp());
    for (; at != end; ++at) {
      if (is_same_data(to_.accessors[at->second], data)) return {at->second};
    }
    by_stamp_.emplace(data.bytes.stamp(), to_.accessors.size());
    to_.accessors.push_back(data);
    return {to_.accessors.size() - 1};
  }
  AccessorRef indices(std::span<const std::uint32_t> indices) override {
    return accessor(accessor_data(indices, Component::uint32, 1));
  }
  void share_vertices(DrawId, const std::vector<std::pair<std::string, AccessorRef>>&, std::uint32_t) override {}

 private:
  StoredProduct& to_;
  std::multimap<Stamp, std::size_t> by_stamp_;
};

class Reader final : public ExtensionReader {
 public:
  explicit Reader(const StoredProduct& from) : from_(from) {}

  const ExtensionValue* of_file() const override { return from_.of_file ? &*from_.of_file : nullptr; }
  const ExtensionValue* of_draw(DrawId draw) const override {
    const auto found = std::ranges::find(from_.of_draws, draw, &std::pair<DrawId, ExtensionValue>::first);
    return found == from_.of_draws.end() ? nullptr : &found->second;
  }
  bool is_list(DrawId draw) const override { return of_draw(draw) != nullptr; }
  std::uint64_t bytes() const override {
    return std::accumulate(from_.accessors.begin(), from_.accessors.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const AccessorData& accessor) { return sum + accessor.bytes.size(); });
  }
  std::optional<AccessorData> accessor(std::size_t number) override {
    if (number >= from_.accessors.size() || from_.accessors[number].count == 0) return std::nullopt;
    return from_.accessors[number];
  }

 private:
  const StoredProduct& from_;
};

}  // namespace

std::vector<StoredProduct> stored_products(const Scene& scene, const ProductRows& rows) {
  std::vector<StoredProduct> all;
  for (const auto& row : rows) {
    if (!scene.products.has(row->card().name)) continue;
    Writer writer(all.emplace_back(StoredProduct{row->card().name, {}, {}, {}}));
    row->write(scene, writer);
  }
  return all;
}

void restore_products(const std::vector<StoredProduct>& stored, const ProductRows& rows, Scene& scene) {
  for (const StoredProduct& product : stored) {
    const auto row = std::ranges::find_if(rows, [&](const auto& one) { return one->card().name == product.name; });
    if (row == rows.end()) throw std::runtime_error("nobody reads its " + product.name);
    Reader reader(product);
    Scene with = scene;
    if (const std::string wrong = (*row)->read(reader, with); !wrong.empty()) throw std::runtime_error(wrong);
    scene.products = std::move(with.products);  // what of draws belongs to it is with the draws
  }
}

std::string other_product(const Products& a, const Products& b) {
  std::string other;
  for (const Products* products : {&a, &b}) {
    products->each([&](const std::string& name) {
      if (other.empty() && !(a.has(name) && b.has(name) && a.same(name, b))) other = name;
    });
  }
  return other;
}

}  // namespace foredraw::archive
