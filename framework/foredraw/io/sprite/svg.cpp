#include <foredraw/io/sprite/private/svg.h>

#include <foredraw/base/printable.h>
#include <foredraw/io/image/private/encode.h>

#include <fmt/format.h>
#include <glm/common.hpp>

#include <set>
#include <variant>

namespace foredraw::sprites {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : printable(text)) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      case '\'': result += "&#39;"; break;
      default: result += c;
    }
  }
  return result;
}

std::string polygon_path(const DrawnSprite& sprite, const std::vector<glm::dvec2>& points) {
  std::string path;
  const auto add = [&](std::span<const std::uint32_t> corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const glm::dvec2 point = points[corners[i]];
      path += fmt::format("{}{} {}", i == 0 ? 'M' : 'L', shortest(point.x), shortest(point.y));
    }
    path += 'Z';
  };
  for (const auto& outline : sprite.outlines) add(outline);
  if (!sprite.outlines.empty()) return path;
  for (std::size_t i = 0; i + 2 < sprite.triangles.size(); i += 3) add(std::span(sprite.triangles).subspan(i, 3));
  return path;
}

std::string corner_path(const std::vector<glm::dvec2>& points) {
  std::string path;
  for (const glm::dvec2& point : points) path += fmt::format("M{} {}h0", shortest(point.x), shortest(point.y));
  return path;
}

Box bounds_of(const DrawnSprite& sprite) {
  Box box{glm::dvec2(sprite.frame.offset), glm::dvec2(sprite.frame.offset + sprite.frame.size())};
  for (const glm::dvec2& point : sprite.points) {
    box.least = glm::min(box.least, point);
    box.most = glm::max(box.most, point);
  }
  return box;
}

SheetTotals totals_of(std::span<const Sheet> sheets) {
  SheetTotals totals;
  for (const Sheet& sheet : sheets) {
    for (const DrawnSprite& sprite : sheet.sprites) {
      const double frame = static_cast<double>(sprite.frame.place.width) * sprite.frame.place.height;
      ++totals.sprites;
      totals.vertices += sprite.points.size();
      totals.area += sprite.area_part() * frame;
      totals.frames += frame;
    }
  }
  return totals;
}

std::string totals_text(std::span<const Sheet> sheets) {
  const SheetTotals totals = totals_of(sheets);
  return fmt::format("{} {}, {} vertices, {:.1f} % of the frames' area is drawn", totals.sprites,
                     totals.sprites == 1 ? "sprite" : "sprites", totals.vertices, 100 * totals.area / totals.frames);
}

std::optional<std::vector<std::string>> data_uris(const Sheet& sheet, Diagnostics& diagnostics) {
  std::vector<std::string> uris(sheet.scene->images.size());
  for (const DrawnSprite& sprite : sheet.sprites) {
    if (!uris[sprite.image].empty()) continue;
    const auto image = images::png_or_jpeg(sheet.scene->images[sprite.image]);
    if (const std::string* why = std::get_if<std::string>(&image)) {
      diagnostics.error({.file = sheet.scene->name}, "image-data",
                        fmt::format("the image '{}' {}", sheet.scene->images[sprite.image].name, *why));
      return std::nullopt;
    }
    uris[sprite.image] = images::data_uri(std::get<Image>(image));
  }
  return uris;
}

}  // namespace foredraw::sprites
