#pragma once
// Analyses made on demand and kept by the content that they read. Streams are immutable and stamped, so a kept analysis
// can not go stale and no stage has to say what it preserves.

#include <foredraw/base/content_hash.h>
#include <foredraw/scene/texture.h>

#include <glm/vec3.hpp>

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <typeindex>
#include <variant>
#include <vector>

namespace foredraw {

struct VertexStreams;

/// The texels of an image, or why there are none. Any number of threads may ask at once.
using ImageDecoder = std::function<std::variant<Texels, std::string>(const Image&)>;

class Analyses {
 public:
  Analyses() = default;
  explicit Analyses(ImageDecoder decoder) : decoder_(std::move(decoder)) {}

  /// The analysis of type T for this content, made by `make()` on the first ask. Askers of the same one wait for it.
  /// T tells analyses of the same content apart, so each analysis has a type of its own.
  template <class T, class Make>
  std::shared_ptr<const T> get(const Stamp& content, Make&& make) {
    return std::static_pointer_cast<const T>(
        kept({std::type_index(typeid(T)), content},
             [&]() -> std::shared_ptr<const void> { return std::make_shared<const T>(make()); }));
  }

  /// As the decoder has them, not kept.
  std::variant<Texels, std::string> decode(const Image& image) const;

  /// How many analyses are held.
  std::size_t size() const;
  void clear();

 private:
  struct Key {
    std::type_index type;
    Stamp content;
    auto operator<=>(const Key&) const = default;
  };
  struct Entry {
    std::mutex making;
    std::shared_ptr<const void> value;
  };
  std::shared_ptr<const void> kept(const Key& key, const std::function<std::shared_ptr<const void>()>& make);

  ImageDecoder decoder_;
  mutable std::mutex mutex_;
  std::map<Key, std::shared_ptr<Entry>> entries_;
};

/// Positions decoded to floats; empty where there are none.
struct Positions {
  std::vector<glm::vec3> values;
};
std::shared_ptr<const Positions> positions_of(Analyses& analyses, const VertexStreams& vertices);

}  // namespace foredraw
