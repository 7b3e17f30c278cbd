// All sprites in one picture.
#include <foredraw/io/image/picture.h>
#include <foredraw/io/image/private/encode.h>
#include <foredraw/io/sprite/private/svg.h>

#include <fmt/format.h>
#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace foredraw::sprites {

namespace {

using images::Colour;
using images::Picture;
using images::Rgba;

constexpr Colour background = {22, 24, 29};
constexpr Colour card = {30, 33, 39};
constexpr Colour light = {50, 54, 62};
constexpr Colour dark = {40, 43, 50};
constexpr Colour ink = {231, 232, 234};
constexpr Colour faint = {154, 160, 171};
constexpr Colour amber = {242, 184, 75};
constexpr Colour green = {47, 214, 181};
constexpr Colour white = {233, 255, 250};

constexpr int margin = 20;
constexpr int gap = 12;
constexpr int inset = 12;    ///< between a card's edge and what it shows
constexpr int caption = 58;  ///< below it
constexpr int heading = 64;
constexpr std::size_t most_shown = 1024;

/// The edge of a sprite's picture, so that a sheet of many is no larger than what programs open.
int edge_for(std::size_t count) { return count <= 64 ? 256 : count <= 256 ? 176 : 144; }

struct Shown {
  const DrawnSprite* sprite;
  const Rgba* image;
};

glm::ivec2 texel_at(const DrawnSprite& sprite, const glm::dvec2& point) {
  const FrameEntry& frame = sprite.frame;
  const glm::dvec2 upright = point - glm::dvec2(frame.offset);
  const glm::dvec2 in_place = frame.is_turned ? glm::dvec2(frame.place.width - upright.y, upright.x) : upright;
  return glm::ivec2(glm::floor(in_place + glm::dvec2(frame.place.x, frame.place.y)));
}

/// The mean of what a pixel covers, or the nearest texel where it covers less than one.
void put_pixel(Picture& picture, int x, int y, const Shown& shown, const glm::dvec2& from, double step) {
  const int samples = std::clamp(static_cast<int>(std::ceil(step)), 1, 8);
  float sum[4] = {};
  for (int j = 0; j < samples; ++j) {
    for (int i = 0; i < samples; ++i) {
      const glm::dvec2 within((i + 0.5) / samples, (j + 0.5) / samples);
      const glm::ivec2 texel = texel_at(*shown.sprite, from + within * step);
      if (texel.x < 0 || texel.y < 0 || texel.x >= shown.image->width || texel.y >= shown.image->height) continue;
      const std::uint8_t* value =
          &shown.image->values[4 * (static_cast<std::size_t>(texel.y) * static_cast<std::size_t>(shown.image->width) +
                                    static_cast<std::size_t>(texel.x))];
      const float alpha = value[3];
      for (int c = 0; c < 3; ++c) sum[c] += alpha * static_cast<float>(value[c]);
      sum[3] += alpha;
    }
  }
  if (sum[3] <= 0) return;
  const auto channel = [&](int c) { return static_cast<std::uint8_t>(sum[c] / sum[3] + 0.5f); };
  picture.blend(x, y, {channel(0), channel(1), channel(2)}, sum[3] / (255.0f * static_cast<float>(samples * samples)));
}

/// The text, or as much of its beginning as there is room for.
std::string fitted(std::string text, int width, int scale) {
  if (Picture::width_of(text, scale) <= width) return text;
  while (!text.empty() && Picture::width_of(text + "...", scale) > width) text.pop_back();
  return text + "...";
}

class SheetDrawing {
 public:
  SheetDrawing(Picture& picture, int edge) : picture_(picture), edge_(edge) {}

  void card_at(int x, int y, const Shown& shown) {
    picture_.fill(x, y, edge_ + 2 * inset, edge_ + 2 * inset + caption, card);
    const int left = x + inset, top = y + inset;
    constexpr int square = 8;
    for (int row = 0; row < edge_; row += square) {
      for (int column = 0; column < edge_; column += square) {
        const bool is_light = (row + column) / square % 2 == 0;
        picture_.fill(left + column, top + row, std::min(square, edge_ - column), std::min(square, edge_ - row),
                      is_light ? light : dark);
      }
    }
    put_sprite(left, top, shown);
    put_caption(left, top + edge_ + 12, *shown.sprite);
  }

 private:
  void put_sprite(int left, int top, const Shown& shown) {
    const DrawnSprite& sprite = *shown.sprite;
    const Box box = bounds_of(sprite);
    const glm::dvec2 size = box.most - box.least;
    const int room = edge_ - 16;
    const double zoom = room / std::max(size.x, size.y);
    const glm::dvec2 corner = glm::dvec2(left, top) + (glm::dvec2(edge_) - size * zoom) / 2.0;
    const auto place = [&](const glm::dvec2& point) { return glm::vec2(corner + (point - box.least) * zoom); };
    const glm::ivec2 first = glm::max(glm::ivec2(corner), glm::ivec2(left, top));
    const glm::ivec2 end = glm::min(glm::ivec2(corner + size * zoom) + 1, glm::ivec2(left, top) + edge_);
    for (int y = first.y; y < end.y; ++y) {
      for (int x = first.x; x < end.x; ++x) {
        put_pixel(picture_, x, y, shown, box.least + (glm::dvec2(x, y) - corner) / zoom, 1 / zoom);
      }
    }
    const glm::dvec2 least = sprite.frame.offset, most = least + glm::dvec2(sprite.frame.size());
    const glm::vec2 frame[] = {place(least), place({most.x, least.y}), place(most), place({least.x, most.y})};
    for (int i = 0; i < 4; ++i) dashes(frame[i], frame[(i + 1) % 4]);
    for (std::size_t i = 0; sprite.outlines.empty() && i + 2 < sprite.triangles.size(); i += 3) {
      lines(sprite, std::span(sprite.triangles).subspan(i, 3), place);
    }
    for (const auto& outline : sprite.outlines) lines(sprite, outline, place);
    for (const glm::dvec2& point : sprite.points) {
      picture_.line(place(point), place(point), 7, background);
      picture_.line(place(point), place(point), 5, white);
    }
  }

  template <class Place>
  void lines(const DrawnSprite& sprite, std::span<const std::uint32_t> corners, const Place& place) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const glm::vec2 from = place(sprite.points[corners[i]]);
      const glm::vec2 to = place(sprite.points[corners[(i + 1) % corners.size()]]);
      picture_.line(from, to, 3.5f, background, 0.6f);
      picture_.line(from, to, 1.8f, green);
    }
  }

  void dashes(const glm::vec2& from, const glm::vec2& to) {
    const glm::vec2 along = to - from;
    const float length = std::sqrt(along.x * along.x + along.y * along.y);
    for (float at = 0; at < length; at += 8) {
      picture_.line(from + along * (at / length), from + along * (std::min(at + 3.5f, length) / length), 1.2f, amber);
    }
  }

  void put_caption(int x, int y, const DrawnSprite& sprite) {
    picture_.write(x, y, fitted(sprite.frame.name, edge_, 2), ink, 2);
    const std::string area = fmt::format("{:.1f} %", 100 * sprite.area_part());
    const int scale = edge_ >= 176 ? 2 : 1;
    picture_.write(x, y + 24, area, green, scale);
    const std::string vertices = fmt::format("{} vertices", sprite.points.size());
    picture_.write(x + edge_ - Picture::width_of(vertices, scale), y + 24, vertices, faint, scale);
  }

  Picture& picture_;
  int edge_;
};

}  // namespace

std::optional<std::vector<std::byte>> contact_sheet(std::span<const Sheet> sheets, const std::filesystem::path& target,
                                                    Diagnostics& diagnostics) {
  std::map<std::pair<const Scene*, ImageId>, Rgba> decoded;
  std::vector<Shown> all;
  std::size_t left_out = 0;
  for (const Sheet& sheet : sheets) {
    for (const DrawnSprite& sprite : sheet.sprites) {
      if (all.size() == most_shown) {
        ++left_out;
        continue;
      }
      const auto [at, is_new] = decoded.try_emplace({sheet.scene, sprite.image});
      if (is_new) {
        auto image = images::rgba_of(sheet.scene->images[sprite.image]);
        if (const std::string* why = std::get_if<std::string>(&image)) {
          diagnostics.error({.file = sheet.scene->name}, "image-data",
                            fmt::format("the image '{}' {}", sheet.scene->images[sprite.image].name, *why));
          return std::nullopt;
        }
        at->second = std::move(std::get<Rgba>(image));
      }
      all.push_back({&sprite, &at->second});
    }
  }
  if (left_out > 0) {
    diagnostics.warning({.file = target.string()}, "sprites-left-out",
                        fmt::format("a picture shows at most {} sprites; {} are left out", most_shown, left_out),
                        "write a page (.html), which shows all");
  }
  const int edge = edge_for(all.size()), cell_width = edge + 2 * inset, cell_height = edge + 2 * inset + caption;
  const int count = static_cast<int>(all.size());
  const int columns = std::min(count, std::max(2, static_cast<int>(std::ceil(std::sqrt(1.4 * count)))));
  const int rows = (count + columns - 1) / columns;
  const std::string title = target.stem().string(), totals = totals_text(sheets);
  const int least_width = std::max(Picture::width_of(title, 3), Picture::width_of(totals, 2));
  const int width = std::max(columns * (cell_width + gap) - gap, least_width) + 2 * margin;
  Picture picture(width, heading + rows * (cell_height + gap) - gap + 2 * margin, background);
  picture.write(margin, margin, fitted(title, width - 2 * margin, 3), ink, 3);
  picture.write(margin, margin + 36, totals, faint, 2);
  SheetDrawing drawing(picture, edge);
  for (int i = 0; i < count; ++i) {
    drawing.card_at(margin + i % columns * (cell_width + gap), margin + heading + i / columns * (cell_height + gap),
                    all[static_cast<std::size_t>(i)]);
  }
  return picture.as_png();
}

}  // namespace foredraw::sprites
