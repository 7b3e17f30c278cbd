/* Draws as they cross the border to C: those that callers make scenes of, and those that they are shown. */
#ifndef FOREDRAW_C_DRAW_H
#define FOREDRAW_C_DRAW_H

#include <stdint.h>

enum { FOREDRAW_INT8 = 1, FOREDRAW_UINT8, FOREDRAW_INT16, FOREDRAW_UINT16, FOREDRAW_UINT32, FOREDRAW_FLOAT32 };

/* A vertex attribute, as it is stored. */
typedef struct foredraw_stream {
  const char* semantic; /* glTF's word: "NORMAL", "TEXCOORD_0", "_MINE" */
  const void* bytes;    /* of vertex 0 */
  uint32_t stride;      /* bytes from one vertex to the next; 0: none between them */
  uint32_t component;   /* FOREDRAW_FLOAT32 and so on */
  uint32_t components;  /* 1 to 16 */
  uint32_t normalized;  /* 1: integers mean 0 to 1, or -1 to 1 */
} foredraw_stream;

/* Triangles that are drawn at once. */
typedef struct foredraw_draw {
  uint32_t size; /* sizeof(foredraw_draw) */
  uint32_t vertex_count;
  uint64_t triangle_count;
  const char* name;        /* may be NULL */
  const uint32_t* indices; /* three a triangle, each below vertex_count */
  const float* positions;  /* three a vertex */
  uint32_t stream_count;
  const foredraw_stream* streams;  /* besides positions */
  uint32_t cluster_count;          /* 0: there are none */
  const uint32_t* cluster_offsets; /* cluster c holds the triangles [c] to [c + 1] - 1; cluster_count + 1 numbers */
} foredraw_draw;

#endif
