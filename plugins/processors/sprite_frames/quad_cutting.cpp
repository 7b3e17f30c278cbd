#include "quad_cutting.h"

#include <foredraw/image/sprite_pieces.h>
#include <foredraw/image/texture_uv.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace foredraw {

namespace {

std::string semantic_of(const Texture& texture) { return "TEXCOORD_" + std::to_string(texture.texcoord); }

/// The upright rectangle of the image that a quad shows, and the quad's attributes all over it.
class ShownQuad {
 public:
  ShownQuad(const Draw& draw, const Texture& texture, const ImageFacts& facts)
      : vertices_(*draw.full().vertices), size_(facts.width, facts.height) {
    for (const glm::dvec2& place : texture_uv(*vertices_.find(semantic_of(texture)), texture)) {
      texels_.push_back(place * size_);
    }
    const std::vector<SpritePiece> pieces = sprite_pieces(draw, texture.texcoord);
    origin_ = pieces[0].outline[0];
    along_ = pieces[0].outline[1];
    across_ = pieces[0].outline[3];
    const auto apart = [&](std::uint32_t v) { return glm::abs(texels_[v] - texels_[origin_]); };
    if (apart(along_).y > apart(along_).x) std::swap(along_, across_);  // now along x, and along y
    least_ = most_ = texels_[origin_];
    for (const std::uint32_t corner : pieces[0].outline) {
      least_ = glm::min(least_, texels_[corner]);
      most_ = glm::max(most_, texels_[corner]);
    }
  }

  bool shows(const SpriteFrame& frame) const {
    constexpr double near = 1.0 / 64;  // texels; coordinates are rounded
    const glm::dvec2 first(frame.x, frame.y), size(frame.width, frame.height);
    const glm::dvec2 off = glm::max(glm::abs(least_ - first), glm::abs(most_ - first - size));
    return off.x <= near && off.y <= near;
  }

  /// Every vertex at the corner of the frame that is where its own is in the quad.
  VertexStreams cut_to(const SpriteFrame& frame) const {
    VertexStreams cut = vertices_;
    const glm::dvec2 first(frame.x, frame.y), size(frame.width, frame.height);
    for (VertexStream& stream : cut.base) {
      std::vector<std::byte> bytes(stream.bytes.size());
      for (std::size_t v = 0; v < vertices_.count; ++v) {
        const glm::dvec2 middle = (least_ + most_) / 2.0;
        const glm::dvec2 corner(texels_[v].x < middle.x ? first.x : first.x + size.x,
                                texels_[v].y < middle.y ? first.y : first.y + size.y);
        for (std::size_t i = 0; i < stream.format.components; ++i) {
          const auto value = static_cast<float>(value_at(stream, i, corner));
          std::memcpy(&bytes[v * stream.format.bytes + i * sizeof value], &value, sizeof value);
        }
      }
      stream.bytes = Shared<std::byte>(std::move(bytes));
    }
    return cut;
  }

 private:
  double value_at(const VertexStream& stream, std::size_t component, const glm::dvec2& texel) const {
    const auto value = [&](std::uint32_t v) { return static_cast<double>(decode_component(stream, v, component)); };
    const glm::dvec2& from = texels_[origin_];
    const double x = (texel.x - from.x) / (texels_[along_].x - from.x);
    const double y = (texel.y - from.y) / (texels_[across_].y - from.y);
    return value(origin_) + x * (value(along_) - value(origin_)) + y * (value(across_) - value(origin_));
  }

  const VertexStreams& vertices_;
  glm::dvec2 size_;
  std::vector<glm::dvec2> texels_;  ///< [vertex]
  std::uint32_t origin_ = 0, along_ = 0, across_ = 0;
  glm::dvec2 least_{0}, most_{0};
};

bool is_plain(const VertexStreams& vertices) {
  return vertices.morph_targets.empty() && std::ranges::all_of(vertices.base, [&](const VertexStream& stream) {
           return stream.format.component == Component::float32 && stream.count() == vertices.count;
         });
}

}  // namespace

std::string why_not_cut(const Scene& scene, const Draw& draw) {
  if (!draw.frame) return "it was not made from an image, so it has no frame";
  const SpriteFrame& frame = *draw.frame;
  if (draw.levels.size() != 1 || draw.full().orders.size() != 1)
    return "it has several levels of detail or several orders";
  const Material* material = scene.material_of(draw);
  if (material == nullptr || !material->base_colour) return "its material has no texture";
  const Texture& texture = *material->base_colour;
  if (!texture.image || *texture.image >= scene.images.size()) return "the format of its texture is not supported";
  const auto& facts = scene.images[*texture.image].facts;
  if (!facts) return "the size of its image is unknown";
  if (std::uint64_t{frame.x} + frame.width > facts->width || std::uint64_t{frame.y} + frame.height > facts->height ||
      frame.width == 0 || frame.height == 0) {
    return "its frame is empty or extends beyond the image";
  }
  if (!is_plain(*draw.full().vertices)) return "it has morph targets, or attributes that are not 32-bit floats";
  if (sprite_pieces(draw, texture.texcoord).size() != 1 || !is_made_of_quads(draw, texture.texcoord)) {
    return "it is not a single quad; put sprite-frames before particle-trim";
  }
  if (!ShownQuad(draw, texture, *facts).shows(frame)) return "its quad does not show exactly its frame of the image";
  return {};
}

std::vector<Draw> cut_draws(const Scene& scene, const Draw& draw, std::span<const SpriteFrame> frames) {
  const Texture& texture = *scene.material_of(draw)->base_colour;
  const ShownQuad quad(draw, texture, *scene.images[*texture.image].facts);
  std::vector<Draw> cut;
  for (const SpriteFrame& frame : frames) {
    cut.push_back(draw);
    cut.back().frame = frame;
    cut.back().levels[0].vertices = std::make_shared<const VertexStreams>(quad.cut_to(frame));
  }
  return cut;
}

}  // namespace foredraw
