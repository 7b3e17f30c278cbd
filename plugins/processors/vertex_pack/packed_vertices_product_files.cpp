// The layouts beside the scene: as C, and as functions of shaders.
#include "packed_shader.h"
#include "packed_vertices_product.h"

#include <foredraw/base/c_literal.h>
#include <foredraw/base/c_names.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

std::string float_text(float value) { return c_float(fmt::format("{}", value)); }

std::string layout_text(const PackedLayout& layout) {
  std::string fields;
  for (const foredraw_packed_field& field : layout.field) {
    fields += fmt::format("{}{{{}, {}, {}}}", fields.empty() ? "" : ", ", field.word, field.shift, field.bits);
  }
  return fmt::format("  {{{{{}}},\n   {{{}, {}, {}}}, {}, {{{}, {}}}, {{{}, {}}}, {}}},\n", fields, layout.origin[0],
                     layout.origin[1], layout.origin[2], float_text(layout.step), layout.uv_origin[0],
                     layout.uv_origin[1], float_text(layout.uv_step[0]), float_text(layout.uv_step[1]),
                     layout.is_spherical);
}

std::size_t number_of(const std::vector<PackedLayout>& layouts, const PackedLayout& layout) {
  return static_cast<std::size_t>(std::ranges::find(layouts, layout) - layouts.begin());
}

constexpr std::string_view head =
    R"(/* How vertices of {scene} are packed into 128 bits. Made by foredraw.
 * How to use it: foredraw/runtime/packed_vertex.h. */
#ifndef FOREDRAW_PACKED_{capitals}_H
#define FOREDRAW_PACKED_{capitals}_H

#include <foredraw/runtime/packed_vertex.h>

#if defined(__GNUC__)
#define FOREDRAW_PACKED_{capitals}_DATA __attribute__((unused)) static const
#else
#define FOREDRAW_PACKED_{capitals}_DATA static const
#endif
#define {capitals}_PACKED_DRAW_COUNT {count}

/* fields x, y, z, two of the normal, tangent, sign, u, v, each by word, shift and bits; origin, step, those of u and v */
FOREDRAW_PACKED_{capitals}_DATA foredraw_packed_layout {stem}_packed_layouts[{layout_count}] = {{
{layouts}}};

/* name, layout as stored, layout as posed */
FOREDRAW_PACKED_{capitals}_DATA foredraw_packed_draw {stem}_packed_draws[{count}] = {{
{draws}}};

#endif
)";

}  // namespace

std::string packed_vertices_header(const PackedVertices& all, const Scene& scene, const std::string& stem) {
  const std::string name = c_identifier(stem);
  const std::vector<PackedLayout> distinct = processors::vertex_pack::distinct_layouts(all);
  const auto pointer = [&](const PackedLayout& layout) {
    return fmt::format("{}_packed_layouts + {}", name, number_of(distinct, layout));
  };
  std::string layouts, draws;
  for (const PackedLayout& layout : distinct) layouts += layout_text(layout);
  for (const PackedVertices::OfDraw& draw : all.draws) {
    draws += fmt::format("  {{{}, {}, {}}},\n", c_string(scene.draws[draw.draw].name), pointer(draw.layout),
                         draw.posed ? pointer(*draw.posed) : "0");
  }
  return fmt::format(fmt::runtime(head), fmt::arg("scene", in_comment(scene.name)),
                     fmt::arg("capitals", in_capitals(name)), fmt::arg("stem", name),
                     fmt::arg("count", all.draws.size()), fmt::arg("layout_count", distinct.size()),
                     fmt::arg("layouts", layouts), fmt::arg("draws", draws));
}

std::string packed_vertices_shader(const PackedVertices& all, const Scene& scene, std::string_view extension) {
  const auto language = extension == ".glsl" ? ShaderLanguage::glsl : ShaderLanguage::hlsl;
  const std::vector<PackedLayout> distinct = processors::vertex_pack::distinct_layouts(all);
  std::string text =
      "// Made by Foredraw: vertices of 128 bits. Define before including:\n"
      "//   PACKED_LAYOUT  number of the layout; 0 by default. Of the draws, as stored and as posed:\n";
  for (const PackedVertices::OfDraw& draw : all.draws) {
    text += fmt::format("//     {}: {}{}\n", in_comment(scene.draws[draw.draw].name), number_of(distinct, draw.layout),
                        draw.posed ? fmt::format(", {}", number_of(distinct, *draw.posed)) : "");
  }
  text += "#ifndef PACKED_LAYOUT\n#define PACKED_LAYOUT 0\n#endif\n\n" +
          processors::vertex_pack::packed_shader_head(language);
  for (std::size_t i = 0; i < distinct.size(); ++i) {
    text += fmt::format("\n#if PACKED_LAYOUT == {}\n{}\n#endif  // PACKED_LAYOUT == {}\n", i,
                        processors::vertex_pack::packed_shader_text(distinct[i], language), i);
  }
  return text;
}

}  // namespace foredraw
