// What the filters of compressed attributes stand for (appendix B of the extensions).
#include <foredraw/io/gltf/codecs/private/meshopt.h>
#include <foredraw/scene/coded_values.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace foredraw::gltf {

namespace {

template <class T>
T load(const std::byte* from) {
  T value;
  std::memcpy(&value, from, sizeof(T));
  return value;
}

template <class T>
void store(std::byte* to, T value) {
  std::memcpy(to, &value, sizeof(T));
}

/// x and y on the octahedron whose size is z, and a fourth component that stays, to a unit vector.
template <class T>
void octahedral(std::byte* element) {
  const auto direction =
      direction_of<T>({load<T>(element), load<T>(element + sizeof(T)), load<T>(element + 2 * sizeof(T))});
  std::memcpy(element, direction.data(), sizeof direction);
}

/// Three components of a unit quaternion, and which one is left out. The fourth number holds that in its low 2 bits,
/// and what stands for 1/sqrt(2).
void quaternion(std::byte* element) {
  SmallestThree coded;
  std::memcpy(coded.parts.data(), element, sizeof coded.parts);
  coded.one = load<std::int16_t>(element + 6);
  coded.greatest = static_cast<std::uint8_t>(coded.one & 3);
  const auto rotation = rotation_of(coded);
  std::memcpy(element, rotation.data(), sizeof rotation);
}

/// 8 bits of exponent above 24 of whole number, both signed.
void exponential(std::byte* component) {
  const auto bits = load<std::uint32_t>(component);
  const int exponent = static_cast<std::int32_t>(bits) >> 24;
  const int number = static_cast<std::int32_t>(bits << 8) >> 8;
  store(component, std::ldexp(static_cast<float>(number), exponent));
}

/// Luma and two differences of colour, signed, then alpha: all of as many bits as alpha says by its highest one, which
/// stands above its value. To red, green, blue and alpha.
template <class T>
void color(std::byte* element) {
  using Signed = std::make_signed_t<T>;
  const int luma = load<T>(element), orange = load<Signed>(element + sizeof(T));
  const int green = load<Signed>(element + 2 * sizeof(T));
  const unsigned alpha = load<T>(element + 3 * sizeof(T));
  const unsigned most = (1u << std::bit_width(alpha)) - 1;
  const unsigned half = alpha & most >> 1;
  const int parts[4] = {luma + orange - green, luma + green, luma - orange - green,
                        static_cast<int>(half << 1 | (half & 1))};
  const float scale = static_cast<float>(std::numeric_limits<T>::max()) / static_cast<float>(most);
  for (std::size_t i = 0; i < 4; ++i)
    store(element + i * sizeof(T), nearest_whole<T>(static_cast<float>(parts[i]) * scale));
}

}  // namespace

void apply_filter(const Coding& coding, std::span<std::byte> elements) {
  const std::size_t step = coding.filter == Coding::Filter::exponential ? 4 : coding.stride;
  for (std::size_t at = 0; at < elements.size(); at += step) {
    std::byte* element = elements.data() + at;
    switch (coding.filter) {
      case Coding::Filter::octahedral:
        coding.stride == 4 ? octahedral<std::int8_t>(element) : octahedral<std::int16_t>(element);
        break;
      case Coding::Filter::quaternion: quaternion(element); break;
      case Coding::Filter::exponential: exponential(element); break;
      case Coding::Filter::color:
        coding.stride == 4 ? color<std::uint8_t>(element) : color<std::uint16_t>(element);
        break;
      case Coding::Filter::none:
      case Coding::Filter::unknown: return;
    }
  }
}

}  // namespace foredraw::gltf
