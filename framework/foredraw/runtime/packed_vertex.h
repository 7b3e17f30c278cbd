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

#include <foredraw/runtime/packed_layout.h>
#include <foredraw/runtime/packed_normal.h>

/* What a row could not hold as it was: bits of what foredraw_packed_encode() answers with. */
#define FOREDRAW_PACKED_POSITION_OUTSIDE 1u /* clamped to the lattice */
#define FOREDRAW_PACKED_UV_OUTSIDE 2u       /* clamped to the lattice */
#define FOREDRAW_PACKED_NO_NORMAL 4u        /* it has no direction, and is +z now */
#define FOREDRAW_PACKED_NO_TANGENT 8u       /* it has no direction about the normal, and is any now */

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

static inline uint32_t foredraw_packed_read(const foredraw_packed_layout* layout, uint32_t which, const uint32_t* row) {
  const foredraw_packed_field field = layout->field[which];
  return row[field.word] >> field.shift & foredraw_packed_most(field.bits);
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
