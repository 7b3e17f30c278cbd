#pragma once
// What techniques make beside triangles and vertices: merged draws, tables of orders, and whatever else.

#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace foredraw {

/// The products of a scene: plain immutable values, each of a type that has `static constexpr std::string_view
/// product`, its name, and ==. What a product is in a file, and what becomes of it as stages change the scene, its row
/// knows (product_row.h). A copy is a copy of handles.
class Products {
 public:
  /// Nothing where the scene has none.
  template <class T>
  const T* find() const {
    const auto found = values_.find(T::product);
    return found == values_.end() ? nullptr : static_cast<const T*>(found->second.value.get());
  }

  template <class T>
  void set(T value) {
    values_.insert_or_assign(std::string(T::product),
                             Held{std::make_shared<const T>(std::move(value)), [](const void* a, const void* b) {
                                    return *static_cast<const T*>(a) == *static_cast<const T*>(b);
                                  }});
  }

  void erase(std::string_view name) {
    if (const auto found = values_.find(name); found != values_.end()) values_.erase(found);
  }

  bool has(std::string_view name) const { return values_.find(name) != values_.end(); }
  bool empty() const { return values_.empty(); }

  /// Whether both hold equal values of that name, or neither holds one.
  bool same(std::string_view name, const Products& others) const {
    const auto mine = values_.find(name);
    const auto theirs = others.values_.find(name);
    if (mine == values_.end() || theirs == others.values_.end()) return has(name) == others.has(name);
    const Held& held = mine->second;
    return held.value == theirs->second.value || held.equal(held.value.get(), theirs->second.value.get());
  }

  /// Calls see(name) for each, by name.
  template <class See>
  void each(See see) const {
    for (const auto& [name, held] : values_) see(name);
  }

 private:
  struct Held {
    std::shared_ptr<const void> value;
    bool (*equal)(const void*, const void*) = nullptr;
  };
  std::map<std::string, Held, std::less<>> values_;
};

}  // namespace foredraw
