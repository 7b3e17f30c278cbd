// Sprites as C99 arrays, which C++ takes too.
#include <foredraw/io/sprite/private/write.h>

#include <foredraw/base/c_literal.h>
#include <foredraw/io/text/private/free_names.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace foredraw::sprites {

namespace {

constexpr std::string_view head =
    R"(/* {stem}: {count} sprites and the polygons that they are drawn as. Made by foredraw.
 *
 * uv          two floats a vertex: where it lies in the image; (0, 0) is the upper left corner, (1, 1) the lower right
 * positions   two floats a vertex: texels of the whole sprite, from its upper left corner, x right, y down
 * indices     three vertices a triangle, {winding} as the picture is seen
 *
 * The first vertices are the outline's, in the same direction. A vertex may lie outside of its frame, where nothing shows.
 * A frame that is turned lies in the image clockwise by a quarter; its x, y, width and height are those in the image.
 */
#ifndef {guard}
#define {guard}

#include <stddef.h>
#include <stdint.h>

typedef struct {type} {{
  const char *name;
  const char *image;
  uint32_t x, y, width, height;                 /* in texels of the image */
  uint32_t turned;                              /* 1: clockwise by a quarter */
  int32_t offset_x, offset_y;                   /* of the upright frame in the whole sprite */
  uint32_t whole_width, whole_height;
  uint32_t vertex_count, index_count;
  const float *uv;
  const float *positions;
  const uint16_t *indices;
}} {type};

)";

constexpr std::size_t most_vertices = 65536;

void put_array(std::string& text, const std::string& type, const std::string& name,
               const std::vector<std::string>& values, std::size_t in_a_line) {
  text += fmt::format("static const {} {}[{}] = {{", type, name, values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += (i % in_a_line == 0 ? "\n  " : " ") + values[i] + ',';
  }
  text += "\n};\n";
}

void put_arrays(std::string& text, const std::string& name, const DrawnSprite& sprite) {
  std::vector<std::string> uv, positions, indices;
  for (std::size_t v = 0; v < sprite.points.size(); ++v) {
    for (int i = 0; i < 2; ++i) {
      uv.push_back(c_float(shortest(sprite.texcoords[v][i])));
      positions.push_back(c_float(shortest(sprite.points[v][i])));
    }
  }
  for (const std::uint32_t index : sprite.triangles) indices.push_back(std::to_string(index));
  put_array(text, "float", name + "_uv", uv, 8);
  put_array(text, "float", name + "_positions", positions, 8);
  put_array(text, "uint16_t", name + "_indices", indices, 12);
  text += '\n';
}

std::string row(const std::string& name, const std::string& image, const DrawnSprite& sprite) {
  const FrameEntry& frame = sprite.frame;
  const std::string arrays =
      sprite.triangles.empty() ? "NULL, NULL, NULL" : fmt::format("{0}_uv, {0}_positions, {0}_indices", name);
  return fmt::format("  {{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}},\n", c_string(frame.name),
                     c_string(image), frame.place.x, frame.place.y, frame.place.width, frame.place.height,
                     frame.is_turned ? 1 : 0, frame.offset.x, frame.offset.y, frame.whole.x, frame.whole.y,
                     sprite.triangles.empty() ? 0 : sprite.points.size(), sprite.triangles.size(), arrays);
}

std::string in_capitals(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

/// A name as C takes it: letters, digits and single underscores, a letter first.
std::string identifier(const std::string& name) {
  std::string result;
  for (const char c : name) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const bool is_digit = c >= '0' && c <= '9';
    if (is_digit && result.empty()) result = "s";
    const bool would_double = result.empty() || result.back() == '_';  // C++ keeps these names to itself
    if (is_letter || is_digit) {
      result += c;
    } else if (!would_double) {
      result += '_';
    }
  }
  while (!result.empty() && result.back() == '_') result.pop_back();
  if (result.empty()) result = "sprite";
  return result;
}

}  // namespace

std::optional<std::string> header_text(std::span<const Sheet> sheets, const std::filesystem::path& target,
                                       Diagnostics& diagnostics) {
  FreeNames names("_");
  const std::string stem = identifier(target.stem().string());
  std::string arrays, rows;
  std::size_t count = 0;
  for (const Sheet& sheet : sheets) {
    for (const DrawnSprite& sprite : sheet.sprites) {
      if (sprite.points.size() > most_vertices) {
        diagnostics.error({.file = target.string(), .inside = sprite.frame.name}, "cannot-express",
                          fmt::format("has {} vertices, more than 16-bit indices can address", sprite.points.size()),
                          "write it as .json or .glb");
        return std::nullopt;
      }
      const std::string name = stem + '_' + names.take(identifier(sprite.frame.name));
      if (!sprite.triangles.empty()) put_arrays(arrays, name, sprite);
      rows += row(name, image_beside(sheet, sprite.image, target), sprite);
      ++count;
    }
  }
  std::string text = fmt::format(
      fmt::runtime(head), fmt::arg("stem", stem), fmt::arg("count", count), fmt::arg("winding", winding_of(sheets)),
      fmt::arg("guard", "FOREDRAW_SPRITES_" + in_capitals(stem) + "_H"), fmt::arg("type", stem + "_frame"));
  text += arrays;
  text += fmt::format("#define {}_FRAME_COUNT {}\n\n", in_capitals(stem), count);
  text += "#if defined(__GNUC__)\n__attribute__((unused))\n#endif\n";
  text += fmt::format("static const {0}_frame {0}_frames[{1}] = {{\n{2}}};\n\n#endif\n", stem, count, rows);
  return text;
}

}  // namespace foredraw::sprites
