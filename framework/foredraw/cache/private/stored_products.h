#pragma once
// Products by their extensions, as a file would have them, without a file.

#include <foredraw/cache/private/scene_fields.h>

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace foredraw::archive {

struct StoredProduct {
  std::string name;
  std::optional<ExtensionValue> of_file;
  std::vector<std::pair<DrawId, ExtensionValue>> of_draws;
  std::vector<AccessorData> accessors;
};

template <class A, Is<AccessorData> T>
void fields(A& archive, T& value) {
  auto& [format, count, bytes, use] = value;
  archive(format, count, bytes, use);
}

template <class A, Is<StoredProduct> T>
void fields(A& archive, T& value) {
  auto& [name, of_file, of_draws, accessors] = value;
  archive(name, of_file, of_draws, accessors);
}

template <class Handles, class First>
void fields(Out<Handles>& to, const std::pair<First, ExtensionValue>& value) {
  to(value.first, value.second);
}

template <class Handles, class First>
void fields(In<Handles>& from, std::pair<First, ExtensionValue>& value) {
  from(value.first, value.second);
}

template <class Handles>
void fields(Out<Handles>& to, const ExtensionValue& value) {
  to(value.any().index());
  std::visit(
      [&]<class T>(const T& held) {
        if constexpr (std::is_same_v<T, AccessorRef>) {
          to(held.number);
        } else if constexpr (!std::is_same_v<T, std::monostate>) {
          to(held);
        }
      },
      value.any());
}

template <class... Types>
std::variant<Types...> as_std(const std::variant<Types...>&);
using AnyValue = decltype(as_std(std::declval<ExtensionValue::Any>()));  ///< of which the standard counts alternatives

/// Of the alternative of that number: [index of ExtensionValue::Any].
template <std::size_t alternative = 0, class Handles>
void take_value(In<Handles>& from, std::size_t number, ExtensionValue& value) {
  if constexpr (alternative == std::variant_size_v<AnyValue>) {
    throw std::runtime_error("a value is of no kind");
  } else if (number != alternative) {
    take_value<alternative + 1>(from, number, value);
  } else {
    using T = std::variant_alternative_t<alternative, AnyValue>;
    T held{};
    if constexpr (std::is_same_v<T, AccessorRef>) {
      from(held.number);
    } else if constexpr (!std::is_same_v<T, std::monostate>) {
      from(held);
    }
    if constexpr (!std::is_same_v<T, std::monostate>) value = ExtensionValue(std::move(held));
  }
}

template <class Handles>
void fields(In<Handles>& from, ExtensionValue& value) {
  std::size_t number = 0;
  from(number);
  take_value(from, number, value);
}

/// Those that the rows know.
std::vector<StoredProduct> stored_products(const Scene& scene, const ProductRows& rows);

/// Put into the scene, which has none, and is otherwise as it was. Throws std::runtime_error where one can not be.
void restore_products(const std::vector<StoredProduct>& stored, const ProductRows& rows, Scene& scene);

/// The first product that only one of them has, or that differs; empty: none.
std::string other_product(const Products& a, const Products& b);

}  // namespace foredraw::archive
