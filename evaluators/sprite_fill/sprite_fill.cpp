#include "sprite_fill.h"

#include "pixel_rows.h"

#include <foredraw/base/random.h>
#include <foredraw/scene/turn.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <map>
#include <sstream>
#include <stdexcept>

namespace foredraw {

namespace {

constexpr double most_pixels = 1 << 30;
constexpr double furthest = 1 << 20;  // pixels, or sides of the image
constexpr double most_alpha = 65535.0 * 65536;

std::vector<double> scales_of(const std::string& list) {
  std::vector<double> scales;
  std::istringstream words(list);
  words.imbue(std::locale::classic());
  for (std::string word; words >> word;) {
    std::istringstream number(word);
    number.imbue(std::locale::classic());
    double scale = 0;
    if (!(number >> scale) || !number.eof() || !(scale > 0) || scale > 16) {
      throw std::invalid_argument("'" + word + "' is not a scale; scales are numbers above 0 and at most 16, such as " +
                                  "\"1 0.5 0.25\"");
    }
    scales.push_back(scale);
  }
  if (scales.empty()) throw std::invalid_argument("scales is empty; give one or more numbers, such as \"1 0.5 0.25\"");
  return scales;
}

/// The largest whole number not above it.
std::int64_t rounded_down(double value) {
  const auto whole = static_cast<std::int64_t>(value);
  return static_cast<double>(whole) > value ? whole - 1 : whole;
}

/// Two neighbouring levels, and the part of the second in 1/256.
struct Blend {
  const AlphaImage* fine = nullptr;
  const AlphaImage* coarse = nullptr;
  std::int64_t part = 0;
};

/// The binary logarithm of a number above 1/2 and up to 1, by its series, because what a library says may depend on the
/// processor in the last bit.
double log2_of(double number) {
  const double z = (number - 1) / (number + 1);  // no further from 0 than 1/3
  double sum = 0;
  double power = z;
  for (int n = 1; n < 50; n += 2) {
    sum += power / n;
    power *= z * z;
  }
  return 2 * sum / 0.6931471805599453;
}

Blend levels_at(const AlphaLevels& levels, double scale, bool mipmaps) {
  if (!mipmaps || scale >= 1) return {levels[0].get(), levels[0].get(), 0};
  std::size_t level = 0;
  for (; scale <= 0.5; scale *= 2) ++level;
  std::int64_t part = rounded_down(-log2_of(scale) * 256 + 0.5);
  if (part == 256) {
    ++level;
    part = 0;
  }
  const std::size_t last = levels.size() - 1;
  if (level >= last) return {levels[last].get(), levels[last].get(), 0};
  return {levels[level].get(), levels[level + 1].get(), part};
}

/// alpha_at() in whole numbers, 65535 * 65536 being 1, and quick inside the image.
std::int64_t sampled(const AlphaImage& image, const Sampling& sampling, double u, double v) {
  constexpr std::int64_t steps = steps_per_texel;
  const auto texel = [&](std::int64_t x, std::int64_t y) {
    return std::int64_t{
        image.at(wrapped(x, image.width, sampling.wrap[0]), wrapped(y, image.height, sampling.wrap[1]))};
  };
  std::int64_t x = rounded_down(u * image.width * static_cast<double>(steps) + 0.5);
  std::int64_t y = rounded_down(v * image.height * static_cast<double>(steps) + 0.5);
  if (sampling.is_nearest) return texel(x >> 8, y >> 8) * steps * steps;
  x -= steps / 2;
  y -= steps / 2;
  const std::int64_t right = x & (steps - 1), down = y & (steps - 1);
  x >>= 8;
  y >>= 8;
  std::int64_t a, b, c, d;
  if (x >= 0 && y >= 0 && x + 1 < image.width && y + 1 < image.height) {
    const std::uint16_t* at = &image.alpha[static_cast<std::size_t>(y) * image.width + static_cast<std::size_t>(x)];
    a = at[0], b = at[1], c = at[image.width], d = at[image.width + 1];
  } else {
    a = texel(x, y), b = texel(x + 1, y), c = texel(x, y + 1), d = texel(x + 1, y + 1);
  }
  return (a * (steps - right) + b * right) * (steps - down) + (c * (steps - right) + d * right) * down;
}

/// From the image to the pixels and back.
struct Laid {
  double width, height;  // of the image, texels
  SpriteLook look;
  Turn turn;

  glm::dvec2 pixel(const glm::dvec2& place) const {
    const double x = place.x * width * look.scale, y = place.y * height * look.scale;
    return {turn.cosine * x - turn.sine * y + look.offset.x, turn.sine * x + turn.cosine * y + look.offset.y};
  }
};

/// Throws where there is too much to draw.
void require_drawable(std::span<const PlacedTriangle> triangles, const Laid& laid) {
  double pixels = 0;
  for (const PlacedTriangle& triangle : triangles) {
    std::array<glm::dvec2, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = laid.pixel(triangle.corners[i]);
      const glm::dvec2& place = triangle.corners[i];
      const double most = std::max({std::abs(p[i].x), std::abs(p[i].y), std::abs(place.x), std::abs(place.y)});
      if (!(most < furthest)) {
        throw std::runtime_error("its texture coordinates are too large to be drawn: they reach more than " +
                                 std::to_string(1 << 20) + " pixels, or widths of the image, away");
      }
    }
    pixels += std::abs((p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y)) / 2;
  }
  if (pixels > most_pixels) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << "at scale " << laid.look.scale << " it covers more than " << (1 << 30) << " pixels; set smaller scales";
    throw std::runtime_error(text.str());
  }
}

}  // namespace

std::vector<SpriteLook> sprite_looks(const SpriteFillOptions& options) {
  constexpr double golden_angle = 2.399963229728653;
  std::vector<SpriteLook> looks;
  const std::vector<double> scales = scales_of(options.scales);
  for (std::size_t i = 0; i < scales.size(); ++i) {
    for (int turn = 0; turn < options.turns; ++turn) {
      Random random(derive_seed(static_cast<std::uint64_t>(options.seed), i, static_cast<std::uint64_t>(turn)));
      const double x = random.unit(), y = random.unit();
      looks.push_back({scales[i], turn * golden_angle, {x, y}});
    }
  }
  return looks;
}

std::vector<PlacedTriangle> placed_triangles(std::span<const glm::dvec2> places,
                                             std::span<const std::uint32_t> indices) {
  std::map<std::array<double, 6>, std::uint64_t> times;
  for (std::size_t t = 0; t + 2 < indices.size(); t += 3) {
    std::array<double, 6> numbers{};
    for (std::size_t i = 0; i < 3; ++i) {
      numbers[2 * i] = places[indices[t + i]].x;
      numbers[2 * i + 1] = places[indices[t + i]].y;
    }
    if (std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); })) ++times[numbers];
  }
  std::vector<PlacedTriangle> triangles;
  for (const auto& [n, count] : times) triangles.push_back({{{{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}}}, count});
  return triangles;
}

AlphaLevels alpha_levels(std::shared_ptr<const AlphaImage> image) {
  AlphaLevels levels{std::move(image)};
  while (levels.back()->width > 1 || levels.back()->height > 1) {
    levels.push_back(std::make_shared<const AlphaImage>(next_level(*levels.back())));
  }
  return levels;
}

SpriteFill sprite_fill(std::span<const PlacedTriangle> triangles, const AlphaLevels& levels, const Sampling& sampling,
                       const SpriteLook& look, const SpriteFillOptions& options) {
  const Laid laid{static_cast<double>(levels[0]->width), static_cast<double>(levels[0]->height), look,
                  turn_by(look.angle)};
  require_drawable(triangles, laid);
  const Blend blend = levels_at(levels, look.scale, options.mipmaps);
  const std::int64_t limit = rounded_down(options.threshold * most_alpha * 256);
  const Turn& turn = laid.turn;

  SpriteFill sum;
  for (const PlacedTriangle& triangle : triangles) {
    std::array<PixelPlace, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec2 pixel = laid.pixel(triangle.corners[i]);
      corners[i] = {rounded_down(pixel.x * 256 + 0.5), rounded_down(pixel.y * 256 + 0.5)};
    }
    std::uint64_t filled = 0, needed = 0;
    for_each_row(corners, [&](std::int64_t y, std::int64_t first, std::int64_t last) {
      filled += static_cast<std::uint64_t>(last - first + 1);
      const double down = static_cast<double>(y) + 0.5 - look.offset.y;
      const double from_x = turn.sine * down, from_y = turn.cosine * down;
      for (std::int64_t x = first; x <= last; ++x) {
        const double right = static_cast<double>(x) + 0.5 - look.offset.x;
        const double u = (turn.cosine * right + from_x) / look.scale / laid.width;
        const double v = (from_y - turn.sine * right) / look.scale / laid.height;
        std::int64_t alpha = sampled(*blend.fine, sampling, u, v) * (256 - blend.part);
        if (blend.part > 0) alpha += sampled(*blend.coarse, sampling, u, v) * blend.part;
        needed += alpha > limit ? 1 : 0;
      }
    });
    sum.filled += triangle.times * filled;
    sum.needed += triangle.times * needed;
  }
  return sum;
}

}  // namespace foredraw
