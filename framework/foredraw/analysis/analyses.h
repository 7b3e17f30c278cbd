#pragma once
// Analyses made on demand and kept by the content that they read. Streams are immutable and stamped, so a kept analysis
// can not go stale and no stage has to say what it preserves.

#include <foredraw/base/content_hash.h>
#include <foredraw/scene/texture.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace foredraw {

struct VertexStreams;

/// The texels of an image, or why there are none. Any number of threads may ask at once.
using ImageDecoder = std::function<std::variant<Texels, std::string>(const Image&)>;

/// Bounded: values that nobody else holds are forgotten, the least recently used first, and made again when they are
/// asked for. So the bound decides what is computed how often, never what comes out.
class Analyses {
 public:
  static constexpr std::size_t default_most_bytes = std::size_t{1} << 30;

  Analyses() : Analyses(ImageDecoder()) {}
  explicit Analyses(ImageDecoder decoder, std::size_t most_bytes = default_most_bytes)
      : decoder_(std::move(decoder)), most_bytes_(most_bytes) {}

  /// The analysis T of this content, made by `make()` on the first ask. Askers of the same one wait for it. `T::name`,
  /// a text of its own, tells it from others of the same content, those of other modules included. A T that owns memory
  /// says how much by a function bytes().
  template <class T, class Make>
  std::shared_ptr<const T> get(const Stamp& content, Make&& make) {
    return std::static_pointer_cast<const T>(kept(T::name, content, [&]() -> Made {
      auto value = std::make_shared<const T>(make());
      std::size_t bytes = sizeof(T);
      if constexpr (requires { value->bytes(); }) bytes += value->bytes();
      return {std::move(value), bytes};
    }));
  }

  /// As the decoder has them, not kept.
  std::variant<Texels, std::string> decode(const Image& image) const;

  /// How many analyses are held.
  std::size_t size() const;
  void clear();
  /// Without analyses, and otherwise like this one.
  Analyses emptied() const { return Analyses(decoder_, most_bytes_); }

 private:
  struct Made {
    std::shared_ptr<const void> value;
    std::size_t bytes = 0;
  };
  struct Entry {
    std::mutex making;
    Made made;
    std::list<Stamp>::iterator use;
  };
  std::shared_ptr<const void> kept(std::string_view name, const Stamp& content, const std::function<Made()>& make);
  std::vector<std::shared_ptr<Entry>> take_what_is_too_much();

  ImageDecoder decoder_;
  std::size_t most_bytes_;
  mutable std::mutex mutex_;
  std::map<Stamp, std::shared_ptr<Entry>> entries_;  ///< by name and content
  std::list<Stamp> uses_;                            ///< their keys, the least recently used first
  std::size_t bytes_ = 0;
};

/// Positions decoded to floats; empty where there are none.
struct Positions {
  static constexpr std::string_view name = "positions";
  std::vector<glm::vec3> values;
  std::size_t bytes() const { return values.size() * sizeof(glm::vec3); }
};
std::shared_ptr<const Positions> positions_of(Analyses& analyses, const VertexStreams& vertices);

}  // namespace foredraw
