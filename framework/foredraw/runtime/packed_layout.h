/* How a vertex lies in 128 bits. packed_vertex.h says what for. C99, no state, no allocation, no library. */
#ifndef FOREDRAW_RUNTIME_PACKED_LAYOUT_H
#define FOREDRAW_RUNTIME_PACKED_LAYOUT_H

#include <stdint.h>
#include <string.h>

/* Which field is which. The two of the normal have as many bits, and so have u and v if there are any. */
enum {
  FOREDRAW_PACKED_X,
  FOREDRAW_PACKED_Y,
  FOREDRAW_PACKED_Z,
  FOREDRAW_PACKED_NORMAL_0,
  FOREDRAW_PACKED_NORMAL_1,
  FOREDRAW_PACKED_TANGENT,
  FOREDRAW_PACKED_SIGN,
  FOREDRAW_PACKED_U,
  FOREDRAW_PACKED_V,
  FOREDRAW_PACKED_FIELDS
};

typedef struct foredraw_packed_field {
  uint32_t word;  /* 0 to 3 */
  uint32_t shift; /* from the lowest bit of the word */
  uint32_t bits;  /* 0: the rows do not have it */
} foredraw_packed_field;

/* A number is step * (origin + its code). */
typedef struct foredraw_packed_layout {
  foredraw_packed_field field[FOREDRAW_PACKED_FIELDS];
  int32_t origin[3]; /* origin and origin + largest code lie within +-2^24 */
  float step;        /* a power of two, from 2^-100 to 2^100; of all three axes */
  int32_t uv_origin[2];
  float uv_step[2];
  uint32_t is_spherical; /* normals are two angles, as in the paper; else points of an octahedron */
} foredraw_packed_layout;

static inline uint32_t foredraw_packed_most(uint32_t bits) { return (1u << bits) - 1u; }

static inline int foredraw_packed_is_within(int32_t origin, uint32_t bits) {
  return origin >= -16777216 && origin <= 16777216 - (int32_t)foredraw_packed_most(bits);
}

/* Whether it is a layout: fields lie within their words and apart, and all numbers are within their limits. */
static inline int foredraw_packed_is_layout(const foredraw_packed_layout* layout) {
  static const uint32_t least_bits[FOREDRAW_PACKED_FIELDS] = {1, 1, 1, 3, 3, 3, 1, 1, 1};
  static const uint32_t most_bits[FOREDRAW_PACKED_FIELDS] = {24, 24, 24, 16, 16, 16, 1, 23, 23};
  const foredraw_packed_field* field = layout->field;
  uint32_t taken[4] = {0, 0, 0, 0}, step, i;
  for (i = 0; i < FOREDRAW_PACKED_FIELDS; ++i) {
    uint32_t mask;
    if (field[i].bits == 0 && i > FOREDRAW_PACKED_Z) continue;
    if (field[i].bits < least_bits[i] || field[i].bits > most_bits[i]) return 0;
    if (field[i].word > 3 || field[i].shift > 32 - field[i].bits) return 0;
    mask = foredraw_packed_most(field[i].bits) << field[i].shift;
    if ((taken[field[i].word] & mask) != 0) return 0;
    taken[field[i].word] |= mask;
  }
  if (field[FOREDRAW_PACKED_NORMAL_0].bits != field[FOREDRAW_PACKED_NORMAL_1].bits) return 0;
  if ((field[FOREDRAW_PACKED_TANGENT].bits != 0) != (field[FOREDRAW_PACKED_SIGN].bits != 0)) return 0;
  if (field[FOREDRAW_PACKED_TANGENT].bits != 0 && field[FOREDRAW_PACKED_NORMAL_0].bits == 0) return 0;
  if ((field[FOREDRAW_PACKED_U].bits != 0) != (field[FOREDRAW_PACKED_V].bits != 0)) return 0;
  for (i = 0; i < 3; ++i) {
    if (!foredraw_packed_is_within(layout->origin[i], field[FOREDRAW_PACKED_X + i].bits)) return 0;
  }
  memcpy(&step, &layout->step, sizeof step);
  if ((step & 0x7fffffu) != 0 || step < (27u << 23) || step > (227u << 23)) return 0;
  for (i = 0; i < 2 && field[FOREDRAW_PACKED_U].bits != 0; ++i) {
    if (!foredraw_packed_is_within(layout->uv_origin[i], field[FOREDRAW_PACKED_U + i].bits)) return 0;
    if (!(layout->uv_step[i] >= 1e-30f && layout->uv_step[i] <= 1e30f)) return 0;
  }
  return layout->is_spherical <= 1;
}

#endif
