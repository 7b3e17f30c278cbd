#include <foredraw/image/alpha_image.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace foredraw {

namespace {

/// What alpha_image_of() keeps: an image's alpha, or why there is none.
struct DecodedAlpha {
  static constexpr std::string_view name = "alpha";
  std::shared_ptr<const AlphaImage> image;
  std::string why_not;
  std::size_t bytes() const { return image ? image->alpha.size() * sizeof(std::uint16_t) : 0; }
};

/// A channel's value, 0 to 65535.
template <class T>
std::uint16_t value_at(const std::byte* bytes, std::size_t channel) {
  T value;
  std::memcpy(&value, bytes + channel * sizeof(T), sizeof(T));
  if constexpr (sizeof(T) == 1) {
    return static_cast<std::uint16_t>(257 * value);
  } else if constexpr (sizeof(T) == 2) {
    return value;
  } else {
    return static_cast<std::uint16_t>(value > 0 ? std::max(1.0f, std::min(1.0f, value) * 65535.0f + 0.5f) : 0.0f);
  }
}

/// Rec. 709's weights in 1/65536, rounded up.
std::uint16_t luminance(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
  return static_cast<std::uint16_t>((13933 * red + 46871 * green + 4732 * blue + 65535) >> 16);
}

template <class T>
void read_alpha(const Texels& texels, AlphaChannel channel, std::vector<std::uint16_t>& alpha) {
  const auto channels = static_cast<std::size_t>(texels.facts.channels);
  const bool has_colours = channels >= 3;
  const std::byte* at = texels.bytes.data();
  for (std::uint16_t& to : alpha) {
    const auto value = [at](std::size_t i) { return value_at<T>(at, i); };
    if (channel == AlphaChannel::alpha) {
      to = value(channels - 1);
    } else if (channel == AlphaChannel::luminance) {
      to = has_colours ? luminance(value(0), value(1), value(2)) : value(0);
    } else {
      to = value(0);
      for (std::size_t i = 1; i < channels; ++i) to = std::max(to, value(i));
    }
    at += channels * sizeof(T);
  }
}

/// Which texels of a finer level one of a coarser level covers along one axis, and how much of each, in 1/`coarse`
/// texels: the finer has `fine` of them, the coarser `coarse`.
struct Covered {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::array<std::uint64_t, 3> share{};
};

std::vector<Covered> covered_by(std::uint32_t fine, std::uint32_t coarse) {
  std::vector<Covered> all(coarse);
  for (std::uint32_t i = 0; i < coarse; ++i) {
    // In units of 1 / (fine * coarse) of the image's side a fine texel is `coarse` long and a coarse one `fine`.
    const std::uint64_t begin = std::uint64_t{i} * fine, end = begin + fine;
    Covered& covered = all[i];
    covered.first = static_cast<std::uint32_t>(begin / coarse);
    for (std::uint64_t at = begin; at < end; ++covered.count) {
      const std::uint64_t next = std::min(end, (at / coarse + 1) * coarse);
      covered.share[covered.count] = next - at;
      at = next;
    }
  }
  return all;
}

/// In steps from the image's edge. What is not finite, or so far off that nothing is to be told there, lies at 0.
std::int64_t in_steps(double place, std::uint32_t texels) {
  constexpr double far_off = 1 << 20;
  if (!(std::abs(place) < far_off)) return 0;
  return static_cast<std::int64_t>(std::floor(place * texels * static_cast<double>(steps_per_texel) + 0.5));
}

}  // namespace

AlphaImage alpha_image(const Texels& texels, AlphaChannel channel) {
  const ImageFacts& facts = texels.facts;
  AlphaImage image{facts.width, facts.height, {}};
  const std::size_t count = std::size_t{facts.width} * facts.height;
  if (channel == AlphaChannel::alpha && facts.channels % 2 == 1) {
    image.alpha.assign(count, 65535);
    image.is_made_up = true;
    return image;
  }
  image.alpha.resize(count);
  if (facts.bits == 8) {
    read_alpha<std::uint8_t>(texels, channel, image.alpha);
  } else if (facts.bits == 16) {
    read_alpha<std::uint16_t>(texels, channel, image.alpha);
  } else {
    read_alpha<float>(texels, channel, image.alpha);
  }
  return image;
}

std::variant<std::shared_ptr<const AlphaImage>, std::string> alpha_image_of(Analyses& analyses, const Image& image,
                                                                            AlphaChannel channel) {
  const Stamp parts[] = {image.bytes.stamp(), content_hash(std::span<const char>(image.uri)),
                         content_hash(std::span<const AlphaChannel>(&channel, 1))};
  const auto decoded = analyses.get<DecodedAlpha>(combine(parts), [&]() -> DecodedAlpha {
    const auto texels = analyses.decode(image);
    if (const std::string* why = std::get_if<std::string>(&texels)) return {nullptr, *why};
    return {std::make_shared<const AlphaImage>(alpha_image(std::get<Texels>(texels), channel)), {}};
  });
  if (!decoded->image) return decoded->why_not;
  return decoded->image;
}

AlphaImage next_level(const AlphaImage& image) {
  AlphaImage level{std::max(1u, image.width / 2), std::max(1u, image.height / 2), {}};
  level.alpha.resize(std::size_t{level.width} * level.height);
  const std::vector<Covered> columns = covered_by(image.width, level.width);
  const std::vector<Covered> rows = covered_by(image.height, level.height);
  const std::uint64_t area = std::uint64_t{image.width} * image.height;
  std::size_t to = 0;
  for (const Covered& row : rows) {
    for (const Covered& column : columns) {
      std::uint64_t sum = 0;
      for (std::uint32_t y = 0; y < row.count; ++y) {
        const std::uint16_t* from = &image.alpha[std::size_t{row.first + y} * image.width + column.first];
        for (std::uint32_t x = 0; x < column.count; ++x) sum += row.share[y] * column.share[x] * from[x];
      }
      level.alpha[to++] = static_cast<std::uint16_t>((sum + area - 1) / area);
    }
  }
  return level;
}

std::uint32_t wrapped(std::int64_t texel, std::uint32_t count, Wrap wrap) {
  const auto remainder = [](std::int64_t number, std::int64_t divisor) {
    const std::int64_t rest = number % divisor;
    return rest < 0 ? rest + divisor : rest;
  };
  const std::int64_t edge = count;
  if (wrap == Wrap::clamped) return static_cast<std::uint32_t>(std::clamp<std::int64_t>(texel, 0, edge - 1));
  if (wrap == Wrap::repeat) return static_cast<std::uint32_t>(remainder(texel, edge));
  const std::int64_t there_and_back = remainder(texel, 2 * edge);
  return static_cast<std::uint32_t>(std::min(there_and_back, 2 * edge - 1 - there_and_back));
}

double alpha_at(const AlphaImage& image, const Sampling& sampling, const glm::dvec2& uv) {
  const auto texel = [&](std::int64_t x, std::int64_t y) {
    return std::int64_t{
        image.at(wrapped(x, image.width, sampling.wrap[0]), wrapped(y, image.height, sampling.wrap[1]))};
  };
  constexpr std::int64_t steps = steps_per_texel;
  constexpr double most = 65535;
  std::int64_t x = in_steps(uv.x, image.width);
  std::int64_t y = in_steps(uv.y, image.height);
  if (sampling.is_nearest) return static_cast<double>(texel(x >> 8, y >> 8)) / most;
  x -= steps / 2;
  y -= steps / 2;
  const std::int64_t right = x & (steps - 1), down = y & (steps - 1);
  x >>= 8;
  y >>= 8;
  const std::int64_t upper = texel(x, y) * (steps - right) + texel(x + 1, y) * right;
  const std::int64_t lower = texel(x, y + 1) * (steps - right) + texel(x + 1, y + 1) * right;
  return static_cast<double>(upper * (steps - down) + lower * down) / (steps * steps * most);
}

}  // namespace foredraw
