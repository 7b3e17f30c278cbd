/* What a vertex shader of a merged draw does, on the CPU: from the number of a vertex to its instance and its place in
 * the vertex buffer. C99, no allocation, no state; the plugin merge-instances writes the arrays.
 *
 *   for (number = 0; number < foredraw_merged_vertex_count(&draw); ++number) {
 *     const foredraw_merged_vertex at = foredraw_merged_vertex_at(&draw, number);
 *     shade(vertices[at.vertex], transforms + 12 * at.instance);
 *   }
 */
#ifndef FOREDRAW_RUNTIME_MERGE_INSTANCES_H
#define FOREDRAW_RUNTIME_MERGE_INSTANCES_H

#include <stddef.h>
#include <stdint.h>

/* One slot that is drawn: 8 bytes, as they are stored. */
typedef struct foredraw_merged_slot {
  uint32_t index_offset; /* of its first entry in the index buffer */
  uint32_t instance;     /* that it is drawn for */
} foredraw_merged_slot;

/* A draw, and the buffers it shares with others. Nothing is copied: the pointers must stay good. */
typedef struct foredraw_merged_draw {
  uint32_t frequency;  /* index entries of a slot: a multiple of 3, at least 3 */
  uint32_t first_slot; /* in `slots` */
  uint32_t slot_count; /* slot_count * frequency is below 2^32 */
  const foredraw_merged_slot* slots;
  const uint32_t* indices;
} foredraw_merged_draw;

typedef struct foredraw_merged_vertex {
  uint32_t instance;
  uint32_t vertex;
} foredraw_merged_vertex;

/* How many vertices the draw call is given; a third of it are triangles. */
static inline uint32_t foredraw_merged_vertex_count(const foredraw_merged_draw* draw) {
  return draw->slot_count * draw->frequency;
}

/* The instance and the vertex of a vertex number below foredraw_merged_vertex_count(). */
static inline foredraw_merged_vertex foredraw_merged_vertex_at(const foredraw_merged_draw* draw, uint32_t number) {
  const uint32_t slot = number / draw->frequency;
  const foredraw_merged_slot record = draw->slots[(size_t)draw->first_slot + slot];
  foredraw_merged_vertex at;
  at.instance = record.instance;
  at.vertex = draw->indices[(size_t)record.index_offset + (number - slot * draw->frequency)];
  return at;
}

/* Whether a triangle of the draw only fills its slot: all its corners are one vertex, so that it draws nothing. The
 * same is true of triangles of a mesh that are a point; those are drawn as little. */
static inline int foredraw_merged_is_padding(const foredraw_merged_draw* draw, uint32_t triangle) {
  const uint32_t a = foredraw_merged_vertex_at(draw, 3 * triangle).vertex;
  const uint32_t b = foredraw_merged_vertex_at(draw, 3 * triangle + 1).vertex;
  const uint32_t c = foredraw_merged_vertex_at(draw, 3 * triangle + 2).vertex;
  return a == b && b == c;
}

/* A position brought into the world by an instance's transform: three rows of four. */
static inline void foredraw_merged_to_world(const float transform[12], const float position[3], float world[3]) {
  int row;
  for (row = 0; row < 3; ++row) {
    const float* const from = transform + 4 * row;
    world[row] = from[0] * position[0] + from[1] * position[1] + from[2] * position[2] + from[3];
  }
}

/* Whether a transform turns meshes inside out. The triangles of such an instance are stored with the second and the
 * third corner exchanged, so that they face as they should: exchanged again, they are the mesh's own. */
static inline int foredraw_merged_is_mirrored(const float transform[12]) {
  const double x[3] = {transform[0], transform[4], transform[8]};
  const double y[3] = {transform[1], transform[5], transform[9]};
  const double z[3] = {transform[2], transform[6], transform[10]};
  return x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) + x[2] * (y[0] * z[1] - y[1] * z[0]) <
         0;
}

#endif
