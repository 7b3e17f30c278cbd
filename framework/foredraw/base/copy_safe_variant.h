#pragma once
// A variant that can be copied where memory runs out.

#include <utility>
#include <variant>

namespace foredraw {

/// A std::variant whose copy throws where one of what it holds does. libstdc++ 12 takes it that a variant of texts,
/// lists, shared pointers and plain values always has a value; a copy of it that finds no memory then destroys a value
/// that it never had, and the program is lost.
template <class... Types>
class CopySafeVariant : public std::variant<Types...> {
 public:
  using std::variant<Types...>::variant;

  CopySafeVariant() = default;
  CopySafeVariant(const CopySafeVariant& other) : std::variant<Types...>() {
    std::variant<Types...>& made = *this;
    std::visit([&made](const auto& value) { made = value; }, other);  // which is copied before it takes its place
  }
  CopySafeVariant(CopySafeVariant&&) noexcept = default;
  /// From a copy, so that nothing is half assigned, and what stands within this one may be assigned to it.
  CopySafeVariant& operator=(CopySafeVariant other) noexcept {
    std::variant<Types...>::operator=(std::move(other));
    return *this;
  }
};

}  // namespace foredraw
