/* A vertex in 128 bits: position, normal, tangent with its sign, and texture coordinates. Packed and unpacked by a
 * layout that the stage vertex-pack chooses. C99, no state, no allocation, no library.
 *
 *   foredraw_packed_decode(&layout, rows + 4 * v, &vertex);
 *   told = foredraw_packed_encode(&layout, &vertex, rows + 4 * v);             0: all of it lies within the layout
 *
 * Nothing but additions, multiplications, comparisons and whole numbers decides a bit, so shaders get the same ones
 * where they do not fuse multiplications with additions ("precise"), and so does C (-ffp-contract=off). Positions are
 * the same even if they do: they lie on a lattice whose step is a power of two, and whose coordinates floats hold.
 * Functions take layouts for which foredraw_packed_is_layout() holds, and any bits as rows.
 *
 * The idea: N. Tatarchuk, J. Barczak, B. Purnomo: tessellated crowds, AMD 2008. Normals as points of an octahedron, the
 * best of four neighbours: Z. Cigolle and others, A Survey of Efficient Representations for Independent Unit Vectors,
 * JCGT 2014. */
#ifndef FOREDRAW_RUNTIME_PACKED_VERTEX_H
#define FOREDRAW_RUNTIME_PACKED_VERTEX_H

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

/* What a row could not hold as it was: bits of what foredraw_packed_encode() answers with. */
#define FOREDRAW_PACKED_POSITION_OUTSIDE 1u /* clamped to the lattice */
#define FOREDRAW_PACKED_UV_OUTSIDE 2u       /* clamped to the lattice */
#define FOREDRAW_PACKED_NO_NORMAL 4u        /* it has no direction, and is +z now */
#define FOREDRAW_PACKED_NO_TANGENT 8u       /* it has no direction about the normal, and is any now */

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

/* What the rows do not have is 0. */
typedef struct foredraw_packed_vertex {
  float position[3];
  float normal[3];  /* of length 1 */
  float tangent[4]; /* of length 1, at a right angle to the normal; and 1 or -1 */
  float uv[2];
} foredraw_packed_vertex;

/* Which layout a draw has, in tables that foredraw makes. */
typedef struct foredraw_packed_draw {
  const char* name;
  const foredraw_packed_layout* stored; /* of its rows in the file: vertices as they are stored */
  const foredraw_packed_layout* posed;  /* for skinned or morphed vertices, in world space; null: nothing moves them */
} foredraw_packed_draw;

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

static inline uint32_t foredraw_packed_read(const foredraw_packed_layout* layout, uint32_t which, const uint32_t* row) {
  const foredraw_packed_field field = layout->field[which];
  return row[field.word] >> field.shift & foredraw_packed_most(field.bits);
}

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

/* Tangents lie in the plane of the decoded normal (p, q, r), where r is the larger one of its x and z, between the two
 * directions (0, -r, q) and (q^2 + r^2, -p q, -p r), which are of one length, at right angles: at a diamond's angle. */
static inline void foredraw_packed_decode_tangent(const float normal[3], uint32_t code, uint32_t bits,
                                                  float tangent[3]) {
  const int32_t quarter = 1 << (bits - 2);
  const int32_t along = foredraw_packed_wave(code, quarter);
  const int32_t across = foredraw_packed_wave(code - (uint32_t)quarter, quarter);
  const int is_x = foredraw_packed_absf(normal[0]) > foredraw_packed_absf(normal[2]);
  const float p = is_x ? normal[2] : normal[0], q = normal[1], r = is_x ? normal[0] : normal[2];
  const float squared = q * q + r * r;
  const float per_length = foredraw_packed_rsqrt((float)(along * along + across * across) * squared);
  const float c = (float)along * per_length, s = (float)across * per_length;
  const float first = s * squared, last = c * q - s * (p * r);
  tangent[0] = is_x ? last : first;
  tangent[1] = 0.0f - c * r - s * (p * q);
  tangent[2] = is_x ? first : last;
}

static inline void foredraw_packed_decode(const foredraw_packed_layout* layout, const uint32_t row[4],
                                          foredraw_packed_vertex* vertex) {
  const foredraw_packed_field* field = layout->field;
  uint32_t i;
  memset(vertex, 0, sizeof *vertex);
  for (i = 0; i < 3; ++i) {
    const uint32_t code = foredraw_packed_read(layout, FOREDRAW_PACKED_X + i, row);
    vertex->position[i] = (float)((int32_t)code + layout->origin[i]) * layout->step;
  }
  for (i = 0; i < 2 && field[FOREDRAW_PACKED_U].bits != 0; ++i) {
    const uint32_t code = foredraw_packed_read(layout, FOREDRAW_PACKED_U + i, row);
    vertex->uv[i] = (float)((int32_t)code + layout->uv_origin[i]) * layout->uv_step[i];
  }
  if (field[FOREDRAW_PACKED_NORMAL_0].bits == 0) return;
  foredraw_packed_decode_normal(layout, foredraw_packed_read(layout, FOREDRAW_PACKED_NORMAL_0, row),
                                foredraw_packed_read(layout, FOREDRAW_PACKED_NORMAL_1, row), vertex->normal);
  if (field[FOREDRAW_PACKED_TANGENT].bits == 0) return;
  foredraw_packed_decode_tangent(vertex->normal, foredraw_packed_read(layout, FOREDRAW_PACKED_TANGENT, row),
                                 field[FOREDRAW_PACKED_TANGENT].bits, vertex->tangent);
  vertex->tangent[3] = foredraw_packed_read(layout, FOREDRAW_PACKED_SIGN, row) != 0 ? -1.0f : 1.0f;
}

/* The nearest whole number, of two the even one. */
static inline int32_t foredraw_packed_nearest(float x) {
  const int32_t whole = (int32_t)x;
  const float rest = x - (float)whole;
  const int is_odd = whole & 1;
  if (rest > 0.5f || (rest == 0.5f && is_odd)) return whole + 1;
  return rest < -0.5f || (rest == -0.5f && is_odd) ? whole - 1 : whole;
}

/* Sets *is_outside where the lattice does not reach the value. */
static inline uint32_t foredraw_packed_code(float value, float step, int32_t origin, uint32_t bits, int* is_outside) {
  const int32_t most = (int32_t)foredraw_packed_most(bits);
  float at = value * (1.0f / step);
  int32_t code;
  if (!(at >= -33554432.0f)) at = -33554432.0f;
  if (at > 33554432.0f) at = 33554432.0f;
  code = foredraw_packed_nearest(at) - origin;
  if (code < 0 || code > most) *is_outside = 1;
  return (uint32_t)(code < 0 ? 0 : code > most ? most : code);
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

/* Sets *is_none where the tangent has no direction, or that of the normal. */
static inline uint32_t foredraw_packed_encode_tangent(const float normal[3], const float tangent[3], uint32_t bits,
                                                      int* is_none) {
  const float quarter = (float)(1 << (bits - 2));
  const int is_x = foredraw_packed_absf(normal[0]) > foredraw_packed_absf(normal[2]);
  const float p = is_x ? normal[2] : normal[0], q = normal[1], r = is_x ? normal[0] : normal[2];
  const float first = is_x ? tangent[2] : tangent[0], last = is_x ? tangent[0] : tangent[2];
  const float c = last * q - tangent[1] * r;
  const float s = first * (q * q + r * r) - (tangent[1] * (p * q) + last * (p * r));
  const float along = foredraw_packed_absf(c), across = foredraw_packed_absf(s), sum = along + across;
  const float squared = first * first + tangent[1] * tangent[1] + last * last;
  float part;
  if (!(squared > 1e-36f && squared < 1e36f && sum * sum > squared * 1e-10f)) {
    *is_none = 1;
    return 0;
  }
  part = across * foredraw_packed_reciprocal(sum);
  if (c < 0.0f) part = 2.0f - part;
  if (s < 0.0f) part = 4.0f - part;
  return (uint32_t)foredraw_packed_nearest(part * quarter) & foredraw_packed_most(bits);
}

static inline void foredraw_packed_write(const foredraw_packed_layout* layout, uint32_t which, uint32_t code,
                                         uint32_t* row) {
  row[layout->field[which].word] |= code << layout->field[which].shift;
}

/* Answers with what the row does not hold as it was, 0 where it holds all: FOREDRAW_PACKED_*. Normals and tangents may
 * be of any length from 1e-18 to 1e18. */
static inline uint32_t foredraw_packed_encode(const foredraw_packed_layout* layout,
                                              const foredraw_packed_vertex* vertex, uint32_t row[4]) {
  const foredraw_packed_field* field = layout->field;
  uint32_t told = 0, i;
  int is_outside = 0;
  row[0] = row[1] = row[2] = row[3] = 0;
  for (i = 0; i < 3; ++i) {
    foredraw_packed_write(layout, FOREDRAW_PACKED_X + i,
                          foredraw_packed_code(vertex->position[i], layout->step, layout->origin[i],
                                               field[FOREDRAW_PACKED_X + i].bits, &is_outside),
                          row);
  }
  if (is_outside) told |= FOREDRAW_PACKED_POSITION_OUTSIDE;
  is_outside = 0;
  for (i = 0; i < 2 && field[FOREDRAW_PACKED_U].bits != 0; ++i) {
    foredraw_packed_write(layout, FOREDRAW_PACKED_U + i,
                          foredraw_packed_code(vertex->uv[i], layout->uv_step[i], layout->uv_origin[i],
                                               field[FOREDRAW_PACKED_U + i].bits, &is_outside),
                          row);
  }
  if (is_outside) told |= FOREDRAW_PACKED_UV_OUTSIDE;
  if (field[FOREDRAW_PACKED_NORMAL_0].bits != 0) {
    float unit[3], normal[3] = {0, 0, 1};
    uint32_t code[2] = {0, 0};
    if (!foredraw_packed_unit(vertex->normal, unit)) told |= FOREDRAW_PACKED_NO_NORMAL;
    foredraw_packed_encode_normal(layout, unit, code, normal);
    foredraw_packed_write(layout, FOREDRAW_PACKED_NORMAL_0, code[0], row);
    foredraw_packed_write(layout, FOREDRAW_PACKED_NORMAL_1, code[1], row);
    if (field[FOREDRAW_PACKED_TANGENT].bits != 0) {
      int is_none = 0;
      foredraw_packed_write(
          layout, FOREDRAW_PACKED_TANGENT,
          foredraw_packed_encode_tangent(normal, vertex->tangent, field[FOREDRAW_PACKED_TANGENT].bits, &is_none), row);
      foredraw_packed_write(layout, FOREDRAW_PACKED_SIGN, vertex->tangent[3] < 0.0f ? 1u : 0u, row);
      if (is_none) told |= FOREDRAW_PACKED_NO_TANGENT;
    }
  }
  return told;
}

#endif
