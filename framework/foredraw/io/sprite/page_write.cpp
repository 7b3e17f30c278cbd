// All sprites on one page for any browser, without a script: each image is in it once.
#include <foredraw/io/sprite/private/write.h>

#include <foredraw/base/counted.h>
#include <foredraw/base/printable.h>
#include <foredraw/geometry/box.h>
#include <foredraw/io/image/private/encode.h>

#include <fmt/format.h>
#include <glm/common.hpp>

#include <algorithm>
#include <variant>

namespace foredraw::sprites {

namespace {

constexpr std::string_view page_style = R"svg(<style>
:root{color-scheme:light dark;--page:#f6f6f4;--card:#fff;--ink:#1d2026;--faint:#667;--rim:#dcdcd8;--light:#fff;--dark:#ececea;
--frame:#b06a00;--polygon:#00806b;--corner:#00443a}
@media(prefers-color-scheme:dark){:root{--page:#16181d;--card:#1e2127;--ink:#e7e8ea;--faint:#9aa0ab;--rim:#2f333b;
--light:#2d3139;--dark:#24272e;--frame:#f2b84b;--polygon:#2fd6b5;--corner:#e9fffa}}
body{margin:0;padding:2rem clamp(1rem,4vw,3rem);background:var(--page);color:var(--ink);font:15px/1.5 system-ui,sans-serif}
h1{margin:0;font-size:1.5rem;overflow-wrap:anywhere}
p{margin:.25rem 0 1.5rem;color:var(--faint)}
main{display:grid;grid-template-columns:repeat(auto-fill,minmax(220px,1fr));gap:1rem}
figure{margin:0;background:var(--card);border:1px solid var(--rim);border-radius:10px;overflow:hidden}
figure svg{display:block;width:100%;aspect-ratio:1;
background:conic-gradient(var(--light) 25%,var(--dark) 0 50%,var(--light) 0 75%,var(--dark) 0) 0 0/20px 20px}
figcaption{padding:.6rem .8rem;border-top:1px solid var(--rim)}
figcaption b{display:block;overflow-wrap:anywhere}
figcaption span{color:var(--faint);font-variant-numeric:tabular-nums}
.frame,.polygon,.corners{fill:none;vector-effect:non-scaling-stroke;stroke-linejoin:round}
.frame{stroke:var(--frame);stroke-dasharray:4 3}
.polygon{stroke:var(--polygon);stroke-width:1.5;fill:var(--polygon);fill-opacity:.1}
.corners{stroke:var(--corner);stroke-width:5;stroke-linecap:round}
.key i{display:inline-block;width:1.6em;margin:0 .3em 0 1em;vertical-align:middle;border-top:2px solid var(--polygon)}
.key i.f{border-top:2px dashed var(--frame)}
.images{position:absolute;width:0;height:0}
</style>
)svg";

/// Text as SVG and HTML show it: whatever a file calls its things, it is no markup.
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

/// "M0 0L1 0L1 1Z" for each outline, or for each triangle of a sprite that has not one.
std::string polygon_path(const DrawnSprite& sprite) {
  std::string path;
  const auto add = [&](std::span<const std::uint32_t> corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const glm::dvec2 point = sprite.points[corners[i]];
      path += fmt::format("{}{} {}", i == 0 ? 'M' : 'L', shortest(point.x), shortest(point.y));
    }
    path += 'Z';
  };
  for (const auto& outline : sprite.outlines) add(outline);
  if (!sprite.outlines.empty()) return path;
  for (std::size_t i = 0; i + 2 < sprite.triangles.size(); i += 3) add(std::span(sprite.triangles).subspan(i, 3));
  return path;
}

/// A dot at each corner, as a path whose stroke has round ends.
std::string corner_path(const std::vector<glm::dvec2>& points) {
  std::string path;
  for (const glm::dvec2& point : points) path += fmt::format("M{} {}h0", shortest(point.x), shortest(point.y));
  return path;
}

/// Bounds of the frame and of its points, in texels of the whole sprite.
Box<glm::dvec2> bounds_of(const DrawnSprite& sprite) {
  Box<glm::dvec2> box{glm::dvec2(sprite.frame.offset), glm::dvec2(sprite.frame.offset + sprite.frame.size())};
  for (const glm::dvec2& point : sprite.points) box.add(point);
  return box;
}

/// "24 sprites, 148 vertices, 61.2 % of the frames' area is drawn"
std::string totals_text(std::span<const Sheet> sheets) {
  std::size_t sprites = 0, vertices = 0;
  double area = 0, frames = 0;  // texels of all polygons, and of all frames
  for (const Sheet& sheet : sheets) {
    for (const DrawnSprite& sprite : sheet.sprites) {
      const double frame = static_cast<double>(sprite.frame.place.width) * sprite.frame.place.height;
      ++sprites;
      vertices += sprite.points.size();
      area += sprite.area_part() * frame;
      frames += frame;
    }
  }
  return fmt::format("{}, {} vertices, {:.1f} % of the frames' area is drawn", counted(sprites, "sprite"), vertices,
                     100 * area / frames);
}

/// The images that sprites of a scene show, as a browser takes them; nullopt, with an error, where one can not be
/// decoded. Those that no sprite shows are empty.
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

std::string image_id(std::size_t sheet, std::size_t image) { return fmt::format("image-{}-{}", sheet, image); }

/// From texels of the image to those of the whole sprite.
std::string transform_of(const FrameEntry& frame) {
  const glm::dvec2 zero = to_sprite(frame, {0, 0});
  return frame.is_turned ? fmt::format("matrix(0 -1 1 0 {} {})", zero.x, zero.y)
                         : fmt::format("translate({} {})", zero.x, zero.y);
}

void put_figure(const DrawnSprite& sprite, const std::string& image, std::string& text) {
  const Box<glm::dvec2> box = bounds_of(sprite);
  const glm::dvec2 size = box.max - box.min;
  const double margin = 0.04 * std::max(size.x, size.y);
  const glm::dvec2 corner = sprite.frame.offset, own = sprite.frame.size();
  text += fmt::format("<figure><svg viewBox=\"{} {} {} {}\" role=\"img\" aria-label=\"{}\">",
                      shortest(box.min.x - margin), shortest(box.min.y - margin), shortest(size.x + 2 * margin),
                      shortest(size.y + 2 * margin), escaped(sprite.frame.name));
  // What of the image lies around the frame is shown only as far as it is drawn.
  text += fmt::format(
      "<svg x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\" viewBox=\"{0} {1} {2} {3}\">"
      "<use href=\"#{4}\" transform=\"{5}\"{6}/></svg>",
      shortest(box.min.x), shortest(box.min.y), shortest(size.x), shortest(size.y), image, transform_of(sprite.frame),
      std::max(own.x, own.y) <= 96 ? " style=\"image-rendering:pixelated\"" : "");
  text += fmt::format("<path class=\"frame\" d=\"M{} {}h{}v{}h-{}Z\"/>", corner.x, corner.y, own.x, own.y, own.x);
  text += fmt::format("<path class=\"polygon\" d=\"{}\"/>", polygon_path(sprite));
  text += fmt::format("<path class=\"corners\" d=\"{}\"/></svg>", corner_path(sprite.points));
  text += fmt::format("<figcaption><b>{}</b><span>{} vertices, {:.1f} % of {} x {}</span></figcaption></figure>\n",
                      escaped(sprite.frame.name), sprite.points.size(), 100 * sprite.area_part(), own.x, own.y);
}

}  // namespace

std::optional<std::string> page_text(std::span<const Sheet> sheets, const std::filesystem::path& target,
                                     Diagnostics& diagnostics) {
  std::string images, figures;
  for (std::size_t s = 0; s < sheets.size(); ++s) {
    const auto uris = data_uris(sheets[s], diagnostics);
    if (!uris) return std::nullopt;
    for (std::size_t i = 0; i < uris->size(); ++i) {
      if ((*uris)[i].empty()) continue;
      const ImageFacts& facts = *sheets[s].scene->images[i].facts;
      images += fmt::format("<image id=\"{}\" width=\"{}\" height=\"{}\" href=\"{}\"/>\n", image_id(s, i), facts.width,
                            facts.height, (*uris)[i]);
    }
    for (const DrawnSprite& sprite : sheets[s].sprites) put_figure(sprite, image_id(s, sprite.image), figures);
  }
  const std::string title = escaped(target.stem().string());
  std::string text = "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n";
  text += "<meta name=\"viewport\" content=\"width=device-width\">\n";
  text += fmt::format("<title>{}</title>\n", title);
  text += page_style;
  text += fmt::format("<h1>{}</h1>\n<p>{}<span class=\"key\"><i></i>what is drawn<i class=\"f\"></i>frame</span></p>\n",
                      title, escaped(totals_text(sheets)));
  text += "<svg class=\"images\" aria-hidden=\"true\"><defs>\n" + images + "</defs></svg>\n<main>\n" + figures;
  return text + "</main>\n</html>\n";
}

}  // namespace foredraw::sprites
