#include "support/sprite_scenes.h"

#include <glm/vec2.hpp>

#include <cstring>
#include <utility>

namespace foredraw::testing {

namespace {

template <class T>
Shared<std::byte> shared_bytes(const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return Shared<std::byte>({bytes.begin(), bytes.end()});
}

}  // namespace

Image texel_image(const ImageFacts& facts, const std::vector<std::uint16_t>& values) {
  Image image;
  image.facts = facts;
  image.bytes =
      facts.bits == 16 ? shared_bytes(values) : shared_bytes(std::vector<std::uint8_t>(values.begin(), values.end()));
  return image;
}

Image texel_image(const AlphaImage& alpha) {
  std::vector<std::uint16_t> values;
  for (const std::uint16_t value : alpha.alpha) {
    values.push_back(32768);
    values.push_back(value);
  }
  return texel_image({alpha.width, alpha.height, 2, 16, false}, values);
}

ImageDecoder stored_texels() {
  return [](const Image& image) -> std::variant<Texels, std::string> {
    if (image.bytes.empty()) return "it holds no texels";
    const auto bytes = image.bytes.view();
    return Texels{*image.facts, {bytes.begin(), bytes.end()}};
  };
}

Scene sprite_scene(Image image, std::string name) {
  const float width = static_cast<float>(image.facts->width), height = static_cast<float>(image.facts->height);
  VertexStreams vertices;
  vertices.count = 4;
  vertices.base.push_back(
      {"POSITION", Format{},
       shared_bytes(std::vector<glm::vec3>{{0, -height, 0}, {width, -height, 0}, {width, 0, 0}, {0, 0, 0}})});
  vertices.base.push_back({"TEXCOORD_0", Format{Component::float32, 2, false, 8},
                           shared_bytes(std::vector<glm::vec2>{{0, 1}, {1, 1}, {1, 0}, {0, 0}})});
  Scene scene;
  scene.name = "test sprites";
  Draw draw;
  draw.name = name;
  draw.traits = {traits::triangles, traits::uv0, traits::blended, traits::sprite};
  draw.material = 0;
  draw.frame = SpriteFrame{0, 0, image.facts->width, image.facts->height};
  IndexStream stream;
  stream.indices = Shared<std::uint32_t>({0, 1, 2, 0, 2, 3});
  Level level;
  level.vertices = std::make_shared<const VertexStreams>(std::move(vertices));
  level.orders.push_back(std::move(stream));
  draw.levels.push_back(std::move(level));
  scene.draws.push_back(std::move(draw));
  scene.images.push_back(std::move(image));
  Texture texture;
  texture.image = 0;
  texture.wrap = {Wrap::clamped, Wrap::clamped};
  Material material;
  material.name = name;
  material.alpha_mode = AlphaMode::blend;
  material.base_colour = texture;
  scene.materials.push_back(std::move(material));
  scene.meshes.push_back({name, {0}, {}});
  Node node;
  node.name = std::move(name);
  node.mesh = 0;
  scene.nodes.push_back(std::move(node));
  return scene;
}

}  // namespace foredraw::testing
