// What the filters of compressed attributes stand for (appendix B of the extensions).
#include <foredraw/io/gltf/private/meshopt.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace foredraw::gltf {

namespace {

/// To the nearest, halves away from zero, and into the type's range: a damaged stream may say anything.
template <class T>
T rounded(float value) {
  constexpr auto most = static_cast<float>(std::numeric_limits<T>::max());
  const float away = value + (value < 0 ? -0.5f : 0.5f);
  return std::isnan(away) ? T{0} : static_cast<T>(std::clamp(away, std::is_signed_v<T> ? -most : 0.0f, most));
}

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
  auto x = static_cast<float>(load<T>(element));
  auto y = static_cast<float>(load<T>(element + sizeof(T)));
  const float z = static_cast<float>(load<T>(element + 2 * sizeof(T))) - std::abs(x) - std::abs(y);
  const float folded = std::min(z, 0.0f);  // the lower half lies folded out around the upper
  x += x < 0 ? -folded : folded;
  y += y < 0 ? -folded : folded;
  const float scale = static_cast<float>(std::numeric_limits<T>::max()) / std::sqrt(x * x + y * y + z * z);
  store(element, rounded<T>(x * scale));
  store(element + sizeof(T), rounded<T>(y * scale));
  store(element + 2 * sizeof(T), rounded<T>(z * scale));
}

/// Three components of a unit quaternion, and which one is left out: the greatest, which follows from the others. The
/// fourth number holds that in its low 2 bits, and what stands for 1/sqrt(2).
void quaternion(std::byte* element) {
  constexpr float one = 32767;
  const auto last = load<std::int16_t>(element + 6);
  const float scale = 0.70710678f / static_cast<float>(last | 3);
  float parts[3];
  float rest = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    parts[i] = static_cast<float>(load<std::int16_t>(element + 2 * i)) * scale;
    rest -= parts[i] * parts[i];
  }
  const auto greatest = static_cast<std::size_t>(last & 3);
  for (std::size_t i = 0; i < 3; ++i) {
    store(element + 2 * ((greatest + 1 + i) % 4), rounded<std::int16_t>(parts[i] * one));
  }
  store(element + 2 * greatest, rounded<std::int16_t>(std::sqrt(std::max(rest, 0.0f)) * one));
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
  for (std::size_t i = 0; i < 4; ++i) store(element + i * sizeof(T), rounded<T>(static_cast<float>(parts[i]) * scale));
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
