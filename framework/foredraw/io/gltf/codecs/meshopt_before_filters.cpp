// Elements that a filter gives, back to what it makes them of. Values that were rounded to what a filter gives, as
// stages do, take fewer bytes that way, and none of them changes.
#include <foredraw/io/gltf/codecs/private/meshopt.h>
#include <foredraw/io/gltf/private/rows.h>
#include <foredraw/scene/coded_values.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace foredraw::gltf {

namespace {

using Filter = Coding::Filter;
using Bytes = std::span<const std::byte>;
using BeforeFilter = std::optional<std::vector<std::byte>>;

template <class T, std::size_t N>
std::array<T, N> load(const std::byte* from) {
  std::array<T, N> values;
  std::memcpy(values.data(), from, sizeof values);
  return values;
}

/// Puts every row with the bits of the one before where these will do, else with the fewest: draws that were rounded
/// apart lie one behind the other. `put` says whether the row can be put so.
template <class Put>
bool put_rows(std::size_t count, int fewest, int most, Put put) {
  int bits = fewest;
  for (std::size_t row = 0; row < count; ++row) {
    if (put(row, bits)) continue;
    bits = fewest;
    while (bits <= most && !put(row, bits)) ++bits;
    if (bits > most) return false;
  }
  return true;
}

template <class T>
BeforeFilter before_octahedral(Bytes elements) {
  constexpr std::size_t stride = 4 * sizeof(T);
  std::vector<std::byte> rows(elements.begin(), elements.end());  // with the fourth component, which stays
  const auto put = [&](std::size_t row, int bits) {
    const auto point = point_of(load<T, 3>(elements.data() + row * stride), bits);
    if (!point) return false;
    const std::array<T, 3> coded{static_cast<T>(point->x), static_cast<T>(point->y), static_cast<T>(point->one)};
    std::memcpy(rows.data() + row * stride, coded.data(), sizeof coded);
    return true;
  };
  const bool can = put_rows(elements.size() / stride, 2, static_cast<int>(8 * sizeof(T)), put);
  return can ? BeforeFilter(std::move(rows)) : std::nullopt;
}

BeforeFilter before_quaternion(Bytes elements) {
  std::vector<std::byte> rows(elements.size());
  const auto put = [&](std::size_t row, int bits) {
    const auto coded = coded_rotation(load<std::int16_t, 4>(elements.data() + row * 8), bits);
    if (!coded) return false;
    const auto last = static_cast<std::int16_t>((coded->one & ~3) | coded->greatest);
    std::memcpy(rows.data() + row * 8, coded->parts.data(), 6);
    std::memcpy(rows.data() + row * 8 + 6, &last, 2);
    return true;
  };
  return put_rows(elements.size() / 8, 4, 16, put) ? BeforeFilter(std::move(rows)) : std::nullopt;
}

constexpr int most_exponent = 100;  ///< either way; decoders may do anything beyond

/// Each component of all elements as whole multiples of one power of two, the greatest that will do.
BeforeFilter before_exponential(Bytes elements, std::size_t stride) {
  constexpr int most = (1 << 23) - 1;
  std::vector<std::byte> rows(elements.size());
  for (std::size_t component = 0; component < stride; component += 4) {
    int exponent = std::numeric_limits<int>::max();
    for (std::size_t at = component; at < elements.size(); at += stride) {
      const float value = load<float, 1>(elements.data() + at)[0];
      if (const auto lattice = lattice_of(value)) exponent = std::min(exponent, *lattice);
    }
    if (exponent == std::numeric_limits<int>::max()) exponent = 0;
    if (std::abs(exponent) > most_exponent) return std::nullopt;
    for (std::size_t at = component; at < elements.size(); at += stride) {
      const float value = load<float, 1>(elements.data() + at)[0];
      const float number = std::ldexp(value, -exponent);
      if (!(std::abs(number) <= static_cast<float>(most)) || (value == 0 && std::signbit(value))) return std::nullopt;
      const auto row = static_cast<std::uint32_t>(exponent) << 24 |
                       (static_cast<std::uint32_t>(static_cast<std::int32_t>(number)) & 0xffffff);
      std::memcpy(rows.data() + at, &row, 4);
    }
  }
  return rows;
}

/// Of one component the coded numbers, with as many zeros below them as put their sign at the top; empty where a number
/// has no room for that, or 8 zeros are not all that it takes.
std::vector<std::byte> with_sign_on_top(Bytes rows) {
  std::vector<std::byte> raised(rows.size());
  for (std::size_t at = 0; at < rows.size(); at += 4) {
    const auto row = load<std::int32_t, 1>(rows.data() + at)[0];
    const int exponent = row >> 24;
    const auto number = static_cast<std::int32_t>(static_cast<std::uint32_t>(row) << 8) >> 8;
    if (number < -(1 << 15) || number >= 1 << 15 || exponent - 8 < -most_exponent) return {};
    const auto made =
        static_cast<std::uint32_t>(exponent - 8) << 24 | ((static_cast<std::uint32_t>(number) << 8) & 0xffffff);
    std::memcpy(raised.data() + at, &made, 4);
  }
  return raised;
}

BeforeFilter candidates(Filter filter, std::size_t stride, Bytes elements) {
  switch (filter) {
    case Filter::octahedral:
      if (stride == 4) return before_octahedral<std::int8_t>(elements);
      return stride == 8 ? before_octahedral<std::int16_t>(elements) : std::nullopt;
    case Filter::quaternion: return stride == 8 ? before_quaternion(elements) : std::nullopt;
    case Filter::exponential: return stride % 4 == 0 ? before_exponential(elements, stride) : std::nullopt;
    case Filter::none:
    case Filter::color:
    case Filter::unknown: break;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::vector<std::byte>> before_filter(Filter filter, std::size_t stride, Bytes elements) {
  auto rows = candidates(filter, stride, elements);
  if (!rows) return std::nullopt;
  std::vector<std::byte> again = *rows;
  apply_filter({Coding::Mode::attributes, filter, elements.size() / stride, stride}, again);
  if (!std::equal(again.begin(), again.end(), elements.begin(), elements.end())) return std::nullopt;
  return rows;
}

std::vector<std::byte> raised_where_shorter(Bytes rows, std::size_t stride, meshopt::VertexVersion version) {
  std::vector<std::byte> result(rows.begin(), rows.end());
  std::vector<std::byte> column(rows.size() / stride * 4);
  for (std::size_t component = 0; component < stride; component += 4) {
    copy_rows(column.data(), 4, rows.data() + component, stride, 4, column.size() / 4);
    const std::vector<std::byte> raised = with_sign_on_top(column);
    const auto bytes = [&](Bytes of) { return meshopt::encode_vertices(of, 4, version).size(); };
    if (raised.empty() || bytes(raised) >= bytes(column)) continue;
    copy_rows(result.data() + component, stride, raised.data(), 4, 4, raised.size() / 4);
  }
  return result;
}

}  // namespace foredraw::gltf
