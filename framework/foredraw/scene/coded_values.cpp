#include <foredraw/scene/coded_values.h>

#include <bit>

namespace foredraw {

namespace {

/// x and y of the octahedron of size 1; the lower half unfolded.
std::array<double, 2> unfolded(const glm::dvec3& d) {
  const double sum = std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
  if (!(sum > 0) || !std::isfinite(sum)) return {0, 0};
  const double x = d.x / sum;
  const double y = d.y / sum;
  if (d.z >= 0) return {x, y};
  return {(1 - std::abs(y)) * (x < 0 ? -1 : 1), (1 - std::abs(x)) * (y < 0 ? -1 : 1)};
}

template <class T>
double cosine(const std::array<T, 3>& a, const glm::dvec3& unit) {
  const glm::dvec3 d(a[0], a[1], a[2]);
  return (d.x * unit.x + d.y * unit.y + d.z * unit.z) / std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

/// Calls visit for the points around (x, y), which need not be whole, row by row.
template <class Visit>
void each_near(double x, double y, std::int32_t one, int around, Visit visit) {
  const auto middle_x = static_cast<std::int32_t>(std::floor(x));
  const auto middle_y = static_cast<std::int32_t>(std::floor(y));
  for (std::int32_t i = middle_y - around + 1; i <= middle_y + around; ++i) {
    for (std::int32_t j = middle_x - around + 1; j <= middle_x + around; ++j) {
      if (std::abs(i) <= one && std::abs(j) <= one) visit(OctahedralPoint{j, i, one});
    }
  }
}

std::int32_t one_of(int bits) { return (1 << (bits - 1)) - 1; }

}  // namespace

template <class T>
OctahedralPoint nearest_point(const glm::dvec3& direction, int bits) {
  const std::int32_t one = one_of(bits);
  const double length = std::sqrt(direction.x * direction.x + direction.y * direction.y + direction.z * direction.z);
  if (!(length > 0) || !std::isfinite(length)) return {0, 0, one};
  const glm::dvec3 unit = direction / length;
  const auto [x, y] = unfolded(unit);
  OctahedralPoint best{0, 0, one};
  double most = -2;
  each_near(x * one, y * one, one, 1, [&](const OctahedralPoint& point) {
    const double now = cosine(direction_of<T>(point), unit);
    if (now > most) {
      most = now;
      best = point;
    }
  });
  return best;
}

template <class T>
std::optional<OctahedralPoint> point_of(const std::array<T, 3>& direction, int bits) {
  const std::int32_t one = one_of(bits);
  const auto [x, y] = unfolded(glm::dvec3(direction[0], direction[1], direction[2]));
  const OctahedralPoint nearest{static_cast<std::int32_t>(std::lround(x * one)),
                                static_cast<std::int32_t>(std::lround(y * one)), one};
  if (direction_of<T>(nearest) == direction) return nearest;  // as a rule
  std::optional<OctahedralPoint> found;
  each_near(x * one, y * one, one, 2, [&](const OctahedralPoint& point) {
    if (!found && direction_of<T>(point) == direction) found = point;
  });
  return found;
}

template OctahedralPoint nearest_point<std::int8_t>(const glm::dvec3&, int);
template OctahedralPoint nearest_point<std::int16_t>(const glm::dvec3&, int);
template std::optional<OctahedralPoint> point_of(const std::array<std::int8_t, 3>&, int);
template std::optional<OctahedralPoint> point_of(const std::array<std::int16_t, 3>&, int);

namespace {

float step_of(const SmallestThree& coded) { return 0.70710678f / static_cast<float>(coded.one | 3); }

std::int16_t as_16_bits(float component) { return nearest_whole<std::int16_t>(component * 32767); }

}  // namespace

std::array<std::int16_t, 4> rotation_of(const SmallestThree& coded) {
  const float step = step_of(coded);
  std::array<std::int16_t, 4> result{};
  float rest = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const float part = static_cast<float>(coded.parts[i]) * step;
    rest -= part * part;
    result[(coded.greatest + 1 + i) % 4] = as_16_bits(part);
  }
  result[coded.greatest] = as_16_bits(std::sqrt(std::max(rest, 0.0f)));
  return result;
}

SmallestThree nearest_rotation(const std::array<double, 4>& rotation, int bits) {
  double length = 0;
  for (const double part : rotation) length += part * part;
  length = std::sqrt(length);
  SmallestThree coded{{}, static_cast<std::int16_t>(one_of(bits)), 3};
  if (!(length > 0) || !std::isfinite(length)) return coded;
  coded.greatest = 0;
  for (std::uint8_t i = 1; i < 4; ++i) {
    if (std::abs(rotation[i]) > std::abs(rotation[coded.greatest])) coded.greatest = i;
  }
  const double sign = rotation[coded.greatest] < 0 ? -1 : 1;  // both stand for the same rotation
  for (std::size_t i = 0; i < 3; ++i) {
    const double part = sign * rotation[(coded.greatest + 1 + i) % 4] / length * std::sqrt(2.0) * (coded.one | 3);
    coded.parts[i] =
        static_cast<std::int16_t>(std::clamp(std::round(part), -double(coded.one | 3), double(coded.one | 3)));
  }
  return coded;
}

std::optional<SmallestThree> coded_rotation(const std::array<std::int16_t, 4>& rotation, int bits) {
  SmallestThree coded{{}, static_cast<std::int16_t>(one_of(bits)), 0};
  const float step = step_of(coded);
  // With many bits several parts become the same component; with few perhaps none does.
  struct Parts {
    std::array<std::int16_t, 3> each{};
    std::size_t count = 0;
  };
  std::array<Parts, 4> parts;
  std::size_t without = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const int middle = static_cast<int>(std::lround(rotation[i] / 32767.0 * std::sqrt(2.0) * (coded.one | 3)));
    for (const int near : {middle, middle + 1, middle - 1}) {
      const auto part = static_cast<std::int16_t>(std::clamp(near, -32767, 32767));
      if (as_16_bits(static_cast<float>(part) * step) == rotation[i]) parts[i].each[parts[i].count++] = part;
    }
    if (parts[i].count == 0 && ++without == 2) return std::nullopt;
  }
  for (; coded.greatest < 4; ++coded.greatest) {  // with few bits it need not be the greatest any more
    const std::array others{&parts[(coded.greatest + 1) % 4], &parts[(coded.greatest + 2) % 4],
                            &parts[(coded.greatest + 3) % 4]};
    const std::size_t choices = others[0]->count * others[1]->count * others[2]->count;
    for (std::size_t choice = 0; choice < choices; ++choice) {
      std::size_t rest = choice;
      for (std::size_t i = 0; i < 3; rest /= others[i++]->count)
        coded.parts[i] = others[i]->each[rest % others[i]->count];
      if (rotation_of(coded) == rotation) return coded;
    }
  }
  return std::nullopt;
}

std::optional<int> lattice_of(float value) {
  if (value == 0 || !std::isfinite(value)) return std::nullopt;
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const int exponent = static_cast<int>(bits >> 23 & 0xff);
  const std::uint32_t significand = (bits & 0x7fffff) | (exponent == 0 ? 0u : 0x800000u);
  return std::max(exponent, 1) - 150 + std::countr_zero(significand);
}

}  // namespace foredraw
