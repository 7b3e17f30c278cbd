#pragma once
#include <foredraw/scene/scene.h>

namespace foredraw::testing {

/// The product of a scene to be changed in one statement: edit<DrawOrders>(scene)->tables.clear().
template <class T>
class edit {
 public:
  explicit edit(Scene& scene) : scene_(scene) {
    if (const T* held = scene.products.find<T>()) value_ = *held;
  }
  ~edit() { scene_.products.set(std::move(value_)); }
  T* operator->() { return &value_; }

 private:
  Scene& scene_;
  T value_;
};

}  // namespace foredraw::testing
