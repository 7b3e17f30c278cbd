#pragma once
// The streams of a scene, from the accessors of its document. Private to io.

#include <foredraw/io/gltf/private/document.h>
#include <foredraw/scene/vertex_streams.h>

#include <map>
#include <memory>
#include <tuple>

namespace foredraw::gltf {

/// glTF's numbers of what a primitive's corners make.
enum class Mode { points, lines, line_loop, line_strip, triangles, triangle_strip, triangle_fan };

/// A primitive of a document that was checked. What it names are accessors.
struct Primitive {
  using Attributes = std::map<std::string, std::size_t>;

  explicit Primitive(const Json& json);

  Attributes attributes;
  std::vector<Attributes> targets;
  std::optional<std::size_t> indices;
  Mode mode = Mode::triangles;
};

/// Each made once, and shared by whoever names the same bytes: what a file says a thousand times takes memory once.
class Streams {
 public:
  explicit Streams(const Document& document);

  std::shared_ptr<const VertexStreams> vertices(const Primitive& primitive);

  /// As lists, strips and fans taken apart.
  Shared<std::uint32_t> indices(const Primitive& primitive);

  Shared<float> decoded(std::size_t accessor);

 private:
  using Attributes = Primitive::Attributes;

  Attributes first_alike(Attributes attributes) const;
  std::size_t vertex_count(const Primitive& primitive) const;
  VertexStream stream(const std::string& semantic, std::size_t accessor);

  const Document& document_;
  std::vector<std::size_t> first_alike_;  ///< [accessor] = the first that names the same bytes alike
  std::map<std::pair<Attributes, std::vector<Attributes>>, std::shared_ptr<const VertexStreams>> vertices_;
  std::map<std::tuple<std::optional<std::size_t>, std::size_t, Mode>, Shared<std::uint32_t>> indices_;
  std::map<std::size_t, Shared<std::byte>> bytes_;
  std::map<std::size_t, Shared<float>> decoded_;
};

}  // namespace foredraw::gltf
