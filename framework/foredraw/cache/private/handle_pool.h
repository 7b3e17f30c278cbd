#pragma once
// Handles by number. What two holders share before they are stored they share afterwards: stages and writers see by the
// handle that nothing was touched.

#include <foredraw/scene/scene.h>

#include <optional>
#include <stdexcept>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace foredraw::archive {

template <class T>
const void* place_of(const Shared<T>& handle) {
  return handle.empty() ? nullptr : handle.view().data();
}
inline const void* place_of(const std::shared_ptr<const VertexStreams>& handle) { return handle.get(); }

template <class T>
bool is_same_handle(const Shared<T>& a, const Shared<T>& b) {
  return a.is(b);
}
inline bool is_same_handle(const std::shared_ptr<const VertexStreams>& a,
                           const std::shared_ptr<const VertexStreams>& b) {
  return a == b;
}

/// Of one type. Those that it holds stay where they are, so that a place in memory is one handle's alone.
template <class Handle>
class HandlePool {
 public:
  std::size_t size() const { return handles_.size(); }

  std::optional<std::size_t> find(const Handle& handle) const {
    if (const void* place = place_of(handle)) {
      const auto found = numbers_.find(place);
      return found == numbers_.end() ? std::nullopt : std::optional(found->second);
    }
    for (const std::size_t number : empty_) {
      if (is_same_handle(handles_[number], handle)) return number;
    }
    return std::nullopt;
  }

  void add(Handle handle) {
    const void* place = place_of(handle);
    if (place == nullptr) {
      empty_.push_back(handles_.size());
    } else {
      numbers_.emplace(place, handles_.size());
    }
    handles_.push_back(std::move(handle));
  }

  const Handle& at(std::size_t number) const {
    if (number >= handles_.size()) throw std::runtime_error("a handle is named that is not there");
    return handles_[number];
  }

 private:
  std::vector<Handle> handles_;
  std::unordered_map<const void*, std::size_t> numbers_;
  std::vector<std::size_t> empty_;
};

/// All handles of a scene, but those that products hold. Null ones are in none.
struct HandlePools {
  std::tuple<HandlePool<Shared<std::byte>>, HandlePool<Shared<std::uint32_t>>, HandlePool<Shared<float>>,
             HandlePool<Shared<Transform>>, HandlePool<std::shared_ptr<const VertexStreams>>>
      pools;

  template <class Handle>
  HandlePool<Handle>& of() {
    return std::get<HandlePool<Handle>>(pools);
  }
};

}  // namespace foredraw::archive
