#include "uv_grid.h"

#include <algorithm>
#include <cmath>

namespace foredraw::processors::particle_trim {

std::int64_t UvGrid::parts() const {
  switch (format_) {
    case UvFormat::float32: return std::int64_t{1} << 24;
    case UvFormat::float16: return std::int64_t{1} << 11;
    default: return 65535;
  }
}

std::int64_t UvGrid::nearest(double coordinate) const {
  const auto number = static_cast<std::int64_t>(std::floor(coordinate * static_cast<double>(parts()) + 0.5));
  if (format_ == UvFormat::unorm16) return std::clamp<std::int64_t>(number, 0, 65535);
  // Numbers of 1 and more are multiples of twice as much, and so on.
  std::int64_t step = 1;
  while (std::abs(number) > step * parts()) step *= 2;
  return (number >= 0 ? number + step / 2 : number - step / 2) / step * step;
}

double UvGrid::error(double size) const {
  double step = 1;
  while (format_ != UvFormat::unorm16 && size > step) step *= 2;
  return step / static_cast<double>(parts());
}

}  // namespace foredraw::processors::particle_trim
