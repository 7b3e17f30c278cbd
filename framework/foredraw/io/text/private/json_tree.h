#pragma once
// The tree of a JSON text. Private to io and to reports.
//
// The library's own trees do not stand it where memory is short, in five places:
// - Their destructor, which may not throw, first moves all children into a std::vector, and the program ends if there
//   is no room for it. It does so for trees of any depth; ours are bounded by JsonLimits, so that recursion is as good.
//   The tree's lists therefore have an allocator of their own, which leaves the vector of the usual one to the
//   destructor alone; below, that one ends what is put into it.
// - Null into which something is put says that it is an object or a list before it has one, and can not end. Ours has
//   one that takes nothing in: who puts something into that is told.
// - An object from which a member is taken copies the keys behind it one by one, each over one that it has destroyed.
//   Ours copies them first.
// - A value is compared with a text by making a value of the text, where nothing may be thrown. Below it is not made.
// - A value that is made of pairs in braces is not freed where one of them finds no room. Write JsonObject before
//   the braces: it is freed.

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

/// A namespace of its own, so that functions of ours are not looked for wherever a tree is an argument.
namespace foredraw::json_tree {

struct Refuses {};

/// Takes memory as everybody does, and is another type; or takes none, ever.
template <class T>
class Allocator {
 public:
  using value_type = T;

  Allocator() = default;
  explicit Allocator(Refuses) noexcept : refuses_(true) {}
  template <class Other>
  Allocator(const Allocator<Other>& other) noexcept : refuses_(other.refuses()) {}

  bool refuses() const noexcept { return refuses_; }
  T* allocate(std::size_t count) {
    if (refuses_) throw std::bad_alloc();
    return std::allocator<T>().allocate(count);
  }
  void deallocate(T* memory, std::size_t count) noexcept { std::allocator<T>().deallocate(memory, count); }
  Allocator select_on_container_copy_construction() const noexcept { return {}; }
  friend bool operator==(const Allocator&, const Allocator&) = default;

 private:
  bool refuses_ = false;
};

/// Of objects and lists themselves. Where there is no memory for a new one, all are the same one, which stays empty.
template <class Whole>
class WholeAllocator {
 public:
  using value_type = Whole;

  Whole* allocate(std::size_t count) {
    void* memory = ::operator new(count * sizeof(Whole), std::nothrow);
    return memory != nullptr ? static_cast<Whole*>(memory) : none();
  }
  void deallocate(Whole* memory, std::size_t) noexcept {
    if (memory != none()) ::operator delete(memory);
  }
  template <class... Arguments>
  void construct(Whole* at, Arguments&&... arguments) {
    if (at != none()) {
      ::new (at) Whole(std::forward<Arguments>(arguments)...);
    } else if (sizeof...(Arguments) != 0) {
      throw std::bad_alloc();
    }
  }
  void destroy(Whole* at) noexcept {
    if (at != none()) at->~Whole();
  }

 private:
  /// Nobody writes to it: what is empty and refuses changes nothing. Inlined, gcc 12 warns that it is freed, which it
  /// never is.
  [[gnu::noinline]] static Whole* none() noexcept {
    static const Whole none{typename Whole::allocator_type(Refuses())};
    return const_cast<Whole*>(&none);
  }
};

template <class T>
class Allocator<std::vector<T, Allocator<T>>> : public WholeAllocator<std::vector<T, Allocator<T>>> {};

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
    if (first == last) return this->begin() + at;
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

template <class Key, class Value, class Less, class Pairs>
class Allocator<Members<Key, Value, Less, Pairs>> : public WholeAllocator<Members<Key, Value, Less, Pairs>> {};

}  // namespace foredraw::json_tree

namespace foredraw {

/// Keeps the sequence of the keys. Lists of trees are Json::array_t, not std::vector.
using Json = nlohmann::basic_json<json_tree::Members, std::vector, std::string, bool, std::int64_t, std::uint64_t,
                                  double, json_tree::Allocator>;
/// Members in braces, or those that are put together before they are a value.
using JsonObject = Json::object_t;

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
  foredraw::Json& back() { std::terminate(); }  // of an empty one: never called
  void pop_back() noexcept {}
};

inline void std::vector<foredraw::Json>::push_back(foredraw::Json&& child) noexcept {
  const foredraw::Json ended(std::move(child));
}
