#include <foredraw/displaced/displaced_shader.h>

#include <foredraw/displaced/private/shader_functions.h>
#include <foredraw/displaced/private/shader_stages_glsl.h>
#include <foredraw/displaced/private/shader_stages_hlsl.h>
#include <foredraw/displaced/shader_words.h>

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace foredraw {

namespace {

namespace parts = displaced_shader_parts;

std::string number(std::uint32_t value) { return std::to_string(value) + 'u'; }

/// Nine digits name a float among all others.
std::string number(float value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof(digits), value).ptr;
  std::string text(digits, end);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string pair(std::uint32_t a, std::uint32_t b) { return "uvec2(" + number(a) + ", " + number(b) + ")"; }

void check(const DisplacedShader& shader, ShaderLanguage language, DisplacedStage stage) {
  const auto demand = [](bool holds, const char* what) {
    if (!holds) throw std::invalid_argument(what);
  };
  const auto is_size = [](std::uint32_t size) { return size >= 1 && size <= 65536; };
  demand(is_size(shader.map.width) && is_size(shader.map.height), "a map of heights has 1 to 65536 texels each way");
  demand(shader.bits >= 1 && shader.bits <= 16, "heights have 1 to 16 bits");
  demand(std::isfinite(shader.factor) && std::isfinite(shader.offset), "a displacement's factor and offset are finite");
  demand(std::isfinite(shader.level) && shader.level > 0, "a level is finite and above 0");
  demand(std::isfinite(shader.pixels_per_part) && shader.pixels_per_part > 0, "parts have more than 0 pixels");
  const bool captures = shader.captures || stage == DisplacedStage::cage_capture;
  demand(!captures || language == ShaderLanguage::glsl,
         "in HLSL no text says what is captured: declare the stream output where the pipeline is made");
}

/// Everything that differs from draw to draw.
std::string constants(const DisplacedShader& shader, ShaderLanguage language) {
  const std::string begin = language == ShaderLanguage::glsl ? "const " : "static const ";
  const auto line = [&](const char* type, const char* name, const std::string& value) {
    return begin + type + " displaced_" + name + " = " + value + ";\n";
  };
  return line("uvec2", "size", pair(shader.map.width, shader.map.height)) +
         line("uvec2", "wrap", pair(shader.map.wrap[0], shader.map.wrap[1])) +
         line("bool", "is_nearest", shader.map.is_nearest != 0 ? "true" : "false") +
         line("uint", "bits", number(shader.bits)) + line("float", "factor", number(shader.factor)) +
         line("float", "offset", number(shader.offset)) + line("uint", "vertices", number(shader.vertices)) +
         line("uint", "joints", number(shader.joints)) +
         (shader.levels == DisplacedShader::Levels::constant ? line("float", "level", number(shader.level))
          : shader.levels == DisplacedShader::Levels::by_pixels
              ? line("float", "pixels_per_part", number(shader.pixels_per_part))
              : "") +
         "\n";
}

std::string spacing(TessellationSpacing spacing, ShaderLanguage language) {
  const bool glsl = language == ShaderLanguage::glsl;
  switch (spacing) {
    case TessellationSpacing::fractional_odd: return glsl ? "fractional_odd_spacing" : "fractional_odd";
    case TessellationSpacing::fractional_even: return glsl ? "fractional_even_spacing" : "fractional_even";
    case TessellationSpacing::equal: break;
  }
  return glsl ? "equal_spacing" : "integer";
}

/// A stage's parts in their sequence.
std::string parts_of(const DisplacedShader& shader, ShaderLanguage language, DisplacedStage stage) {
  const bool glsl = language == ShaderLanguage::glsl;
  std::string text;
  const auto both = [&](std::string_view part) { text += glsl ? std::string(part) : in_hlsl(part); };
  const auto either = [&](std::string_view in_glsl, std::string_view in_hlsl) { text += glsl ? in_glsl : in_hlsl; };
  const auto map = [&] {
    if (shader.texels == DisplacedShader::Texels::whole) {
      either(parts::glsl::whole_map, parts::hlsl::whole_map);
    } else {
      either(parts::glsl::normalized_map, parts::hlsl::normalized_map);
    }
  };
  const auto displacement = [&] {
    for (const auto part : {parts::heights, parts::displacement}) both(part);
    if (!shader.reads_seams) return;
    either(parts::glsl::seams, parts::hlsl::seams);
    both(parts::seams);
  };
  const auto posed = [&] {
    both(parts::posing);
    either(parts::glsl::rest, parts::hlsl::rest);
    if (shader.joints > 0) {
      either(parts::glsl::skinned, parts::hlsl::skinned);
    } else {
      either(parts::glsl::rigid, parts::hlsl::rigid);
    }
  };
  const auto levels = [&] {
    switch (shader.levels) {
      case DisplacedShader::Levels::constant: return either(parts::glsl::constant_levels, parts::hlsl::constant_levels);
      case DisplacedShader::Levels::stored: return either(parts::glsl::stored_levels, parts::hlsl::stored_levels);
      case DisplacedShader::Levels::by_pixels: break;
    }
    both(parts::lengths);
    both(parts::edge_level);
    either(parts::glsl::frame, parts::hlsl::frame);
    either(parts::glsl::levels_by_pixels, parts::hlsl::levels_by_pixels);
  };

  both(constants(shader, language));
  if (stage != DisplacedStage::control) both(parts::vertex);
  switch (stage) {
    case DisplacedStage::functions:
      map();
      both(parts::posing);
      displacement();
      for (const auto part : {parts::lengths, parts::surface, parts::edge_level}) both(part);
      break;
    case DisplacedStage::cage:
      posed();
      either(parts::glsl::cage, parts::hlsl::cage);
      break;
    case DisplacedStage::cage_capture:
      posed();
      text += parts::glsl::cage_capture;
      break;
    case DisplacedStage::vertex:
    case DisplacedStage::vertex_of_cage:
      if (stage == DisplacedStage::vertex) {
        posed();
      } else {
        either(parts::glsl::posed_cage, parts::hlsl::posed_cage);
      }
      if (!glsl) text += parts::hlsl::corner;
      either(parts::glsl::vertex, parts::hlsl::vertex);
      break;
    case DisplacedStage::control:
      either(parts::glsl::patch_in, parts::hlsl::corner);
      if (!glsl) text += parts::hlsl::patch;
      levels();
      either(parts::glsl::control, parts::hlsl::control);
      break;
    case DisplacedStage::evaluation:
      map();
      displacement();
      for (const auto part : {parts::lengths, parts::surface}) both(part);
      either(parts::glsl::frame, parts::hlsl::frame);
      either(parts::glsl::patch_in, parts::hlsl::corner);
      if (!glsl) text += parts::hlsl::patch;
      either(parts::glsl::evaluation, parts::hlsl::evaluation);
      break;
  }
  return text;
}

}  // namespace

std::string displaced_shader_text(const DisplacedShader& shader, ShaderLanguage language, DisplacedStage stage) {
  check(shader, language, stage);
  const auto binding = [&](std::uint32_t place) { return std::to_string(shader.first_binding + place); };
  const std::string triangle = language == ShaderLanguage::glsl ? "uint(gl_PrimitiveID)" : "levels.triangle_number";
  const std::pair<std::string_view, std::string> words[] = {
      {"set", std::to_string(shader.set)},
      {"rest", binding(0)},
      {"skin", binding(1)},
      {"maps", binding(2)},
      {"cage", binding(3)},
      {"levels", binding(4)},
      {"seams", binding(5)},
      {"height", shader.reads_seams ? "displaced_seamed_height(a, b, c, w, " + triangle + ")"
                                    : std::string("displaced_point_height(a, b, c, w)")},
      // Not every compiler of HLSL lets a domain shader ask for SV_PrimitiveID.
      {"triangle_member", shader.reads_seams ? "\n  uint triangle_number : DISPLACED_TRIANGLE;" : ""},
      {"triangle_set", shader.reads_seams ? "\n  levels.triangle_number = number;" : ""},
      {"map_set", std::to_string(shader.map_set)},
      {"map_binding", std::to_string(shader.map_binding)},
      {"spacing", spacing(shader.spacing, language)},
      {"capture", shader.captures ? "layout(xfb_buffer = 0, xfb_stride = 40) out;" : ""},
      {"at_0", shader.captures ? ", xfb_offset = 0" : ""},
      {"at_12", shader.captures ? ", xfb_offset = 12" : ""},
      {"at_24", shader.captures ? ", xfb_offset = 24" : ""}};
  return parts::filled(parts_of(shader, language, stage), words);
}

}  // namespace foredraw
