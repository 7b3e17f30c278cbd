/* The vertices of a cage, whose triangles a tessellator divides, as a pose has them. C, C++ and shaders compute
 * them alike, to the bit wherever products and sums are rounded to the nearest. C99, no allocation, no state.
 *
 * N. Tatarchuk, J. Barczak, B. Purnomo: Real-Time Tessellation on GPU, SIGGRAPH 2008: the cage of each instance is
 * posed once, into a buffer, and all passes that draw it read it from there by the vertex's number and the instance's.
 *
 *   map = foredraw_cage_blended(&maps[joints * instance], skin[v].joint, skin[v].weight);
 *   cage[vertices * instance + v] = foredraw_cage_posed(&rest[v], &map);
 *
 * Of rigid draws the map is maps[instance].
 *
 * Vertices at one position stay together in every pose if their positions, directions, joints and weights are equal in
 * every bit. */
#ifndef FOREDRAW_RUNTIME_DISPLACED_CAGE_H
#define FOREDRAW_RUNTIME_DISPLACED_CAGE_H

#include <stdint.h>

/* As it lies in buffers: 32 bytes, at rest and posed alike. */
typedef struct foredraw_cage_vertex {
  float position[3];
  int32_t x;          /* foredraw_height_place() along u */
  float direction[3]; /* along which the surface moves: of length 1 at rest */
  int32_t y;          /* the same along v */
} foredraw_cage_vertex;

/* 32 bytes. */
typedef struct foredraw_cage_skin {
  uint32_t joint[4]; /* below the number of maps that an instance has */
  float weight[4];   /* together 1 */
} foredraw_cage_skin;

/* Where a joint or node puts a point at rest: three rows of four. 48 bytes. */
typedef struct foredraw_cage_map {
  float row[3][4];
} foredraw_cage_map;

static inline foredraw_cage_map foredraw_cage_blended(const foredraw_cage_map* maps, const uint32_t joint[4],
                                                      const float weight[4]) {
  foredraw_cage_map blended;
  int r, c;
  for (r = 0; r < 3; ++r) {
    for (c = 0; c < 4; ++c) {
      const float p = weight[0] * maps[joint[0]].row[r][c], q = weight[1] * maps[joint[1]].row[r][c];
      const float s = weight[2] * maps[joint[2]].row[r][c], t = weight[3] * maps[joint[3]].row[r][c];
      blended.row[r][c] = ((p + q) + s) + t;
    }
  }
  return blended;
}

/* A direction is turned and scaled as positions are: its length then says by how much the pose scales there. */
static inline foredraw_cage_vertex foredraw_cage_posed(const foredraw_cage_vertex* rest, const foredraw_cage_map* map) {
  foredraw_cage_vertex posed = *rest;
  const float *p = rest->position, *d = rest->direction;
  int r;
  for (r = 0; r < 3; ++r) {
    const float* row = map->row[r];
    const float px = row[0] * p[0], py = row[1] * p[1], pz = row[2] * p[2];
    const float dx = row[0] * d[0], dy = row[1] * d[1], dz = row[2] * d[2];
    posed.position[r] = ((px + py) + pz) + row[3];
    posed.direction[r] = (dx + dy) + dz;
  }
  return posed;
}

#endif
