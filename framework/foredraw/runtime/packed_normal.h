/* Directions in a few bits: as points of an octahedron, or as two angles. packed_vertex.h says what for, and why no
 * square root and no division decide a bit. C99, no state, no allocation, no library. */
#ifndef FOREDRAW_RUNTIME_PACKED_NORMAL_H
#define FOREDRAW_RUNTIME_PACKED_NORMAL_H

#include <foredraw/runtime/packed_layout.h>

/* 1 / sqrt(x) of a positive normal number, within three units in the last place: everywhere the same bits, which
 * devices do not promise of their own square roots and divisions. */
static inline float foredraw_packed_rsqrt(float x) {
  const float half = 0.5f * x;
  uint32_t bits;
  float y;
  memcpy(&bits, &x, sizeof bits);
  bits = 0x5f375a86u - (bits >> 1);
  memcpy(&y, &bits, sizeof y);
  y = y * (1.5f - (half * y) * y);
  y = y * (1.5f - (half * y) * y);
  return y * (1.5f - (half * y) * y);
}

static inline float foredraw_packed_reciprocal(float x) {
  const float root = foredraw_packed_rsqrt(x);
  return root * root;
}

static inline int32_t foredraw_packed_abs(int32_t x) { return x < 0 ? -x : x; }
static inline float foredraw_packed_absf(float x) { return x < 0.0f ? -x : x; }

/* The cosine of a diamond's angle, times its quarter: it falls from `quarter` at 0 to -`quarter` at 2 * quarter. */
static inline int32_t foredraw_packed_wave(uint32_t code, int32_t quarter) {
  return foredraw_packed_abs((int32_t)(code & (uint32_t)(4 * quarter - 1)) - 2 * quarter) - quarter;
}

/* A normal's two codes, from 0 to 2^bits - 2, as the point of the octahedron |x| + |y| + |z| = 2^(bits - 1) - 1, which
 * has whole coordinates, brought to length 1. Axes are exact in direction. */
static inline void foredraw_packed_octahedral(uint32_t u, uint32_t v, uint32_t bits, float normal[3]) {
  const int32_t half = (1 << (bits - 1)) - 1;
  int32_t x = (int32_t)u - half, y = (int32_t)v - half;
  const int32_t z = half - foredraw_packed_abs(x) - foredraw_packed_abs(y);
  const int32_t fold = z < 0 ? -z : 0;
  float per_length;
  x = x < 0 ? x + fold : x - fold;
  y = y < 0 ? y + fold : y - fold;
  per_length = foredraw_packed_rsqrt((float)(x * x + y * y + z * z));
  normal[0] = (float)x * per_length;
  normal[1] = (float)y * per_length;
  normal[2] = (float)z * per_length;
}

/* Of a part of a right angle, from -1 to 1. */
static inline float foredraw_packed_sine(float part) {
  const float y = part * 1.57079633f, s = y * y;
  float sum = 2.75573192e-6f - s * 2.50521084e-8f;
  sum = 1.98412698e-4f - s * sum;
  sum = 8.33333333e-3f - s * sum;
  sum = 1.66666667e-1f - s * sum;
  return y - y * (s * sum);
}

/* The same of two angles: u around z from x on, 2^bits of them; v from +z down to -z, both among 2^bits. */
static inline void foredraw_packed_spherical(uint32_t u, uint32_t v, uint32_t bits, float normal[3]) {
  const int32_t quarter = 1 << (bits - 2), most = 4 * quarter - 1;
  const float per_quarter = 1.0f / (float)quarter;
  const float height = (float)(2 * (int32_t)v - most) * (1.0f / (float)most);
  const float around = foredraw_packed_sine(1.0f - foredraw_packed_absf(height));
  normal[0] = around * foredraw_packed_sine((float)foredraw_packed_wave(u, quarter) * per_quarter);
  normal[1] = around * foredraw_packed_sine((float)foredraw_packed_wave(u - (uint32_t)quarter, quarter) * per_quarter);
  normal[2] = -foredraw_packed_sine(height);
}

static inline void foredraw_packed_decode_normal(const foredraw_packed_layout* layout, uint32_t u, uint32_t v,
                                                 float normal[3]) {
  const uint32_t bits = layout->field[FOREDRAW_PACKED_NORMAL_0].bits;
  if (layout->is_spherical) {
    foredraw_packed_spherical(u, v, bits, normal);
  } else {
    foredraw_packed_octahedral(u, v, bits, normal);
  }
}

/* Whether it has a direction; else it is given one. */
static inline int foredraw_packed_unit(const float from[3], float unit[3]) {
  const float squared = from[0] * from[0] + from[1] * from[1] + from[2] * from[2];
  const int is_direction = squared > 1e-36f && squared < 1e36f;
  const float per_length = is_direction ? foredraw_packed_rsqrt(squared) : 0.0f;
  unit[0] = is_direction ? from[0] * per_length : 0.0f;
  unit[1] = is_direction ? from[1] * per_length : 0.0f;
  unit[2] = is_direction ? from[2] * per_length : 1.0f;
  return is_direction;
}

/* The lower corner of the cell of the octahedron's square that a unit vector lies in. */
static inline void foredraw_packed_octahedral_cell(const float unit[3], uint32_t bits, uint32_t cell[2]) {
  const int32_t half = (1 << (bits - 1)) - 1;
  const float size = (float)half;
  const float x = foredraw_packed_absf(unit[0]), y = foredraw_packed_absf(unit[1]);
  const float scale = size * foredraw_packed_reciprocal((x + y) + foredraw_packed_absf(unit[2]));
  const float u = x * scale, v = y * scale;
  const float folded[2] = {unit[2] < 0.0f ? size - v : u, unit[2] < 0.0f ? size - u : v};
  uint32_t i;
  for (i = 0; i < 2; ++i) {
    const int32_t at = (int32_t)(unit[i] < 0.0f ? size - folded[i] : size + folded[i]);
    cell[i] = (uint32_t)(at < 0 ? 0 : at > 2 * half - 1 ? 2 * half - 1 : at);
  }
}

/* The same of the two angles' codes: by halving, for the code is the angle, and its sine what is known. */
static inline void foredraw_packed_spherical_cell(const float unit[3], uint32_t bits, uint32_t cell[2]) {
  const uint32_t quarter = 1u << (bits - 2), most = 4 * quarter - 1;
  const float x = foredraw_packed_absf(unit[0]), y = foredraw_packed_absf(unit[1]);
  const float per_quarter = 1.0f / (float)quarter, per_most = 1.0f / (float)most;
  uint32_t around = 0, down = 0, bit;
  for (bit = quarter >> 1; bit != 0; bit >>= 1) {
    const float part = (float)(around + bit) * per_quarter;
    if (foredraw_packed_sine(part) * x <= foredraw_packed_sine(1.0f - part) * y) around += bit;
  }
  for (bit = 2 * quarter; bit != 0; bit >>= 1) {
    const int32_t height = 2 * (int32_t)(down + bit) - (int32_t)most;
    if (0.0f - foredraw_packed_sine((float)height * per_most) >= unit[2]) down += bit;
  }
  if (unit[0] < 0.0f) around = unit[1] < 0.0f ? 2 * quarter + around : 2 * quarter - 1 - around;
  if (unit[0] >= 0.0f && unit[1] < 0.0f) around = 4 * quarter - 1 - around;
  cell[0] = around;
  cell[1] = down < most ? down : most - 1;
}

/* The codes of the nearest one of the cell's four corners, of equally near ones the first. */
static inline void foredraw_packed_encode_normal(const foredraw_packed_layout* layout, const float unit[3],
                                                 uint32_t code[2], float decoded[3]) {
  const uint32_t bits = layout->field[FOREDRAW_PACKED_NORMAL_0].bits;
  uint32_t cell[2], i;
  float nearest = 8.0f;
  if (layout->is_spherical) {
    foredraw_packed_spherical_cell(unit, bits, cell);
  } else {
    foredraw_packed_octahedral_cell(unit, bits, cell);
  }
  for (i = 0; i < 4; ++i) {
    const uint32_t u = (cell[0] + (i & 1u)) & foredraw_packed_most(bits), v = cell[1] + (i >> 1);
    float corner[3], x, y, z, squared;
    foredraw_packed_decode_normal(layout, u, v, corner);
    x = corner[0] - unit[0];
    y = corner[1] - unit[1];
    z = corner[2] - unit[2];
    squared = x * x + y * y + z * z;
    if (!(squared < nearest)) continue;
    nearest = squared;
    code[0] = u;
    code[1] = v;
    memcpy(decoded, corner, sizeof corner);
  }
}

#endif
