/* Heights of a displacement map in whole numbers: what C, C++ and every shader compute alike, to the bit. C99, no
 * allocation, no state.
 *
 * Hardware filters with fractions of 8 bits that are rounded as it likes, so two sides of a seam that are equal in the
 * map come out unequal. Here every step is one of whole numbers, or a product by a power of two:
 *
 *   1. A corner's uv becomes a place in 1/256 texel: foredraw_height_place(), once a corner and axis.
 *   2. A point's barycentric coordinates become weights in 1/65536: foredraw_height_weights(), once a point.
 *   3. The point's place is the corners' by these weights: foredraw_height_between().
 *   4. Its height is that of four texels by weights of 8 bits: foredraw_displaced_height().
 *
 *   for (c = 0; c < 3; ++c) {
 *     x[c] = foredraw_height_place(uv[c][0], map.width);
 *     y[c] = foredraw_height_place(uv[c][1], map.height);
 *   }
 *   foredraw_height_weights(tess_coord, w);
 *   h = foredraw_displaced_height(&map, foredraw_height_between(x, w), foredraw_height_between(y, w), 14);
 *   d = offset + factor * foredraw_height_part(h, 14);
 *
 * On an edge one weight is 0, and the others do not depend on the triangle's third corner, nor on the sequence of its
 * corners. At k/2^n of an edge, n up to 16, and in fixed-point tessellators (16 bits behind the point) everywhere, the
 * weights are exact.
 *
 * A shader without 64-bit numbers adds step 3 in two halves: with c = 4096 * a + b, 0 <= b < 4096, over the three
 * corners A = sum(w * a) and B = sum(w * b), the place is (A >> 4) + (((A & 15) * 4096 + B + 32768) >> 16). Step 4
 * needs 32 bits without a sign, and four texels fetched by number (texelFetch, Load) at level 0. */
#ifndef FOREDRAW_RUNTIME_DISPLACED_HEIGHT_H
#define FOREDRAW_RUNTIME_DISPLACED_HEIGHT_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>

/* What lies beyond the edges of a map. Any other number is taken as FOREDRAW_HEIGHT_CLAMPED. */
#define FOREDRAW_HEIGHT_REPEAT 0
#define FOREDRAW_HEIGHT_MIRRORED 1
#define FOREDRAW_HEIGHT_CLAMPED 2

#define FOREDRAW_HEIGHT_MOST_PLACE 67108864 /* 2^26: texel 262,144, and so far to the other side */

typedef struct foredraw_height_map {
  const uint16_t* texels; /* [row * width + column], rows from the top */
  uint32_t width, height; /* 1 to 65536 each */
  uint8_t wrap[2];        /* along u and v */
  uint8_t is_nearest;     /* not 0: one texel, and not four */
} foredraw_height_map;

/* Where a corner lies, in 1/256 texel from the map's left or upper edge, which is at uv 0. The product with 256 * size
 * is one of floats; it is rounded to the nearest whole number, halves to the even one. Beyond the most it is the most;
 * NaN is 0. */
static inline int32_t foredraw_height_place(float uv, uint32_t size) {
  const float place = uv * (256.0f * (float)size);
  if (!(place == place)) return 0;
  if (place >= (float)FOREDRAW_HEIGHT_MOST_PLACE) return FOREDRAW_HEIGHT_MOST_PLACE;
  if (place <= -(float)FOREDRAW_HEIGHT_MOST_PLACE) return -FOREDRAW_HEIGHT_MOST_PLACE;
  return (int32_t)rintf(place);
}

/* Barycentric coordinates in 1/65536, together 65536: each is rounded to the nearest, halves to the even one, and the
 * largest is what the other two leave. What is no number, or below 0, is 0; above 1 is 1. Of three zeros the first is
 * 65536. */
static inline void foredraw_height_weights(const float barycentric[3], uint32_t weights[3]) {
  int c, most = 0;
  uint32_t *one, *other;
  for (c = 0; c < 3; ++c) {
    const float b = barycentric[c];
    weights[c] = !(b > 0.0f) ? 0u : b >= 1.0f ? 65536u : (uint32_t)rintf(b * 65536.0f);
    if (weights[c] > weights[most]) most = c;
  }
  one = &weights[(most + 1) % 3];
  other = &weights[(most + 2) % 3];
  if (*one + *other > 65536u) *other = 65536u - *one;
  weights[most] = 65536u - *one - *other;
}

/* The place of a point: that of the corners by weights that are together 65536, rounded to the nearest, halves up. */
static inline int32_t foredraw_height_between(const int32_t corners[3], const uint32_t weights[3]) {
  const int64_t above = (int64_t)FOREDRAW_HEIGHT_MOST_PLACE * 65536; /* so that what is divided is not below 0 */
  const int64_t sum =
      (int64_t)weights[0] * corners[0] + (int64_t)weights[1] * corners[1] + (int64_t)weights[2] * corners[2];
  return (int32_t)((sum + above + 32768) / 65536 - FOREDRAW_HEIGHT_MOST_PLACE);
}

/* Which texel of a row or column stands at a number that may lie beyond its ends. */
static inline uint32_t foredraw_height_texel(int32_t number, uint32_t size, uint8_t wrap) {
  const int64_t n = (int64_t)size, period = wrap == FOREDRAW_HEIGHT_MIRRORED ? 2 * n : n;
  int64_t at = number;
  if (wrap == FOREDRAW_HEIGHT_REPEAT || wrap == FOREDRAW_HEIGHT_MIRRORED) {
    at %= period;
    if (at < 0) at += period;
    if (at >= n) at = period - 1 - at;
    return (uint32_t)at;
  }
  return at < 0 ? 0u : at >= n ? size - 1u : (uint32_t)at;
}

/* The four texels around a place and their weights, together 65536: upper left, upper right, lower left, lower right.
 * Texel i has its middle at 256 * i + 128. */
typedef struct foredraw_height_footprint {
  uint32_t column[2], row[2];
  uint32_t weight[4];
} foredraw_height_footprint;

static inline foredraw_height_footprint foredraw_height_footprint_at(const foredraw_height_map* map, int32_t x,
                                                                     int32_t y) {
  const int64_t above = FOREDRAW_HEIGHT_MOST_PLACE * (int64_t)2; /* a multiple of 256 */
  const int64_t from_x = x + above - (map->is_nearest ? 0 : 128), from_y = y + above - (map->is_nearest ? 0 : 128);
  const uint32_t fx = map->is_nearest ? 0u : (uint32_t)(from_x % 256);
  const uint32_t fy = map->is_nearest ? 0u : (uint32_t)(from_y % 256);
  const int32_t column = (int32_t)(from_x / 256 - above / 256), row = (int32_t)(from_y / 256 - above / 256);
  foredraw_height_footprint at;
  at.column[0] = foredraw_height_texel(column, map->width, map->wrap[0]);
  at.column[1] = foredraw_height_texel(column + 1, map->width, map->wrap[0]);
  at.row[0] = foredraw_height_texel(row, map->height, map->wrap[1]);
  at.row[1] = foredraw_height_texel(row + 1, map->height, map->wrap[1]);
  at.weight[0] = (256u - fx) * (256u - fy);
  at.weight[1] = fx * (256u - fy);
  at.weight[2] = (256u - fx) * fy;
  at.weight[3] = fx * fy;
  return at;
}

/* The height at a place, in 1/65536 of a texel's step: the sum of four texels by their weights, which is exact. 0 where
 * there is no map. */
static inline uint32_t foredraw_height_sum(const foredraw_height_map* map, int32_t x, int32_t y) {
  foredraw_height_footprint at;
  const uint16_t *upper, *lower;
  if (map->texels == NULL || map->width == 0 || map->height == 0) return 0;
  at = foredraw_height_footprint_at(map, x, y);
  upper = map->texels + (size_t)at.row[0] * map->width;
  lower = map->texels + (size_t)at.row[1] * map->width;
  return at.weight[0] * upper[at.column[0]] + at.weight[1] * upper[at.column[1]] + at.weight[2] * lower[at.column[0]] +
         at.weight[3] * lower[at.column[1]];
}

/* The height in `bits` bits, 1 to 16: the first ones of the sum. Any other number of bits is taken as 16. */
static inline uint32_t foredraw_displaced_height(const foredraw_height_map* map, int32_t x, int32_t y, uint32_t bits) {
  return foredraw_height_sum(map, x, y) >> (bits >= 1 && bits <= 16 ? 32 - bits : 16);
}

/* A height as part of the map's range, 0 to 1. Of equal heights equal. */
static inline float foredraw_height_part(uint32_t height, uint32_t bits) {
  return (float)height / (float)((1u << (bits >= 1 && bits <= 16 ? bits : 16)) - 1u);
}

#endif
