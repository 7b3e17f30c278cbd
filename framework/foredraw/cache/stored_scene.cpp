#include <foredraw/cache/stored_scene.h>

#include <foredraw/cache/private/handle_pool.h>
#include <foredraw/cache/private/scene_fields.h>
#include <foredraw/cache/private/stored_products.h>

namespace foredraw {

namespace archive {

/// Gathers the handles of a scene, in the sequence in which its fields are listed.
struct HandleGatherer {
  HandlePools& handles;

  template <class... Ts>
  void operator()(const Ts&... values) {
    (see(values), ...);
  }

 private:
  template <class T>
  void see(const T& value) {
    if constexpr (is_plain<T> || std::is_same_v<T, std::string>) {
      return;
    } else if constexpr (is_optional<T>) {
      if (value) see(*value);
    } else if constexpr (is_vector<T>) {
      for (const auto& one : value) see(one);
    } else {
      fields(*this, value);
    }
  }
};

using SceneOut = Out<HandlePools*>;
using SceneIn = In<HandlePools*>;

namespace {

template <class Handle>
void gather(HandleGatherer& gatherer, const Handle& handle) {
  auto& pool = gatherer.handles.of<Handle>();
  if (is_same_handle(handle, Handle()) || pool.find(handle)) return;
  if constexpr (std::is_same_v<Handle, std::shared_ptr<const VertexStreams>>) gatherer(*handle);
  pool.add(handle);
}

constexpr std::uint32_t none = ~std::uint32_t{0}, another = none - 1;  // instead of a number

template <class T>
std::span<const T> content_of(const Shared<T>& handle) {
  return handle.view();
}
const VertexStreams& content_of(const std::shared_ptr<const VertexStreams>& handle) { return *handle; }

template <class Handle>
void write(SceneOut& to, const Handle& handle) {
  auto& pool = to.handles->of<Handle>();
  if (is_same_handle(handle, Handle())) return to(none);
  if (const auto number = pool.find(handle)) return to(static_cast<std::uint32_t>(*number));
  to(another, content_of(handle));
  pool.add(handle);
}

template <class T>
void make(SceneIn& from, Shared<T>& handle) {
  std::vector<T> values;
  from(values);
  handle = Shared<T>(std::move(values));
}
void make(SceneIn& from, std::shared_ptr<const VertexStreams>& handle) {
  VertexStreams streams;
  from(streams);
  handle = std::make_shared<const VertexStreams>(std::move(streams));
}

template <class Handle>
void read(SceneIn& from, Handle& handle) {
  auto& pool = from.handles->of<Handle>();
  std::uint32_t number = none;
  from(number);
  if (number == another) {
    make(from, handle);
    pool.add(handle);
  } else {
    handle = number == none ? Handle() : pool.at(number);
  }
}

}  // namespace

template <class T>
void fields(HandleGatherer& gatherer, const Shared<T>& handle) {
  gather(gatherer, handle);
}
void fields(HandleGatherer& gatherer, const std::shared_ptr<const VertexStreams>& handle) { gather(gatherer, handle); }
void fields(HandleGatherer&, const Traits&) {}

template <class T>
void fields(SceneOut& to, const Shared<T>& handle) {
  write(to, handle);
}
void fields(SceneOut& to, const std::shared_ptr<const VertexStreams>& handle) { write(to, handle); }

template <class T>
void fields(SceneIn& from, Shared<T>& handle) {
  read(from, handle);
}
void fields(SceneIn& from, std::shared_ptr<const VertexStreams>& handle) { read(from, handle); }

}  // namespace archive

namespace {

archive::HandlePools handles_of(const Scene& scene) {
  archive::HandlePools handles;
  archive::HandleGatherer{handles}(scene);
  return handles;
}

/// What becomes of the products when they are stored and restored, as the rest of a sentence; empty: they are the same.
std::string why_not_held(const std::vector<archive::StoredProduct>& stored, const Scene& scene,
                         const ProductRows& rows) {
  Scene again = scene;
  again.products = {};
  try {
    archive::restore_products(stored, rows, again);
  } catch (const std::exception& problem) {
    return problem.what();
  }
  const std::string other = archive::other_product(scene.products, again.products);
  return other.empty() ? other : "its product '" + other + "' holds more than its extension says";
}

}  // namespace

std::variant<std::vector<std::byte>, std::string> stored_scene(const Scene& scene, const Scene& input,
                                                               const ProductRows& rows) {
  archive::HandlePools handles = handles_of(input);
  archive::SceneOut to(&handles);
  const bool has_products_of_input = archive::other_product(scene.products, input.products).empty();
  to(scene, has_products_of_input);
  if (!has_products_of_input) {
    const auto products = archive::stored_products(scene, rows);
    if (std::string why = why_not_held(products, scene, rows); !why.empty()) return why;
    to(products);
  }
  return std::move(to.bytes());
}

Scene restored_scene(std::span<const std::byte> bytes, const Scene& input, const ProductRows& rows) {
  archive::HandlePools handles = handles_of(input);
  archive::SceneIn from(bytes, &handles);
  Scene scene;
  scene.name = input.name;
  scene.source = input.source;
  bool has_products_of_input = false;
  from(scene, has_products_of_input);
  if (has_products_of_input) {
    scene.products = input.products;
  } else {
    std::vector<archive::StoredProduct> products;
    from(products);
    archive::restore_products(products, rows, scene);
  }
  if (!from.is_at_end()) throw std::runtime_error("there are more bytes than a scene has");
  return scene;
}

}  // namespace foredraw
