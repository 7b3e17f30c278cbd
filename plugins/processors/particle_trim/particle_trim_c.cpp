#include "particle_trim.h"

#include "footprint.h"

#include <foredraw/c/checked_input.h>

#include <algorithm>
#include <array>

using namespace foredraw;

namespace {

constexpr std::array wraps = {Wrap::repeat, Wrap::mirrored, Wrap::clamped};  // by FOREDRAW_WRAP_REPEAT and so on
constexpr std::array formats = {processors::particle_trim::UvFormat::float32,
                                processors::particle_trim::UvFormat::float16,
                                processors::particle_trim::UvFormat::unorm16};
constexpr std::size_t room = 16;  // corners of a frame

bool is_between(double number, double least, double most) { return number >= least && number <= most; }

bool is_in_range(const foredraw_trim_options& options) {
  return is_between(options.vertices, 3, room) && is_between(options.threshold, 0, 1) &&
         is_between(options.padding, 0, 64) && is_between(options.least_saving, 0, 1) && options.mip_levels <= 14 &&
         options.wrap_u < wraps.size() && options.wrap_v < wraps.size() && options.is_nearest <= 1 &&
         options.uv < formats.size();
}

/// In 1/256 texel; nothing where it is empty or does not lie in the image.
std::optional<TrimFrame> frame_in(const foredraw_rectangle& frame, const AlphaImage& image) {
  const std::uint64_t right = std::uint64_t{frame.x} + frame.width, down = std::uint64_t{frame.y} + frame.height;
  if (frame.width == 0 || frame.height == 0 || right > image.width || down > image.height) return std::nullopt;
  const auto place = [](std::uint64_t x, std::uint64_t y) -> processors::particle_trim::Point {
    return {static_cast<std::int64_t>(x) * steps_per_texel, static_cast<std::int64_t>(y) * steps_per_texel};
  };
  return TrimFrame{place(frame.x, frame.y), place(right, down)};
}

uint32_t outcome_of(TrimmedSprite::Outcome outcome) {
  switch (outcome) {
    case TrimmedSprite::Outcome::trimmed: return FOREDRAW_TRIMMED;
    case TrimmedSprite::Outcome::rectangle: return FOREDRAW_RECTANGLE;
    case TrimmedSprite::Outcome::empty: return FOREDRAW_EMPTY;
    case TrimmedSprite::Outcome::full: return FOREDRAW_FULL;
    case TrimmedSprite::Outcome::no_saving: break;
  }
  return FOREDRAW_NO_SAVING;
}

}  // namespace

int foredraw_particle_trim(foredraw_trimmed* trimmed, double* corners, const foredraw_alpha* image,
                           const foredraw_rectangle* frames, uint32_t frame_count,
                           const foredraw_trim_options* options) {
  return c::guarded([&]() -> int {
    const foredraw_trim_options defaults = FOREDRAW_TRIM_DEFAULTS;
    const foredraw_trim_options& given = options == nullptr ? defaults : *options;
    if (given.size != sizeof given || !is_in_range(given)) return FOREDRAW_OPTION_RANGE;
    if (const int status = c::alpha_status(image)) return status;
    if (frame_count == 0) return FOREDRAW_DONE;
    if (trimmed == nullptr || corners == nullptr || frames == nullptr) return FOREDRAW_NULL_POINTER;

    const AlphaImage alpha{image->width, image->height, c::numbers_of(*image)};
    std::vector<TrimFrame> places;
    for (const foredraw_rectangle& frame : std::span(frames, frame_count)) {
      const auto place = frame_in(frame, alpha);
      if (!place) return FOREDRAW_OPTION_RANGE;
      places.push_back(*place);
    }
    ParticleTrimOptions wanted;
    wanted.vertices = static_cast<int>(given.vertices);
    wanted.threshold = given.threshold;
    wanted.padding = given.padding;
    wanted.least_saving = given.least_saving;
    wanted.mip_levels = static_cast<int>(given.mip_levels);
    wanted.uv = formats[given.uv];
    wanted.winding = TrimWinding::clockwise;
    const Sampling sampling{{wraps[given.wrap_u], wraps[given.wrap_v]}, given.is_nearest == 1};
    const processors::particle_trim::ShownImage shown(alpha, sampling, processors::particle_trim::footprint_of(wanted));

    std::vector<TrimmedSprite> sprites;
    for (const TrimFrame& place : places) sprites.push_back(particle_trim(shown, {&place, 1}, wanted).front());
    for (std::size_t i = 0; i < sprites.size(); ++i) {
      const TrimmedSprite& sprite = sprites[i];
      trimmed[i] = {outcome_of(sprite.outcome), static_cast<uint32_t>(sprite.corners.size()), sprite.area,
                    sprite.frame_area, sprite.lost};
      double* corner = corners + i * 2 * room;
      for (const glm::dvec2& uv : sprite.corners) *corner++ = uv.x, *corner++ = uv.y;
    }
    return FOREDRAW_DONE;
  });
}
