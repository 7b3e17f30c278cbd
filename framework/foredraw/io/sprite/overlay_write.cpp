// The images with frames, polygons and what they save drawn on top, as SVG.
#include <foredraw/io/sprite/private/svg.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace foredraw::sprites {

namespace {

constexpr std::string_view overlay_style = R"svg(<style>
text{font:600 1px system-ui,sans-serif;fill:#fff;paint-order:stroke;stroke:#16181d;stroke-width:.25px;stroke-linejoin:round}
.frame,.polygon,.corners{fill:none;vector-effect:non-scaling-stroke;stroke-linejoin:round}
.frame{stroke:#f2b84b;stroke-width:1;stroke-dasharray:4 3}
.polygon{stroke:#2fd6b5;stroke-width:1.5;fill:#2fd6b5;fill-opacity:.16}
.corners{stroke:#e9fffa;stroke-width:4;stroke-linecap:round}
</style>
<pattern id="board" width="1" height="1" patternUnits="userSpaceOnUse" patternTransform="scale({board})">
<path fill="#24272e" d="M0 0h1v1H0z"/><path fill="#2d3139" d="M0 0h.5v.5H0zM.5.5H1V1H.5z"/></pattern>
)svg";

struct Placed {
  const Sheet* sheet;
  std::size_t image;
  double left;
};

void put_sprite(const DrawnSprite& sprite, std::string& text) {
  const SpriteFrame& place = sprite.frame.place;
  const std::string saving = saving_text(sprite);
  text +=
      fmt::format("<g><title>{}: {} vertices, {}</title>", escaped(sprite.frame.name), sprite.points.size(), saving);
  text += fmt::format("<path class=\"frame\" d=\"M{} {}h{}v{}h-{}Z\"/>", place.x, place.y, place.width, place.height,
                      place.width);
  text += fmt::format("<path class=\"polygon\" d=\"{}\"/>", polygon_path(sprite, sprite.texels));
  text += fmt::format("<path class=\"corners\" d=\"{}\"/>", corner_path(sprite.texels));
  // As high as fits the frame, for letters are half as wide as they are high.
  const double letters = std::max<double>(static_cast<double>(saving.size()), 6);
  const double size =
      std::min({place.width / (0.9 * letters), place.height / 4.0, std::max(place.width, place.height) / 12.0});
  text += fmt::format("<text transform=\"translate({} {}) scale({})\">{}</text></g>\n", shortest(place.x + 0.3 * size),
                      shortest(place.y + 1.05 * size), shortest(size), saving);
}

}  // namespace

std::optional<std::string> overlay_text(std::span<const Sheet> sheets, const std::filesystem::path& target,
                                        Diagnostics& diagnostics) {
  std::string body;
  double width = 0, height = 0;
  for (const Sheet& sheet : sheets) {
    const auto uris = data_uris(sheet, diagnostics);
    if (!uris) return std::nullopt;
    for (std::size_t i = 0; i < uris->size(); ++i) {
      if ((*uris)[i].empty()) continue;
      const ImageFacts& facts = *sheet.scene->images[i].facts;
      if (width > 0) width += std::max(1.0, width / 50);
      body += fmt::format("<g transform=\"translate({})\">\n", shortest(width));
      body += fmt::format("<path fill=\"url(#board)\" d=\"M0 0h{0}v{1}H0z\"/>", facts.width, facts.height);
      const bool is_small = std::max(facts.width, facts.height) <= 256;
      body += fmt::format("<image width=\"{}\" height=\"{}\"{} href=\"{}\"/>\n", facts.width, facts.height,
                          is_small ? " style=\"image-rendering:pixelated\"" : "", (*uris)[i]);
      for (const DrawnSprite& sprite : sheet.sprites) {
        if (sprite.image == i) put_sprite(sprite, body);
      }
      body += "</g>\n";
      width += facts.width;
      height = std::max<double>(height, facts.height);
    }
  }
  const double margin = std::max(2.0, std::max(width, height) / 40);
  const double shown = std::max({width, height, 768.0}) / std::max(width, height);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{0} {0} {1} {2}\" width=\"{3:.0f}\" height=\"{4:.0f}\">\n",
      shortest(-margin), shortest(width + 2 * margin), shortest(height + 2 * margin), (width + 2 * margin) * shown,
      (height + 2 * margin) * shown);
  text += fmt::format("<title>{}: {}</title>\n", escaped(target.stem().string()), escaped(totals_text(sheets)));
  std::string look(overlay_style);
  const std::string board = shortest(std::max(2.0, std::max(width, height) / 48));
  look.replace(look.find("{board}"), 7, board);
  text += look;
  text += fmt::format("<path fill=\"#16181d\" d=\"M{0} {0}h{1}v{2}h-{1}z\"/>\n", shortest(-margin),
                      shortest(width + 2 * margin), shortest(height + 2 * margin));
  return text + body + "</svg>\n";
}

}  // namespace foredraw::sprites
