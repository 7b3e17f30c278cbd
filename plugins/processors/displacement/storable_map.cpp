#include "storable_map.h"

#include <foredraw/displaced/height_map.h>

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <span>

namespace foredraw {

namespace {

bool is_of_gltf(const Image& image) {
  const auto bytes = image.bytes.view();
  const auto starts = [&](std::initializer_list<unsigned char> with) {
    return bytes.size() >= with.size() && std::equal(with.begin(), with.end(), bytes.begin(),
                                                     [](unsigned char a, std::byte b) { return std::byte{a} == b; });
  };
  return image.is_texels || starts({0x89, 'P', 'N', 'G'}) || starts({0xFF, 0xD8, 0xFF});
}

/// Of the first channel.
std::size_t floats_outside(const Texels& texels) {
  if (!texels.facts.is_float) return 0;
  const std::size_t step = static_cast<std::size_t>(texels.facts.channels) * sizeof(float);
  std::size_t outside = 0;
  for (std::size_t at = 0; at + step <= texels.bytes.size(); at += step) {
    float value;
    std::memcpy(&value, texels.bytes.data() + at, sizeof(value));
    outside += value >= 0 && value <= 1 ? 0 : 1;
  }
  return outside;
}

}  // namespace

std::variant<StorableMap, std::string> storable_map(const Image& image, Analyses& analyses) {
  if (is_of_gltf(image)) return StorableMap{image};
  const auto texels = analyses.decode(image);
  if (const std::string* why = std::get_if<std::string>(&texels)) return *why;
  const HeightMap heights = height_map(std::get<Texels>(texels));
  const auto bytes = std::as_bytes(std::span(heights.texels));
  StorableMap map{{.name = image.name, .bytes = Shared<std::byte>({bytes.begin(), bytes.end()})},
                  true,
                  floats_outside(std::get<Texels>(texels))};
  map.image.is_texels = true;
  map.image.facts = {heights.width, heights.height, 1, 16};
  return map;
}

}  // namespace foredraw
