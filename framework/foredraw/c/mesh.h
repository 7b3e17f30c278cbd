/* Meshes as the functions for C take them: arrays of the caller's, as an engine has them. */
#ifndef FOREDRAW_C_MESH_H
#define FOREDRAW_C_MESH_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A triangle list. Triangles may be degenerate, equal or non-manifold. */
typedef struct foredraw_triangles {
  const void* indices;   /* three a triangle, at any alignment; may be NULL where there are none */
  uint64_t index_count;  /* a multiple of three */
  uint32_t index_bytes;  /* of each index: 1, 2 or 4 */
  uint32_t vertex_count; /* each index is below it */
} foredraw_triangles;

/* Positions of vertices, within an interleaved buffer if need be. They may be infinite or no numbers. */
typedef struct foredraw_positions {
  const void* first; /* x, y and z of vertex 0, 32-bit floats at any alignment */
  uint32_t stride;   /* bytes from one vertex to the next; 0: 12 */
} foredraw_positions;

/* An attribute of vertices, within an interleaved buffer if need be. */
typedef struct foredraw_attribute {
  const void* first; /* of vertex 0, at any alignment */
  uint32_t stride;   /* bytes from one vertex to the next; 0: none between them */
  uint32_t bytes;    /* of each vertex, 1 to 65535 */
} foredraw_attribute;

#ifdef __cplusplus
}
#endif

#endif
