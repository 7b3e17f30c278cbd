#include "rounded_streams.h"

#include "quantize.h"

#include <foredraw/scene/coded_values.h>
#include <foredraw/scene/encode_component.h>

#include <algorithm>
#include <cstring>

namespace foredraw {

namespace {

constexpr double degree = 0.017453292519943295;

/// Of angles up to 90 degrees, by its series: the system's may differ from machine to machine.
double sine(double x) {
  double sum = 0;
  double term = x;
  for (int i = 1; i < 20; i += 2) {
    sum += term;
    term *= -x * x / ((i + 1.0) * (i + 2.0));
  }
  return sum;
}

/// The inverse of chord_of(), for figures alone.
double degrees_of(double chord) { return 2 * std::asin(std::min(chord / 2, 1.0)) / degree; }

const float* floats_of(const VertexStream& stream) {
  return reinterpret_cast<const float*>(stream.bytes.view().data());
}

bool are_finite(const VertexStream& stream) {
  const float* first = floats_of(stream);
  return std::all_of(first, first + stream.bytes.size() / sizeof(float), [](float f) { return std::isfinite(f); });
}

template <class T>
VertexStream stream_like(const VertexStream& like, Format format, const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return {like.semantic, format, Shared<std::byte>(std::vector<std::byte>(bytes.begin(), bytes.end()))};
}

Format format_of(Component component, std::uint8_t components) {
  return {component, components, true, static_cast<std::uint16_t>(components * bytes_of(component))};
}

/// The elements as directions of so many bits; nothing where one of them is farther off than `most`, a chord.
template <class T>
std::optional<RoundedStream> directions(const VertexStream& from, int bits, double most) {
  const std::size_t parts = from.format.components;
  const float* values = floats_of(from);
  std::vector<T> made(from.count() * parts);
  double farthest = 0;
  for (std::size_t v = 0; v < from.count(); ++v) {
    const float* value = values + v * parts;
    const glm::dvec3 wanted(value[0], value[1], value[2]);
    const auto near = direction_of<T>(nearest_point<T>(wanted, bits));
    std::copy(near.begin(), near.end(), made.begin() + static_cast<std::ptrdiff_t>(v * parts));
    if (parts == 4) made[v * 4 + 3] = value[3] < 0 ? -std::numeric_limits<T>::max() : std::numeric_limits<T>::max();
    const double length = std::sqrt(wanted.x * wanted.x + wanted.y * wanted.y + wanted.z * wanted.z);
    if (length == 0) continue;
    const glm::dvec3 is(near[0], near[1], near[2]);
    const glm::dvec3 off = is / std::sqrt(is.x * is.x + is.y * is.y + is.z * is.z) - wanted / length;
    farthest = std::max(farthest, off.x * off.x + off.y * off.y + off.z * off.z);
    if (farthest > most * most) return std::nullopt;
  }
  const Component component = sizeof(T) == 1 ? Component::int8 : Component::int16;
  return RoundedStream{
      stream_like(from, format_of(component, from.format.components), made), degrees_of(std::sqrt(farthest)), {}};
}

template <class T>
std::optional<RoundedStream> parts_of_one(const VertexStream& from, double most) {
  const Component component = sizeof(T) == 1 ? Component::uint8 : Component::uint16;
  const Format format = format_of(component, from.format.components);
  std::vector<T> made(from.count() * format.components);
  VertexStream to = stream_like(from, format, made);
  double error = 0;
  for (std::size_t i = 0; i < made.size(); ++i) {
    const float value = decode_component(from, i / format.components, i % format.components);
    if (!(value >= 0 && value <= 1)) return std::nullopt;
    encode_component(reinterpret_cast<std::byte*>(&made[i]), format, value);
    error = std::max(error, std::abs(double(value) - made[i] / double(std::numeric_limits<T>::max())));
    if (error > most) return std::nullopt;
  }
  return RoundedStream{stream_like(from, format, made), error, {}};
}

}  // namespace

double chord_of(double degrees) { return 2 * sine(std::min(degrees, 180.0) * degree / 2); }

RoundedStream on_lattice(const VertexStream& stream, double distance) {
  if (distance <= 0 || stream.format.component != Component::float32 || stream.count() == 0) return {};
  if (!are_finite(stream)) return {{}, 0, "some of whose numbers are not finite"};
  const std::size_t parts = stream.format.components;
  const std::vector<int> exponents = lattice_exponents(distance, parts);
  const float* values = floats_of(stream);
  std::vector<float> made(stream.count() * parts);
  double farthest = 0;
  for (std::size_t v = 0; v < stream.count(); ++v) {
    double square = 0;
    for (std::size_t i = v * parts; i < (v + 1) * parts; ++i) {
      const int exponent = exponents[i % parts];
      const double number = std::round(std::ldexp(double(values[i]), -exponent));
      // Beyond that floats have gaps as wide as the lattice, and the filter no bits.
      if (!(std::abs(number) < (1 << 23))) return {{}, 0, "too far from 0 for floats to be rounded so finely"};
      made[i] = static_cast<float>(std::ldexp(number, exponent)) + 0.0f;  // no -0
      square += (double(made[i]) - values[i]) * (double(made[i]) - values[i]);
    }
    farthest = std::max(farthest, square);
  }
  return {stream_like(stream, stream.format, made), std::sqrt(farthest), {}};
}

RoundedStream as_directions(const VertexStream& stream, double degrees, const std::atomic<bool>* cancel) {
  if (degrees <= 0 || stream.format.component != Component::float32 || stream.format.components < 3) return {};
  if (!are_finite(stream)) return {{}, 0, "some of whose numbers are not finite"};
  const double most = chord_of(degrees);
  const auto is_cancelled = [&] { return cancel != nullptr && cancel->load(std::memory_order_relaxed); };
  for (int bits = 2; bits <= 8 && !is_cancelled(); ++bits) {
    if (auto made = directions<std::int8_t>(stream, bits, most)) return *std::move(made);
  }
  for (int bits = 8; bits <= 16 && !is_cancelled(); ++bits) {
    if (auto made = directions<std::int16_t>(stream, bits, most)) return *std::move(made);
  }
  return {{}, 0, "which 16 bits do not hold so finely"};
}

RoundedStream as_parts(const VertexStream& stream, double error) {
  const Component was = stream.format.component;
  if (error <= 0 || (was != Component::float32 && was != Component::uint16)) return {};
  if (was == Component::float32 && !are_finite(stream)) return {{}, 0, "some of whose numbers are not finite"};
  if (auto made = parts_of_one<std::uint8_t>(stream, error)) return *std::move(made);
  if (was == Component::uint16) return {};
  if (auto made = parts_of_one<std::uint16_t>(stream, error)) return *std::move(made);
  return on_lattice(stream, error);
}

}  // namespace foredraw
