#pragma once
// Writing what decode_component() reads.

#include <foredraw/scene/vertex_streams.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace foredraw {

/// The nearest value that the format has, into one component's bytes. Halves are rounded away from 0; what is no number
/// is 0 in formats that know none.
inline void encode_component(std::byte* to, const Format& format, float value) {
  const auto whole = [&]<class T>(T) {
    const double scale = format.normalized ? std::numeric_limits<T>::max() : 1.0;
    const double least = format.normalized && std::numeric_limits<T>::is_signed
                             ? -static_cast<double>(std::numeric_limits<T>::max())
                             : static_cast<double>(std::numeric_limits<T>::min());
    const double rounded = std::round(static_cast<double>(value) * scale);
    const double most = std::numeric_limits<T>::max();
    const T stored = std::isnan(rounded) ? T{0} : static_cast<T>(std::clamp(rounded, least, most));
    std::memcpy(to, &stored, sizeof stored);
  };
  switch (format.component) {
    case Component::int8: return whole(std::int8_t{});
    case Component::uint8: return whole(std::uint8_t{});
    case Component::int16: return whole(std::int16_t{});
    case Component::uint16: return whole(std::uint16_t{});
    case Component::uint32: return whole(std::uint32_t{});
    case Component::float32: std::memcpy(to, &value, sizeof value);
  }
}

}  // namespace foredraw
