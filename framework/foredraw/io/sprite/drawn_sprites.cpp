#include <foredraw/io/sprite/private/drawn_sprites.h>

#include <foredraw/image/sprite_pieces.h>
#include <foredraw/image/texture_uv.h>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>

namespace foredraw::sprites {

namespace {

/// Draws of images and lists that a stage has parted, or that are no list's, are sprites of their own.
void set_frame(const Draw& draw, const SpriteSource* source, DrawnSprite& sprite) {
  const bool is_known = source != nullptr && draw.origin && draw.origin->mesh < source->entries.size();
  if (is_known && source->entries[draw.origin->mesh].place == *draw.frame) {
    sprite.frame = source->entries[draw.origin->mesh];
    sprite.entry = draw.origin->mesh;
    return;
  }
  if (is_known) {
    sprite.entry = draw.origin->mesh;
    sprite.frame.is_turned = source->entries[draw.origin->mesh].is_turned;
    sprite.frame.texture = source->entries[draw.origin->mesh].texture;
  }
  sprite.frame.name = draw.name;
  sprite.frame.place = *draw.frame;
  sprite.frame.whole = sprite.frame.size();
}

void add_corners(const Draw& draw, const Texture& texture, const ImageFacts& facts, DrawnSprite& sprite) {
  const VertexStreams& vertices = *draw.full().vertices;
  const VertexStream* texcoords = vertices.find("TEXCOORD_" + std::to_string(texture.texcoord));
  if (texcoords == nullptr || draw.topology != Topology::triangles) return;
  const std::vector<glm::dvec2> places = texture_uv(*texcoords, texture);
  const auto indices = draw.full().stream().indices.view();
  // Equal corners become one, whatever else their vertices hold.
  std::map<std::array<double, 2>, std::uint32_t> numbers;
  const auto corner = [&](std::uint32_t vertex) {
    const glm::dvec2 place = places[vertex] + 0.0;  // -0 becomes 0
    const auto [found, is_new] =
        numbers.try_emplace({place.x, place.y}, static_cast<std::uint32_t>(sprite.texcoords.size()));
    if (is_new) {
      sprite.texcoords.push_back(place);
      sprite.texels.push_back(place * glm::dvec2(facts.width, facts.height));
      sprite.points.push_back(to_sprite(sprite.frame, sprite.texels.back()));
    }
    return found->second;
  };
  for (const SpritePiece& piece : sprite_pieces(draw, texture.texcoord)) {
    std::vector<std::uint32_t> outline;
    for (const std::uint32_t vertex : piece.outline) outline.push_back(corner(vertex));
    if (!outline.empty()) sprite.outlines.push_back(std::move(outline));
  }
  for (const std::uint32_t vertex : indices) sprite.triangles.push_back(corner(vertex));
}

}  // namespace

double DrawnSprite::area_part() const {
  double twice = 0;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const glm::dvec2 a = points[triangles[i]];
    const glm::dvec2 ab = points[triangles[i + 1]] - a, ac = points[triangles[i + 2]] - a;
    twice += std::abs(ab.x * ac.y - ab.y * ac.x);
  }
  return twice / 2 / (static_cast<double>(frame.place.width) * frame.place.height);
}

glm::dvec2 to_sprite(const FrameEntry& frame, const glm::dvec2& texel) {
  const glm::dvec2 in_place = texel - glm::dvec2(frame.place.x, frame.place.y);
  const glm::dvec2 upright = frame.is_turned ? glm::dvec2(in_place.y, frame.place.width - in_place.x) : in_place;
  return upright + glm::dvec2(frame.offset);
}

std::optional<std::vector<DrawnSprite>> drawn_sprites(const Scene& scene, const std::filesystem::path& target,
                                                      Diagnostics& diagnostics) {
  const auto* source = dynamic_cast<const SpriteSource*>(scene.source.get());
  std::vector<DrawnSprite> sprites;
  const auto refuse = [&](const std::string& inside, const std::string& why) {
    diagnostics.error({.file = target.string(), .inside = inside}, "no-sprites", why,
                      "use an image (.png, .jpg, .tga, .exr) or a frame list (.json) as input; write a scene of meshes "
                      "as .glb or .gltf");
    return std::nullopt;
  };
  for (const Draw& draw : scene.draws) {
    if (!draw.frame) return refuse(draw.name, "has no frame in an image, but this kind of file holds only sprites");
    const Material* material = scene.material_of(draw);
    const auto* texture = material != nullptr && material->base_colour ? &*material->base_colour : nullptr;
    const bool has_image = texture != nullptr && texture->image && *texture->image < scene.images.size() &&
                           scene.images[*texture->image].facts;
    if (!has_image || draw.frame->width == 0 || draw.frame->height == 0) {
      return refuse(draw.name, "has no image of known size");
    }
    DrawnSprite& sprite = sprites.emplace_back();
    sprite.image = *texture->image;
    sprite.frame.texture = sprite.image;
    set_frame(draw, source, sprite);
    add_corners(draw, *texture, *scene.images[sprite.image].facts, sprite);
  }
  if (sprites.empty()) return refuse("", "the scene has no sprites");
  return sprites;
}

std::string shortest(double value) {
  const auto as_float = static_cast<float>(value);
  return fmt::format("{}", as_float == 0 ? 0.0f : as_float);
}

}  // namespace foredraw::sprites
