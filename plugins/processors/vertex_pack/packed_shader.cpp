#include "packed_shader.h"

#include <algorithm>
#include <bit>
#include <string_view>
#include <utility>

namespace foredraw::packing {

namespace {

/// Words that begin with a dollar are those of the language, or a layout's.
using Word = std::pair<std::string_view, std::string>;

std::string with_words(std::string_view text, const std::vector<Word>& words) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const auto is_here = [&](const Word& word) { return text.substr(at).starts_with(word.first); };
    const auto word = std::ranges::find_if(words, is_here);
    result += word == words.end() ? std::string(1, text[at]) : word->second;
    at += word == words.end() ? 1 : word->first.size();
  }
  return result;
}

std::vector<Word> words_of(ShaderLanguage language) {
  if (language == ShaderLanguage::glsl) {
    return {{"$f2", "vec2"},
            {"$f3", "vec3"},
            {"$f4", "vec4"},
            {"$u2", "uvec2"},
            {"$u4", "uvec4"},
            {"$float", "uintBitsToFloat"},
            {"$uint", "floatBitsToUint"},
            {"$round", "roundEven"}};
  }
  return {{"$f2", "float2"}, {"$f3", "float3"},     {"$f4", "float4"},   {"$u2", "uint2"},
          {"$u4", "uint4"},  {"$float", "asfloat"}, {"$uint", "asuint"}, {"$round", "round"}};
}

// As runtime/packed_vertex.h has it, line by line. `precise` keeps compilers from fusing.
constexpr std::string_view head = R"(struct PackedVertex {
  $f3 position;
  $f3 normal;
  $f4 tangent;
  $f2 uv;
};

float packed_rsqrt(float x) {
  precise float scaled = 0.5 * x;
  precise float y = $float(0x5f375a86u - ($uint(x) >> 1u));
  y = y * (1.5 - (scaled * y) * y);
  y = y * (1.5 - (scaled * y) * y);
  y = y * (1.5 - (scaled * y) * y);
  return y;
}

float packed_reciprocal(float x) {
  precise float root = packed_rsqrt(x);
  root = root * root;
  return root;
}

int packed_wave(uint code, int quarter) {
  return abs(int(code & uint(4 * quarter - 1)) - 2 * quarter) - quarter;
}

$f3 packed_octahedral(uint u, uint v, uint bits) {
  int middle = (1 << int(bits - 1u)) - 1;
  int x = int(u) - middle;
  int y = int(v) - middle;
  int z = middle - abs(x) - abs(y);
  int fold = max(-z, 0);
  x = x < 0 ? x + fold : x - fold;
  y = y < 0 ? y + fold : y - fold;
  precise float per_length = packed_rsqrt(float(x * x + y * y + z * z));
  precise $f3 normal = $f3(float(x) * per_length, float(y) * per_length, float(z) * per_length);
  return normal;
}

float packed_sine(float part) {
  precise float y = part * 1.57079633;
  precise float s = y * y;
  precise float sum = 2.75573192e-6 - s * 2.50521084e-8;
  sum = 1.98412698e-4 - s * sum;
  sum = 8.33333333e-3 - s * sum;
  sum = 1.66666667e-1 - s * sum;
  precise float sine = y - y * (s * sum);
  return sine;
}

$f3 packed_spherical(uint u, uint v, uint bits, float per_most) {
  int quarter = 1 << int(bits - 2u);
  float per_quarter = $float((129u - bits) << 23u);
  precise float height = float(2 * int(v) - (4 * quarter - 1)) * per_most;
  precise float level = 1.0 - abs(height);
  precise float around = packed_sine(level);
  precise float x = float(packed_wave(u, quarter)) * per_quarter;
  precise float y = float(packed_wave(u - uint(quarter), quarter)) * per_quarter;
  precise $f3 normal = $f3(around * packed_sine(x), around * packed_sine(y), -packed_sine(height));
  return normal;
}

$f3 packed_tangent($f3 normal, uint code, uint bits) {
  int quarter = 1 << int(bits - 2u);
  int along = packed_wave(code, quarter);
  int across = packed_wave(code - uint(quarter), quarter);
  bool is_x = abs(normal.x) > abs(normal.z);
  float p = is_x ? normal.z : normal.x;
  float q = normal.y;
  float r = is_x ? normal.x : normal.z;
  precise float squared = q * q + r * r;
  precise float length_squared = float(along * along + across * across) * squared;
  precise float per_length = packed_rsqrt(length_squared);
  precise float c = float(along) * per_length;
  precise float s = float(across) * per_length;
  precise float first = s * squared;
  precise float last = c * q - s * (p * r);
  precise float between = 0.0 - c * r - s * (p * q);
  return $f3(is_x ? last : first, between, is_x ? first : last);
}

uint packed_code(float value, float per_step, int origin, int most, inout bool is_outside) {
  precise float at = value * per_step;
  at = at >= -33554432.0 ? at : -33554432.0;
  at = min(at, 33554432.0);
  int code = int($round(at)) - origin;
  is_outside = is_outside || code < 0 || code > most;
  return uint(clamp(code, 0, most));
}

$f3 packed_unit($f3 v, inout bool is_none) {
  precise float squared = v.x * v.x + v.y * v.y + v.z * v.z;
  bool is_direction = squared > 1e-36 && squared < 1e36;
  is_none = is_none || !is_direction;
  if (!is_direction) return $f3(0.0, 0.0, 1.0);
  precise float per_length = packed_rsqrt(squared);
  precise $f3 unit = $f3(v.x * per_length, v.y * per_length, v.z * per_length);
  return unit;
}

$u2 packed_octahedral_cell($f3 unit, uint bits) {
  int middle = (1 << int(bits - 1u)) - 1;
  float size = float(middle);
  float x = abs(unit.x);
  float y = abs(unit.y);
  precise float sum = (x + y) + abs(unit.z);
  precise float scale = size * packed_reciprocal(sum);
  precise float u = x * scale;
  precise float v = y * scale;
  precise float folded_u = unit.z < 0.0 ? size - v : u;
  precise float folded_v = unit.z < 0.0 ? size - u : v;
  precise float at_u = unit.x < 0.0 ? size - folded_u : size + folded_u;
  precise float at_v = unit.y < 0.0 ? size - folded_v : size + folded_v;
  return $u2(uint(clamp(int(at_u), 0, 2 * middle - 1)), uint(clamp(int(at_v), 0, 2 * middle - 1)));
}

$u2 packed_spherical_cell($f3 unit, uint bits, float per_most) {
  uint quarter = 1u << (bits - 2u);
  int most = int(4u * quarter - 1u);
  float per_quarter = $float((129u - bits) << 23u);
  float x = abs(unit.x);
  float y = abs(unit.y);
  uint around = 0u;
  uint down = 0u;
  for (uint bit = quarter >> 1u; bit != 0u; bit >>= 1u) {
    precise float part = float(around + bit) * per_quarter;
    precise float rest = 1.0 - part;
    precise float before = packed_sine(part) * x;
    precise float behind = packed_sine(rest) * y;
    if (before <= behind) around += bit;
  }
  for (uint step = 2u * quarter; step != 0u; step >>= 1u) {
    precise float height = float(2 * int(down + step) - most) * per_most;
    precise float level = 0.0 - packed_sine(height);
    if (level >= unit.z) down += step;
  }
  if (unit.x < 0.0) {
    around = unit.y < 0.0 ? 2u * quarter + around : 2u * quarter - 1u - around;
  } else if (unit.y < 0.0) {
    around = 4u * quarter - 1u - around;
  }
  return $u2(around, min(down, uint(most - 1)));
}

uint packed_tangent_code($f3 normal, $f3 tangent, uint bits, inout bool is_none) {
  bool is_x = abs(normal.x) > abs(normal.z);
  float p = is_x ? normal.z : normal.x;
  float q = normal.y;
  float r = is_x ? normal.x : normal.z;
  float first = is_x ? tangent.z : tangent.x;
  float last = is_x ? tangent.x : tangent.z;
  precise float c = last * q - tangent.y * r;
  precise float s = first * (q * q + r * r) - (tangent.y * (p * q) + last * (p * r));
  precise float sum = abs(c) + abs(s);
  precise float squared = first * first + tangent.y * tangent.y + last * last;
  precise float sum_squared = sum * sum;
  precise float limit = squared * 1e-10;
  if (!(squared > 1e-36 && squared < 1e36 && sum_squared > limit)) {
    is_none = true;
    return 0u;
  }
  precise float part = abs(s) * packed_reciprocal(sum);
  part = c < 0.0 ? 2.0 - part : part;
  part = s < 0.0 ? 4.0 - part : part;
  part = part * float(1 << int(bits - 2u));
  return uint(int($round(part))) & ((1u << bits) - 1u);
}
)";

constexpr std::string_view decode = R"(
PackedVertex packed_decode($u4 row) {
  PackedVertex vertex;
  vertex.position = $f3(float(int($x) + $ox) * $step, float(int($y) + $oy) * $step, float(int($z) + $oz) * $step);
  vertex.normal = $normal;
  vertex.tangent = $tangent;
  vertex.uv = $uv;
  return vertex;
}
)";

constexpr std::string_view encode_begin = R"(
uint packed_encode(PackedVertex vertex, out $u4 row) {
  bool position_is_outside = false;
  bool uv_is_outside = false;
  bool normal_is_none = false;
  bool tangent_is_none = false;
  row = $u4(0u, 0u, 0u, 0u);
)";

constexpr std::string_view encode_normal = R"(  $f3 unit = packed_unit(vertex.normal, normal_is_none);
  $u2 cell = $cell;
  $u2 code = cell;
  $f3 normal = unit;
  precise float nearest = 8.0;
  for (uint i = 0u; i < 4u; ++i) {
    $u2 at = $u2((cell.x + (i & 1u)) & $mostu, cell.y + (i >> 1u));
    $f3 corner = $corner;
    precise $f3 apart = corner - unit;
    precise float squared = apart.x * apart.x + apart.y * apart.y + apart.z * apart.z;
    if (squared < nearest) {
      nearest = squared;
      code = at;
      normal = corner;
    }
  }
)";

constexpr std::string_view encode_end =
    R"(  return (position_is_outside ? 1u : 0u) | (uv_is_outside ? 2u : 0u) | (normal_is_none ? 4u : 0u) |
         (tangent_is_none ? 8u : 0u);
}
)";

std::string number(std::uint32_t value) { return std::to_string(value) + 'u'; }
std::string number(std::int32_t value) { return value < 0 ? "(" + std::to_string(value) + ")" : std::to_string(value); }
/// By its bits, so that no digit is lost.
std::string number(float value) { return "$float(" + number(std::bit_cast<std::uint32_t>(value)) + ")"; }

/// The text of one layout, in which only the language's words are left to put in.
class LayoutText {
 public:
  explicit LayoutText(const PackedLayout& layout) : layout_(layout) {}

  std::string text() const {
    const std::vector<Word> words = {{"$x", read(FOREDRAW_PACKED_X)},    {"$y", read(FOREDRAW_PACKED_Y)},
                                     {"$z", read(FOREDRAW_PACKED_Z)},    {"$ox", number(layout_.origin[0])},
                                     {"$oy", number(layout_.origin[1])}, {"$oz", number(layout_.origin[2])},
                                     {"$step", number(layout_.step)},    {"$normal", decoded_normal()},
                                     {"$tangent", decoded_tangent()},    {"$uv", decoded_uv()}};
    return with_words(decode, words) + encode();
  }

 private:
  std::uint32_t bits(int field) const { return layout_.field[field].bits; }
  std::uint32_t normal_bits() const { return bits(FOREDRAW_PACKED_NORMAL_0); }
  std::string word(int field) const { return std::string("row.") + "xyzw"[layout_.field[field].word]; }

  std::string read(int field) const {
    return "(" + word(field) + " >> " + number(layout_.field[field].shift) + " & " +
           number(foredraw_packed_most(bits(field))) + ")";
  }

  std::string write(int field, const std::string& code) const {
    return "  " + word(field) + " |= " + code + " << " + number(layout_.field[field].shift) + ";\n";
  }

  std::string normal_of(const std::string& u, const std::string& v) const {
    const std::string codes = u + ", " + v + ", " + number(normal_bits());
    return layout_.is_spherical == 0 ? "packed_octahedral(" + codes + ")"
                                     : "packed_spherical(" + codes + ", " + per_most() + ")";
  }

  std::string per_most() const { return number(1.0f / static_cast<float>(foredraw_packed_most(normal_bits()))); }

  std::string decoded_normal() const {
    return normal_bits() == 0 ? "$f3(0.0, 0.0, 0.0)"
                              : normal_of(read(FOREDRAW_PACKED_NORMAL_0), read(FOREDRAW_PACKED_NORMAL_1));
  }

  std::string decoded_tangent() const {
    if (bits(FOREDRAW_PACKED_TANGENT) == 0) return "$f4(0.0, 0.0, 0.0, 0.0)";
    return "$f4(packed_tangent(vertex.normal, " + read(FOREDRAW_PACKED_TANGENT) + ", " +
           number(bits(FOREDRAW_PACKED_TANGENT)) + "), " + read(FOREDRAW_PACKED_SIGN) + " != 0u ? -1.0 : 1.0)";
  }

  std::string decoded_uv() const {
    if (bits(FOREDRAW_PACKED_U) == 0) return "$f2(0.0, 0.0)";
    const auto one = [&](int i) {
      return "float(int(" + read(FOREDRAW_PACKED_U + i) + ") + " + number(layout_.uv_origin[i]) + ") * " +
             number(layout_.uv_step[i]);
    };
    return "$f2(" + one(0) + ", " + one(1) + ")";
  }

  std::string write_number(int field, const std::string& value, float step, std::int32_t origin,
                           const std::string& outside) const {
    return write(field, "packed_code(" + value + ", " + number(1.0f / step) + ", " + number(origin) + ", " +
                            number(static_cast<std::int32_t>(foredraw_packed_most(bits(field)))) + ", " + outside +
                            ")");
  }

  std::string encode() const {
    std::string text(encode_begin);
    const std::string axes[] = {"x", "y", "z"};
    for (int i = 0; i < 3; ++i) {
      text += write_number(FOREDRAW_PACKED_X + i, "vertex.position." + axes[i], layout_.step, layout_.origin[i],
                           "position_is_outside");
    }
    for (int i = 0; i < 2 && bits(FOREDRAW_PACKED_U) != 0; ++i) {
      text += write_number(FOREDRAW_PACKED_U + i, "vertex.uv." + axes[i], layout_.uv_step[i], layout_.uv_origin[i],
                           "uv_is_outside");
    }
    if (normal_bits() != 0) text += encode_directions();
    return text + std::string(encode_end);
  }

  std::string encode_directions() const {
    const std::string cell = layout_.is_spherical == 0
                                 ? "packed_octahedral_cell(unit, " + number(normal_bits()) + ")"
                                 : "packed_spherical_cell(unit, " + number(normal_bits()) + ", " + per_most() + ")";
    std::string text = with_words(encode_normal, {{"$cell", cell},
                                                  {"$corner", normal_of("at.x", "at.y")},
                                                  {"$mostu", number(foredraw_packed_most(normal_bits()))}});
    text += write(FOREDRAW_PACKED_NORMAL_0, "code.x") + write(FOREDRAW_PACKED_NORMAL_1, "code.y");
    if (bits(FOREDRAW_PACKED_TANGENT) == 0) return text;
    return text +
           write(FOREDRAW_PACKED_TANGENT, "packed_tangent_code(normal, vertex.tangent.xyz, " +
                                              number(bits(FOREDRAW_PACKED_TANGENT)) + ", tangent_is_none)") +
           write(FOREDRAW_PACKED_SIGN, "(vertex.tangent.w < 0.0 ? 1u : 0u)");
  }

  const PackedLayout& layout_;
};

}  // namespace

std::vector<PackedLayout> distinct_layouts(const PackedVertices& all) {
  std::vector<PackedLayout> layouts;
  const auto add = [&](const PackedLayout& layout) {
    if (std::ranges::find(layouts, layout) == layouts.end()) layouts.push_back(layout);
  };
  for (const PackedVertices::OfDraw& draw : all.draws) add(draw.layout);
  for (const PackedVertices::OfDraw& draw : all.draws) {
    if (draw.posed) add(*draw.posed);
  }
  return layouts;
}

std::string packed_shader_head(ShaderLanguage language) { return with_words(head, words_of(language)); }

std::string packed_shader_text(const PackedLayout& layout, ShaderLanguage language) {
  return with_words(LayoutText(layout).text(), words_of(language));
}

}  // namespace foredraw::packing
