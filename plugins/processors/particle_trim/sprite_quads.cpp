#include "sprite_quads.h"

#include "fewest_inner_edges.h"

#include <foredraw/image/sprite_pieces.h>
#include <foredraw/image/texture_uv.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace foredraw::processors::particle_trim {

namespace {

using Bytes = std::span<const std::byte>;

Bytes element(const VertexStream& stream, std::uint32_t vertex) {
  return stream.bytes.view().subspan(std::size_t{vertex} * stream.format.bytes, stream.format.bytes);
}

bool is_float(const VertexStream& stream) { return stream.format.component == Component::float32; }

std::string texcoord_name(const Texture& texture) { return "TEXCOORD_" + std::to_string(texture.texcoord); }

/// Whether the attribute runs evenly over the quad, so that it is known beyond it.
bool runs_evenly(const VertexStream& stream, const SpriteQuad& quad) {
  if (!is_float(stream)) {
    return std::ranges::all_of(quad.outline, [&](std::uint32_t vertex) {
      return std::ranges::equal(element(stream, vertex), element(stream, quad.outline[0]));
    });
  }
  for (std::size_t k = 0; k < stream.format.components; ++k) {
    std::array<float, 4> corner{};
    for (std::size_t i = 0; i < 4; ++i) corner[i] = decode_component(stream, quad.outline[i], k);
    const auto [least, most] = std::ranges::minmax(corner);
    if (!(std::abs(corner[0] - corner[1] + corner[2] - corner[3]) <= 1e-4f * (most - least) + 1e-6f)) return false;
  }
  return true;
}

Point rounded(const glm::dvec2& place, const AlphaImage& image, bool up) {
  const auto steps = [&](double coordinate, std::uint32_t texels) {
    const double exact = coordinate * texels * static_cast<double>(steps_per_texel);
    // Coordinates that mean an edge of a texel may miss it by their own rounding.
    const double nearest = std::floor(exact + 0.5);
    if (std::abs(exact - nearest) < 0.01) return static_cast<std::int64_t>(nearest);
    return static_cast<std::int64_t>(up ? std::ceil(exact) : std::floor(exact));
  };
  return {steps(place.x, image.width), steps(place.y, image.height)};
}

SpriteQuad quad_of(const SpritePiece& piece, const std::vector<glm::dvec2>& places, const AlphaImage& image) {
  SpriteQuad quad;
  std::ranges::copy(piece.outline, quad.outline.begin());
  glm::dvec2 least = places[quad.outline[0]], most = least;
  double doubled_area = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec2 &p = places[quad.outline[i]], &q = places[quad.outline[(i + 1) % 4]];
    least = glm::min(least, p);
    most = glm::max(most, p);
    doubled_area += p.x * q.y - p.y * q.x;
  }
  quad.is_clockwise = doubled_area > 0;
  for (const std::uint32_t vertex : quad.outline) {
    const glm::dvec2 middle = 0.5 * (least + most);
    const bool is_right = places[vertex].x > middle.x, is_low = places[vertex].y > middle.y;
    if (!(is_right && is_low)) quad.axes[is_right ? 1 : is_low ? 2 : 0] = vertex;
  }
  quad.frame = {rounded(least, image, false), rounded(most, image, true)};
  return quad;
}

bool is_clockwise(const SpriteQuad& quad, TrimWinding winding) {
  return winding == TrimWinding::as_before ? quad.is_clockwise : winding == TrimWinding::clockwise;
}

/// The new vertices of one quad, stream by stream.
class PolygonVertices {
 public:
  PolygonVertices(const SpriteQuad& quad, const std::vector<glm::dvec2>& places)
      : quad_(quad),
        origin_(places[quad.axes[0]]),
        size_(places[quad.axes[1]].x - origin_.x, places[quad.axes[2]].y - origin_.y) {}

  void add(const VertexStream& stream, const glm::dvec2& place, std::vector<std::byte>& bytes) const {
    const glm::dvec2 along = (place - origin_) / size_;
    const auto first = element(stream, quad_.axes[0]);
    if (!is_float(stream)) {
      bytes.insert(bytes.end(), first.begin(), first.end());
      return;
    }
    for (std::size_t k = 0; k < stream.format.components; ++k) {
      const auto at = [&](std::size_t i) { return static_cast<double>(decode_component(stream, quad_.axes[i], k)); };
      append(static_cast<float>(at(0) + along.x * (at(1) - at(0)) + along.y * (at(2) - at(0))), bytes);
    }
  }

  template <class T>
  static void append(T value, std::vector<std::byte>& bytes) {
    const auto* from = reinterpret_cast<const std::byte*>(&value);
    bytes.insert(bytes.end(), from, from + sizeof(T));
  }

 private:
  const SpriteQuad& quad_;
  glm::dvec2 origin_, size_;
};

void add_texcoord(const glm::dvec2& place, UvFormat format, std::vector<std::byte>& bytes) {
  for (const double coordinate : {place.x, place.y}) {
    if (format == UvFormat::unorm16) {
      PolygonVertices::append(static_cast<std::uint16_t>(std::floor(coordinate * 65535 + 0.5)), bytes);
    } else {
      PolygonVertices::append(static_cast<float>(coordinate), bytes);
    }
  }
}

Format texcoord_format(UvFormat format) {
  return format == UvFormat::unorm16 ? Format{Component::uint16, 2, true, 4} : Format{Component::float32, 2, false, 8};
}

}  // namespace

std::variant<std::vector<SpriteQuad>, std::string> sprite_quads(const Draw& draw, const Texture& texture,
                                                                const AlphaImage& image) {
  const Level& level = draw.full();
  if (draw.levels.size() > 1 || level.orders.size() > 1) return "it has several levels of detail or several orders";
  if (!level.vertices->morph_targets.empty()) return "it has morph targets";
  if (texture.scale != glm::dvec2(1) || texture.rotation != 0 || texture.offset != glm::dvec2(0)) {
    return "KHR_texture_transform moves its texture coordinates";
  }
  if (!is_made_of_quads(draw, texture.texcoord)) return "it is not made of upright quads; it may be trimmed already";
  const VertexStreams& vertices = *level.vertices;
  const auto places = texture_uv(*vertices.find(texcoord_name(texture)), texture);
  std::vector<SpriteQuad> quads;
  for (const SpritePiece& piece : sprite_pieces(draw, texture.texcoord)) {
    quads.push_back(quad_of(piece, places, image));
    for (const VertexStream& stream : vertices.base) {
      const bool is_its_own = stream.semantic == texcoord_name(texture);
      if (!is_its_own && !runs_evenly(stream, quads.back())) {
        return stream.semantic + " is not linear over its quads" +
               (is_float(stream) ? "" : ", or is stored as integers that are not all equal");
      }
    }
    constexpr std::int64_t most = std::int64_t{1} << 24;  // 65536 texels
    const TrimFrame& frame = quads.back().frame;
    for (const std::int64_t number : {frame.least.x, frame.least.y, frame.most.x, frame.most.y}) {
      if (std::abs(number) > most) return "its texture coordinates lie more than 65536 texels from the image";
    }
  }
  return quads;
}

Draw with_polygons(const Draw& draw, const std::vector<SpriteQuad>& quads, const std::vector<TrimmedSprite>& sprites,
                   const Texture& texture, const AlphaImage& image, const ParticleTrimOptions& options) {
  const VertexStreams& old = *draw.full().vertices;
  const std::string texcoord = texcoord_name(texture);
  const auto places = texture_uv(*old.find(texcoord), texture);
  const glm::dvec2 size(image.width, image.height);
  // A quad that stays may reach out of what the format holds.
  const bool stays = std::ranges::any_of(sprites, [](const TrimmedSprite& sprite) { return sprite.corners.empty(); });
  const UvFormat stored = stays ? UvFormat::float32 : options.uv;

  auto vertices = std::make_shared<VertexStreams>();
  std::vector<std::vector<std::byte>> bytes(old.base.size());
  std::vector<std::uint32_t> indices;
  for (std::size_t q = 0; q < quads.size(); ++q) {
    std::vector<glm::dvec2> corners = sprites[q].corners;
    const bool is_trimmed = !corners.empty();
    if (!is_trimmed) {
      for (const std::uint32_t vertex : quads[q].outline) corners.push_back(places[vertex]);
    } else if (!is_clockwise(quads[q], options.winding)) {
      std::reverse(corners.begin() + 1, corners.end());
    }
    const PolygonVertices polygon(quads[q], places);
    std::vector<glm::dvec2> in_texels;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      in_texels.push_back(corners[k] * size);
      for (std::size_t s = 0; s < old.base.size(); ++s) {
        const VertexStream& stream = old.base[s];
        if (stream.semantic == texcoord) {
          add_texcoord(corners[k], stored, bytes[s]);
        } else if (is_trimmed) {
          polygon.add(stream, corners[k], bytes[s]);
        } else {
          const Bytes kept = element(stream, quads[q].outline[k]);
          bytes[s].insert(bytes[s].end(), kept.begin(), kept.end());
        }
      }
    }
    for (const auto& triangle : fewest_inner_edges(in_texels)) {
      for (const std::uint32_t corner : triangle) indices.push_back(vertices->count + corner);
    }
    vertices->count += static_cast<std::uint32_t>(corners.size());
  }
  for (std::size_t s = 0; s < old.base.size(); ++s) {
    const VertexStream& stream = old.base[s];
    vertices->base.push_back({stream.semantic, stream.semantic == texcoord ? texcoord_format(stored) : stream.format,
                              Shared<std::byte>(std::move(bytes[s]))});
  }
  Draw made = draw;
  made.levels = {{std::move(vertices), {{.indices = Shared<std::uint32_t>(std::move(indices))}}}};
  made.full().made = draw.full().made;
  return made;
}

}  // namespace foredraw::processors::particle_trim
