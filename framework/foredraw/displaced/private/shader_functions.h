#pragma once
// The functions of displaced_height.h, displaced_surface.h and displaced_cage.h, one for one, in the words that GLSL
// and HLSL share, spelled as in GLSL.

#include <string_view>

namespace foredraw::displaced_shader_parts {

inline constexpr std::string_view vertex = R"(struct DisplacedVertex {
  vec3 position;
  int x;
  vec3 direction;
  int y;
};

)";

inline constexpr std::string_view posing = R"(struct DisplacedMap {
  vec4 x, y, z;
};

DisplacedMap displaced_blended(DisplacedMap a, DisplacedMap b, DisplacedMap c, DisplacedMap d, vec4 weight) {
  precise vec4 x = ((weight.x * a.x + weight.y * b.x) + weight.z * c.x) + weight.w * d.x;
  precise vec4 y = ((weight.x * a.y + weight.y * b.y) + weight.z * c.y) + weight.w * d.y;
  precise vec4 z = ((weight.x * a.z + weight.y * b.z) + weight.z * c.z) + weight.w * d.z;
  DisplacedMap blended;
  blended.x = x;
  blended.y = y;
  blended.z = z;
  return blended;
}

float displaced_along(vec4 row, vec3 v) {
  precise float sum = (row.x * v.x + row.y * v.y) + row.z * v.z;
  return sum;
}

DisplacedVertex displaced_posed(DisplacedVertex rest, DisplacedMap map) {
  precise vec3 moved = vec3(displaced_along(map.x, rest.position) + map.x.w,
                            displaced_along(map.y, rest.position) + map.y.w,
                            displaced_along(map.z, rest.position) + map.z.w);
  DisplacedVertex posed = rest;
  posed.position = moved;
  posed.direction = vec3(displaced_along(map.x, rest.direction), displaced_along(map.y, rest.direction),
                         displaced_along(map.z, rest.direction));
  return posed;
}

)";

inline constexpr std::string_view heights = R"(// 1/256 texel from the left or upper edge.
int displaced_height_place(float uv, uint size) {
  precise float place = uv * (256.0 * float(size));
  if (place >= 67108864.0) return 67108864;
  if (place > -67108864.0) return int(roundEven(place));
  return place <= -67108864.0 ? -67108864 : 0;
}

uint displaced_height_weight(float part) {
  return part > 0.0 ? (part >= 1.0 ? 65536u : uint(roundEven(part * 65536.0))) : 0u;
}

// In 1/65536, together 65536.
uvec3 displaced_height_weights(vec3 part) {
  uvec3 weight = uvec3(displaced_height_weight(part.x), displaced_height_weight(part.y), displaced_height_weight(part.z));
  uint most = weight.y > weight.x ? 1u : 0u;
  if (weight.z > weight[most]) most = 2u;
  uint one = (most + 1u) % 3u, other = (most + 2u) % 3u;
  if (weight[one] + weight[other] > 65536u) weight[other] = 65536u - weight[one];
  weight[most] = 65536u - weight[one] - weight[other];
  return weight;
}

// In two halves, for want of 64 bits.
int displaced_height_between(ivec3 corner, uvec3 weight) {
  ivec3 w = ivec3(weight), high = corner >> 12, low = corner & 4095;
  int a = w.x * high.x + w.y * high.y + w.z * high.z;
  int b = w.x * low.x + w.y * low.y + w.z * low.z;
  return (a >> 4) + (((a & 15) * 4096 + b + 32768) >> 16);
}

// Numbers lie within 2^20, which is added in whole periods: remainders of negative ones are not defined everywhere.
uint displaced_height_texel(int number, uint size, uint wrap) {
  if (wrap != 0u && wrap != 1u) return number < 0 ? 0u : min(uint(number), size - 1u);
  uint period = wrap == 1u ? 2u * size : size;
  uint at = uint(number + int((1048576u / period + 1u) * period)) % period;
  return at < size ? at : period - 1u - at;
}

// Four texels by weights that are together 65536, or one.
uint displaced_height_sum(ivec2 place) {
  ivec2 from = displaced_is_nearest ? place : place - 128;
  ivec2 number = from >> 8;
  uint left = displaced_height_texel(number.x, displaced_size.x, displaced_wrap.x);
  uint upper = displaced_height_texel(number.y, displaced_size.y, displaced_wrap.y);
  if (displaced_is_nearest) return 65536u * displaced_texel(left, upper);
  uint right = displaced_height_texel(number.x + 1, displaced_size.x, displaced_wrap.x);
  uint lower = displaced_height_texel(number.y + 1, displaced_size.y, displaced_wrap.y);
  uvec2 f = uvec2(from & 255);
  return (256u - f.x) * (256u - f.y) * displaced_texel(left, upper) + f.x * (256u - f.y) * displaced_texel(right, upper) +
         (256u - f.x) * f.y * displaced_texel(left, lower) + f.x * f.y * displaced_texel(right, lower);
}

uint displaced_height(ivec2 place) { return displaced_height_sum(place) >> (32u - displaced_bits); }

float displaced_height_part(uint height) {
  precise float part = float(height) / float((1u << displaced_bits) - 1u);
  return part;
}

)";

inline constexpr std::string_view displacement =
    R"(uint displaced_point_height(DisplacedVertex a, DisplacedVertex b, DisplacedVertex c, uvec3 w) {
  return displaced_height(ivec2(displaced_height_between(ivec3(a.x, b.x, c.x), w),
                                displaced_height_between(ivec3(a.y, b.y, c.y), w)));
}

float displaced_displacement(uint height) {
  precise float displacement = displaced_offset + displaced_factor * displaced_height_part(height);
  return displacement;
}

)";

/// Behind displaced_seam(), which gives a word of the buffer that seam_words() fills.
inline constexpr std::string_view seams =
    R"(// Twice the number of an edge, and 1 more where the side is turned; none: 0xffffffff.
uint displaced_seam_of(uint side) {
  uint from = 0u, count = displaced_seam(0u);
  while (count > 0u) {
    uint middle = count / 2u, at = displaced_seam(2u + 2u * (from + middle));
    if (at == side) return displaced_seam(3u + 2u * (from + middle));
    if (at < side) {
      from += middle + 1u;
      count -= middle + 1u;
    } else {
      count = middle;
    }
  }
  return 4294967295u;
}

// Number `i` of the heights from end to end. `edge`: 8 times the number of its first height, and log2 of its parts.
uint displaced_seam_height_of(uint edge, uvec2 ends, uint i) {
  if (i == 0u) return ends.x;
  if (i >= (1u << (edge & 7u))) return ends.y;
  uint at = (edge >> 3) + i - 1u;
  uint two = displaced_seam(2u + 2u * displaced_seam(0u) + displaced_seam(1u) + at / 2u);
  return ((two >> (16u * (at & 1u))) & 65535u) >> (16u - displaced_bits);
}

uint displaced_seam_height(uint side, uvec2 ends, uint place) {
  uint edge = displaced_seam(2u + 2u * displaced_seam(0u) + side / 2u), within = min(place, 65536u);
  bool is_reversed = (side & 1u) != 0u;
  uvec2 along = is_reversed ? ends.yx : ends;
  uint at = (is_reversed ? 65536u - within : within) << (edge & 7u), part = at & 65535u;
  uint first = displaced_seam_height_of(edge, along, at >> 16), second = displaced_seam_height_of(edge, along, (at >> 16) + 1u);
  return (first * (65536u - part) + second * part) >> 16;
}

// On a seam by the table, and else by the map.
uint displaced_seamed_height(DisplacedVertex a, DisplacedVertex b, DisplacedVertex c, uvec3 w, uint number) {
  for (uint e = 0u; e < 3u; ++e) {  // from corner e to the next one, across from the third
    uint next = (e + 1u) % 3u;
    if (w[(e + 2u) % 3u] != 0u) continue;
    uint side = displaced_seam_of(3u * number + e);
    if (side == 4294967295u) continue;
    DisplacedVertex from = c, to = a;
    if (e == 0u) from = a;
    if (e == 1u) from = b;
    if (next == 1u) to = b;
    if (next == 2u) to = c;
    return displaced_seam_height(side, uvec2(displaced_height(ivec2(from.x, from.y)), displaced_height(ivec2(to.x, to.y))),
                                 w[next]);
  }
  return displaced_point_height(a, b, c, w);
}

)";

inline constexpr std::string_view lengths = R"(float displaced_length(vec3 v) {
  precise float square = (v.x * v.x + v.y * v.y) + v.z * v.z;
  return sqrt(square);
}

)";

inline constexpr std::string_view surface = R"(vec3 displaced_weighted(vec3 a, vec3 b, vec3 c, vec3 weight) {
  precise vec3 sum = (weight.x * a + weight.y * b) + weight.z * c;
  return sum;
}

vec3 displaced_point(DisplacedVertex a, DisplacedVertex b, DisplacedVertex c, vec3 weight, float displacement) {
  vec3 plane = displaced_weighted(a.position, b.position, c.position, weight);
  vec3 along = displaced_weighted(a.direction, b.direction, c.direction, weight);
  float size = displaced_length(along);
  if (!(size > 0.0)) return plane;
  vec3 sizes = vec3(displaced_length(a.direction), displaced_length(b.direction), displaced_length(c.direction));
  precise vec3 scale = weight * sizes;
  precise float by = displacement * (((scale.x + scale.y) + scale.z) / size);
  precise vec3 moved = plane + along * by;
  return moved;
}

)";

inline constexpr std::string_view edge_level = R"(// The same from both ends.
float displaced_edge_level(vec3 a, vec3 b, vec3 eye, float pixels_per_unit, float pixels_per_part) {
  precise vec3 along = a - b;
  precise vec3 away = 0.5 * (a + b) - eye;
  precise float level = displaced_length(along) * pixels_per_unit / (displaced_length(away) * pixels_per_part);
  return !(level > 1.0) ? 1.0 : level < 64.0 ? level : 64.0;
}

)";

}  // namespace foredraw::displaced_shader_parts
