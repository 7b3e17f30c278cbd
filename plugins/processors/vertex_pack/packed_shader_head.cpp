#include "shader_words.h"

namespace foredraw::processors::vertex_pack {

namespace {

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

}  // namespace

std::string packed_shader_head(ShaderLanguage language) { return with_words(head, words_of(language)); }

}  // namespace foredraw::processors::vertex_pack
