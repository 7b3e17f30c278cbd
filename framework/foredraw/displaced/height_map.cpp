#include <foredraw/displaced/height_map.h>

#include <foredraw/image/texture_uv.h>
#include <foredraw/scene/image.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace foredraw {

namespace {

template <class T>
std::uint16_t height_of(T value) {
  if constexpr (std::is_same_v<T, std::uint8_t>) return static_cast<std::uint16_t>(value * 257);
  if constexpr (std::is_same_v<T, std::uint16_t>) return value;
  if constexpr (std::is_same_v<T, float>) {
    return value > 0 ? static_cast<std::uint16_t>(std::lround(std::min(value, 1.0f) * 65535.0)) : std::uint16_t{0};
  }
}

template <class T>
std::vector<std::uint16_t> first_channel(const Texels& texels, std::size_t count) {
  std::vector<std::uint16_t> heights(count);
  const std::size_t step = static_cast<std::size_t>(texels.facts.channels) * sizeof(T);
  for (std::size_t i = 0; i < count; ++i) {
    T value;
    std::memcpy(&value, texels.bytes.data() + i * step, sizeof(T));
    heights[i] = height_of(value);
  }
  return heights;
}

/// Why there is none is kept as well.
struct DecodedHeights {
  static constexpr std::string_view name = "decoded-heights";
  std::shared_ptr<const HeightMap> map;
  std::string why_not;
  std::size_t bytes() const { return map ? map->bytes() : 0; }
};

std::uint8_t word(Wrap wrap) {
  return wrap == Wrap::clamped    ? FOREDRAW_HEIGHT_CLAMPED
         : wrap == Wrap::mirrored ? FOREDRAW_HEIGHT_MIRRORED
                                  : FOREDRAW_HEIGHT_REPEAT;
}

}  // namespace

HeightMap height_map(const Texels& texels) {
  HeightMap map{texels.facts.width, texels.facts.height, {}};
  const std::size_t count = std::size_t{map.width} * map.height;
  map.texels = texels.facts.bits == 8    ? first_channel<std::uint8_t>(texels, count)
               : texels.facts.bits == 16 ? first_channel<std::uint16_t>(texels, count)
                                         : first_channel<float>(texels, count);
  return map;
}

std::variant<std::shared_ptr<const HeightMap>, std::string> height_map_of(Analyses& analyses, const Image& image) {
  const Stamp parts[] = {image.bytes.stamp(), content_hash(std::span<const char>(image.uri))};
  const auto decoded = analyses.get<DecodedHeights>(combine(parts), [&]() -> DecodedHeights {
    const auto texels = analyses.decode(image);
    if (const std::string* why = std::get_if<std::string>(&texels)) return {nullptr, *why};
    const ImageFacts& facts = std::get<Texels>(texels).facts;
    if (facts.width > 65536 || facts.height > 65536) return {nullptr, "the map is more than 65536 texels wide or high"};
    return {std::make_shared<const HeightMap>(height_map(std::get<Texels>(texels))), {}};
  });
  if (!decoded->map) return decoded->why_not;
  return decoded->map;
}

foredraw_height_map sampled(const HeightMap& map, const Texture& texture) {
  return {map.texels.data(),
          map.width,
          map.height,
          {word(texture.wrap[0]), word(texture.wrap[1])},
          static_cast<std::uint8_t>(texture.is_nearest)};
}

std::vector<std::array<std::int32_t, 2>> height_places(const VertexStream& texcoords, const Texture& texture,
                                                       const HeightMap& map) {
  std::vector<std::array<std::int32_t, 2>> places;
  for (const glm::dvec2& uv : texture_uv(texcoords, texture)) {
    places.push_back({foredraw_height_place(static_cast<float>(uv.x), map.width),
                      foredraw_height_place(static_cast<float>(uv.y), map.height)});
  }
  return places;
}

}  // namespace foredraw
