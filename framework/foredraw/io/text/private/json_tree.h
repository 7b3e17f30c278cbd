#pragma once
// The tree of a JSON text. Private to io.
//
// The library's own trees do not stand it where memory is short, in three places:
// - Their destructor, which may not throw, first moves all children into a std::vector, and the program ends if there
// is
//   no room for it. It does so for trees of any depth; ours are bounded by JsonLimits, so that recursion is as good.
//   The tree's arrays therefore have an allocator of their own, which leaves the vector of the usual one to the
//   destructor alone; below, that one ends what is put into it.
// - An object from which a member is taken copies the keys behind it one by one, each over one that it has destroyed.
//   Ours copies them first.
// - A value is compared with a text by making a value of the text, where nothing may be thrown. Below it is not made.

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// A namespace of its own, so that functions of ours are not looked for wherever a tree is an argument.
namespace foredraw::json_tree {

/// Takes memory as everybody does, and is another type.
template <class T>
struct Allocator : std::allocator<T> {
  using std::allocator<T>::allocator;
  template <class Other>
  struct rebind {
    using other = Allocator<Other>;
  };
};

/// An object's: a list, in the sequence of the file.
template <class Key, class Value, class Less, class Allocator>
class Members : public nlohmann::ordered_map<Key, Value, Less, Allocator> {
  using Base = nlohmann::ordered_map<Key, Value, Less, Allocator>;

 public:
  using Base::Base;
  using typename Base::const_iterator;
  using typename Base::Container;
  using typename Base::iterator;

  iterator erase(const_iterator first, const_iterator last) {
    const auto at = first - this->cbegin();
    Container rest;
    rest.reserve(this->size() - static_cast<std::size_t>(last - first));
    for (auto it = this->cbegin(); it != this->cend(); ++it) {
      if (it < first || it >= last) rest.emplace_back(it->first, nullptr);
    }
    auto to = rest.begin();  // from here on nothing takes memory
    for (auto it = this->begin(); it != this->end(); ++it) {
      if (it < first || it >= last) (to++)->second = std::move(it->second);
    }
    Container::swap(rest);
    return this->begin() + at;
  }
  iterator erase(const_iterator member) { return erase(member, member + 1); }
  std::size_t erase(const Key& key) {
    const const_iterator member = this->find(key);
    if (member == this->cend()) return 0;
    erase(member);
    return 1;
  }
};

}  // namespace foredraw::json_tree

namespace foredraw {

/// Keeps the sequence of the keys. Lists of trees are Json::array_t.
using Json = nlohmann::basic_json<json_tree::Members, std::vector, std::string, bool, std::int64_t, std::uint64_t,
                                  double, json_tree::Allocator>;

namespace json_tree {

/// Better than the library's, which is for any scalar.
inline bool operator==(const Json& json, const char* text) {
  const auto* value = json.get_ptr<const std::string*>();
  return value != nullptr && *value == text;
}
inline bool operator!=(const Json& json, const char* text) { return !(json == text); }

}  // namespace json_tree
}  // namespace foredraw

/// Of trees that end: nothing but what the destructor asks of it.
template <>
class std::vector<foredraw::Json> {
 public:
  using value_type = foredraw::Json;

  void reserve(std::size_t) noexcept {}
  bool empty() const noexcept { return true; }
  void push_back(foredraw::Json&& child) noexcept;
  foredraw::Json& back();  // of an empty one: never called
  void pop_back();
};

inline void std::vector<foredraw::Json>::push_back(foredraw::Json&& child) noexcept {
  const foredraw::Json ended(std::move(child));
}
