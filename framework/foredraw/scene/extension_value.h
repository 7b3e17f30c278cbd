#pragma once
// What stands in an extension of a file, without the library that reads the file.

#include <foredraw/base/copy_safe_variant.h>

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace foredraw {

/// Stands for the number that an accessor gets when its extension is written.
struct AccessorRef {
  std::size_t number = 0;  ///< of the writer's; what it means is the writer's to know
};

/// A value as JSON has them. Members keep the sequence that they were put in.
class ExtensionValue {
 public:
  using List = std::vector<ExtensionValue>;
  using Members = std::vector<std::pair<std::string, ExtensionValue>>;
  using Any = CopySafeVariant<std::monostate, bool, std::int64_t, double, std::string, List, Members, AccessorRef>;

  ExtensionValue() = default;
  ExtensionValue(bool value) : any_(value) {}
  template <std::integral T>
  requires(!std::same_as<T, bool>) ExtensionValue(T value) : any_(static_cast<std::int64_t>(value)) {}
  template <std::floating_point T>
  ExtensionValue(T value) : any_(static_cast<double>(value)) {}
  ExtensionValue(const char* text) : any_(std::string(text)) {}
  ExtensionValue(std::string text) : any_(std::move(text)) {}
  ExtensionValue(List list) : any_(std::move(list)) {}
  ExtensionValue(Members members) : any_(std::move(members)) {}
  ExtensionValue(AccessorRef accessor) : any_(accessor) {}

  const Any& any() const { return any_; }

  /// The member of that name; null where there is none, or this has no members.
  const ExtensionValue* member(std::string_view name) const;
  const List* list() const { return std::get_if<List>(&any_); }
  const Members* members() const { return std::get_if<Members>(&any_); }
  const std::string* text() const { return std::get_if<std::string>(&any_); }
  std::optional<double> number() const;        ///< also of whole ones
  std::optional<std::uint32_t> whole() const;  ///< from 0 to 2^32 - 1

  /// Puts a member behind the others; for a value that is none yet, or has members.
  void put(std::string name, ExtensionValue value);
  /// Puts an element behind the others; for a value that is none yet, or a list.
  void push(ExtensionValue value);

 private:
  Any any_;
};

/// The list of what `make` makes of each element.
template <class Range, class Make>
ExtensionValue::List listed(const Range& range, Make make) {
  ExtensionValue::List list;
  for (const auto& element : range) list.push_back(make(element));
  return list;
}

}  // namespace foredraw
