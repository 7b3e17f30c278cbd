#include <foredraw/frames/mipped_image.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace foredraw {

namespace {

using Texel = std::array<std::uint8_t, 4>;

template <class T>
std::uint8_t eight_bits(const std::byte* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  if constexpr (sizeof(T) == 1) return value;
  if constexpr (sizeof(T) == 2) return static_cast<std::uint8_t>(value >> 8);
  if constexpr (sizeof(T) == 4) return static_cast<std::uint8_t>(value > 0 ? std::min(1.0f, value) * 255 + 0.5f : 0);
}

template <class T>
std::vector<Texel> texels_of(const Texels& from) {
  const auto channels = static_cast<std::size_t>(from.facts.channels);
  std::vector<Texel> texels(std::size_t{from.facts.width} * from.facts.height);
  const std::byte* at = from.bytes.data();
  for (Texel& texel : texels) {
    const auto channel = [at](std::size_t i) { return eight_bits<T>(at + i * sizeof(T)); };
    const bool is_grey = channels < 3;
    texel = {channel(0), channel(is_grey ? 0 : 1), channel(is_grey ? 0 : 2),
             channels % 2 == 0 ? channel(channels - 1) : std::uint8_t{255}};
    at += channels * sizeof(T);
  }
  return texels;
}

/// Of half the size, rounded down; each texel the mean of four, or of two at an edge that is one texel long.
MippedImage::MipLevel half_of(const MippedImage::MipLevel& level) {
  MippedImage::MipLevel half{std::max(1, level.width / 2), std::max(1, level.height / 2), {}};
  half.texels.resize(static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
  const auto at = [&](std::int32_t x, std::int32_t y) -> const Texel& {
    const auto row = static_cast<std::size_t>(std::min(y, level.height - 1));
    return level
        .texels[row * static_cast<std::size_t>(level.width) + static_cast<std::size_t>(std::min(x, level.width - 1))];
  };
  std::size_t to = 0;
  for (std::int32_t y = 0; y < half.height; ++y) {
    for (std::int32_t x = 0; x < half.width; ++x, ++to) {
      for (std::size_t c = 0; c < 4; ++c) {
        const int sum =
            at(2 * x, 2 * y)[c] + at(2 * x + 1, 2 * y)[c] + at(2 * x, 2 * y + 1)[c] + at(2 * x + 1, 2 * y + 1)[c];
        half.texels[to][c] = static_cast<std::uint8_t>((sum + 2) / 4);
      }
    }
  }
  return half;
}

/// What mipped_image_of() keeps; none: it can not be decoded.
struct KeptImage {
  static constexpr std::string_view name = MippedImage::name;
  std::shared_ptr<const MippedImage> image;
  std::size_t bytes() const { return image ? image->bytes() : 0; }
};

/// The texel that stands at a whole place, most of which are in the image.
std::size_t inside(float place, std::int32_t count, Wrap wrap) {
  if (place >= 0 && place < static_cast<float>(count)) return static_cast<std::size_t>(place);
  return wrapped(static_cast<std::int64_t>(place), static_cast<std::uint32_t>(count), wrap);
}

glm::vec4 colour_of(const Texel& texel) { return glm::vec4(texel[0], texel[1], texel[2], texel[3]) / 255.0f; }

}  // namespace

std::size_t MippedImage::bytes() const {
  std::size_t sum = 0;
  for (const MipLevel& level : levels) sum += level.texels.size() * sizeof(Texel);
  return sum;
}

MippedImage mipped_image(const Texels& texels) {
  MippedImage image;
  MippedImage::MipLevel finest{
      static_cast<std::int32_t>(texels.facts.width), static_cast<std::int32_t>(texels.facts.height), {}};
  finest.texels = texels.facts.bits == 8    ? texels_of<std::uint8_t>(texels)
                  : texels.facts.bits == 16 ? texels_of<std::uint16_t>(texels)
                                            : texels_of<float>(texels);
  image.levels.push_back(std::move(finest));
  while (image.levels.back().width > 1 || image.levels.back().height > 1) {
    image.levels.push_back(half_of(image.levels.back()));
  }
  return image;
}

std::shared_ptr<const MippedImage> mipped_image_of(Analyses& analyses, const Image& image) {
  const Stamp parts[] = {image.bytes.stamp(), content_hash(std::span<const char>(image.uri))};
  return analyses
      .get<KeptImage>(combine(parts),
                      [&]() -> KeptImage {
                        const auto decoded = analyses.decode(image);
                        const Texels* texels = std::get_if<Texels>(&decoded);
                        if (texels == nullptr || texels->facts.width == 0 || texels->facts.height == 0) return {};
                        return {std::make_shared<const MippedImage>(mipped_image(*texels))};
                      })
      ->image;
}

glm::vec4 sampled(const MippedImage& image, const Sampling& sampling, std::size_t level, const glm::vec2& uv) {
  constexpr float far_off = 1 << 20;  // nothing is to be told there
  const MippedImage::MipLevel& mip = image.levels[std::min(level, image.levels.size() - 1)];
  const bool is_near = std::abs(uv.x) < far_off && std::abs(uv.y) < far_off;
  const float back = sampling.is_nearest ? 0 : 0.5f;
  const float x = (is_near ? uv.x * static_cast<float>(mip.width) : 0) - back;
  const float y = (is_near ? uv.y * static_cast<float>(mip.height) : 0) - back;
  const float left = std::floor(x), top = std::floor(y);
  const std::array columns = {inside(left, mip.width, sampling.wrap[0]), inside(left + 1, mip.width, sampling.wrap[0])};
  const std::array rows = {inside(top, mip.height, sampling.wrap[1]), inside(top + 1, mip.height, sampling.wrap[1])};
  const auto at = [&](std::size_t column, std::size_t row) {
    return colour_of(mip.texels[rows[row] * static_cast<std::size_t>(mip.width) + columns[column]]);
  };
  if (sampling.is_nearest) return at(0, 0);
  const float right = x - left, down = y - top;
  const glm::vec4 upper = at(0, 0) * (1 - right) + at(1, 0) * right;
  const glm::vec4 lower = at(0, 1) * (1 - right) + at(1, 1) * right;
  return upper * (1 - down) + lower * down;
}

}  // namespace foredraw
