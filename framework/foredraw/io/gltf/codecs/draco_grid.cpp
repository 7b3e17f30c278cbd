// Floats that lie on a lattice of powers of two, as Draco's quantisation holds them without loss.
#include <foredraw/io/gltf/codecs/private/draco_encode.h>
#include <foredraw/scene/coded_values.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace foredraw::gltf {

namespace {

constexpr int most_bits = 22;
constexpr int least_exponent = -100,
              greatest_exponent = 100;  // so that steps and ranges are no denormals, nor infinite

/// The exponent of the coarsest step; nothing where a value lies on no grid.
std::optional<int> exponent_of(std::span<const float> values) {
  int exponent = greatest_exponent;
  for (const float value : values) {
    if (value == 0) {
      if (std::signbit(value)) return std::nullopt;
      continue;
    }
    const auto lattice = lattice_of(value);
    if (!lattice) return std::nullopt;
    exponent = std::min(exponent, *lattice);
  }
  if (exponent < least_exponent) return std::nullopt;
  return exponent == greatest_exponent ? 0 : exponent;
}

}  // namespace

std::optional<DracoGrid> draco_grid(std::span<const float> values, std::size_t components) {
  const auto exponent = exponent_of(values);
  if (!exponent || values.empty()) return std::nullopt;
  DracoGrid grid{1, std::ldexp(1.0f, *exponent), {}};
  for (std::size_t c = 0; c < components; ++c) {
    double least = values[c], greatest = values[c];
    for (std::size_t i = c; i < values.size(); i += components) {
      least = std::min(least, double{values[i]});
      greatest = std::max(greatest, double{values[i]});
    }
    const double numbers = (greatest - least) / double{grid.step};
    if (!(numbers < (1 << most_bits))) return std::nullopt;
    grid.bits = std::max(grid.bits, static_cast<int>(std::bit_width(static_cast<std::uint32_t>(numbers))));
    grid.origin.push_back(static_cast<float>(least));
  }
  return grid;
}

}  // namespace foredraw::gltf
