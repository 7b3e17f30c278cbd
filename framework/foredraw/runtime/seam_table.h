/* Heights along the seams of a displacement map's layout, stored apart: what both sides of a seam read instead of the
 * map, each at its own place. They are equal at every tessellation factor and spacing. C99, no allocation, no state.
 *
 * On an edge of a patch one barycentric coordinate is 0. If it lies on a seam, its height comes from the table, and at
 * its ends from the map, whose corners are equal once displacement-seams has repaired it:
 *
 *   foredraw_height_weights(tess_coord, w);
 *   h = foredraw_seamed_height(&map, &table, sides, side_count, triangle, x, y, w, 14);
 */
#ifndef FOREDRAW_RUNTIME_SEAM_TABLE_H
#define FOREDRAW_RUNTIME_SEAM_TABLE_H

#include <foredraw/runtime/displaced_height.h>

#include <stddef.h>
#include <stdint.h>

/* Edge e has 2^parts_log2[e] parts, and from firsts[e] on the heights between them, without its ends. */
typedef struct foredraw_seam_table {
  const uint16_t* heights;
  size_t height_count;
  const uint32_t* firsts;    /* [edge] */
  const uint8_t* parts_log2; /* [edge] 0 to 6 */
  uint32_t edge_count;
} foredraw_seam_table;

/* That a triangle's edge is an edge of the table. */
typedef struct foredraw_seam_side {
  uint32_t side; /* 3 * triangle + corner */
  uint32_t edge; /* twice its number, and 1 more where the triangle runs along it from its end to its beginning */
} foredraw_seam_side;

/* Whether all that foredraw_seam_height() may read is there. Ask once, of a table from a file. */
static inline int foredraw_seam_table_is_sound(const foredraw_seam_table* table) {
  uint32_t e;
  for (e = 0; e < table->edge_count; ++e) {
    if (table->parts_log2[e] > 6) return 0;
    if ((uint64_t)table->firsts[e] + ((uint64_t)1 << table->parts_log2[e]) > (uint64_t)table->height_count + 1)
      return 0;
  }
  return 1;
}

/* Among sides that rise by number; NULL: the edge lies on no seam. */
static inline const foredraw_seam_side* foredraw_seam_side_of(const foredraw_seam_side* sides, size_t count,
                                                              uint32_t side) {
  size_t from = 0;
  while (count > 0) {
    const size_t half = count / 2;
    if (sides[from + half].side < side) {
      from += half + 1;
      count -= half + 1;
    } else if (sides[from + half].side == side) {
      return &sides[from + half];
    } else {
      count = half;
    }
  }
  return NULL;
}

/* Number `i` of the heights from end to end, in `bits` bits. */
static inline uint32_t foredraw_seam_height_of(const foredraw_seam_table* table, uint32_t edge, const uint32_t ends[2],
                                               uint32_t i, uint32_t bits) {
  if (i == 0) return ends[0];
  if (i >= (uint32_t)1 << table->parts_log2[edge]) return ends[1];
  return (uint32_t)table->heights[table->firsts[edge] + i - 1] >> (16 - bits);
}

/* The height in `bits` bits (1 to 16, else 16) at a place: how far the edge's second corner weighs, in 1/65536, beyond
 * 65536 as there. `ends`: heights in as many bits at the edge's corners, as the triangle runs. 0 for an edge that is
 * not there. */
static inline uint32_t foredraw_seam_height(const foredraw_seam_table* table, const foredraw_seam_side* side,
                                            const uint32_t ends[2], uint32_t place, uint32_t bits) {
  const uint32_t edge = side->edge / 2, within = place < 65536u ? place : 65536u, used = bits - 1u < 16u ? bits : 16u;
  const int is_reversed = side->edge % 2 != 0;
  uint32_t along[2], at, part, first, second;
  if (edge >= table->edge_count) return 0;
  along[0] = ends[is_reversed ? 1 : 0];
  along[1] = ends[is_reversed ? 0 : 1];
  at = (is_reversed ? 65536u - within : within) << table->parts_log2[edge]; /* at most 2^22 */
  part = at & 65535u;
  first = foredraw_seam_height_of(table, edge, along, at >> 16, used);
  second = foredraw_seam_height_of(table, edge, along, (at >> 16) + 1, used);
  return (first * (65536u - part) + second * part) >> 16;
}

/* The height in `bits` bits (1 to 16) of a point of a triangle: on a seam by the table, and else by the map. `x` and
 * `y`: of the corners, foredraw_height_place(); `weight`: together 65536. Triangles with an edge in common get equal
 * heights along it if their corners' are equal. */
static inline uint32_t foredraw_seamed_height(const foredraw_height_map* map, const foredraw_seam_table* table,
                                              const foredraw_seam_side* sides, size_t side_count, uint32_t triangle,
                                              const int32_t x[3], const int32_t y[3], const uint32_t weight[3],
                                              uint32_t bits) {
  uint32_t c, ends[2];
  for (c = 0; c < 3; ++c) { /* the edge from corner c to the next one, which is across from the third */
    const uint32_t next = (c + 1) % 3;
    const foredraw_seam_side* side;
    if (weight[(c + 2) % 3] != 0) continue;
    side = foredraw_seam_side_of(sides, side_count, 3 * triangle + c);
    if (side == NULL) continue;
    ends[0] = foredraw_displaced_height(map, x[c], y[c], bits);
    ends[1] = foredraw_displaced_height(map, x[next], y[next], bits);
    return foredraw_seam_height(table, side, ends, weight[next], bits);
  }
  return foredraw_displaced_height(map, foredraw_height_between(x, weight), foredraw_height_between(y, weight), bits);
}

#endif
