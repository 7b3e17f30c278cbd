/* Prints what a C compiler makes of the headers: sizes and offsets of structs, values of enums. */
#include <foredraw/c/foredraw.h>
#include <foredraw/c/functions.h>

#include <stddef.h>
#include <stdio.h>

#define SIZE(type) printf(#type " %zu\n", sizeof(type))
#define OFFSET(type, member) printf(#type "." #member " %zu\n", offsetof(type, member))
#define VALUE(name) printf(#name " %d\n", name)

int main(void) {
  SIZE(foredraw_triangles);
  OFFSET(foredraw_triangles, indices);
  OFFSET(foredraw_triangles, index_count);
  OFFSET(foredraw_triangles, index_bytes);
  OFFSET(foredraw_triangles, vertex_count);
  SIZE(foredraw_positions);
  OFFSET(foredraw_positions, first);
  OFFSET(foredraw_positions, stride);
  SIZE(foredraw_vertex_cache_figures);
  OFFSET(foredraw_vertex_cache_figures, misses);
  OFFSET(foredraw_vertex_cache_figures, vertices);
  OFFSET(foredraw_vertex_cache_figures, acmr);
  OFFSET(foredraw_vertex_cache_figures, atvr);
  SIZE(foredraw_text);
  OFFSET(foredraw_text, data);
  OFFSET(foredraw_text, length);
  SIZE(foredraw_settings);
  OFFSET(foredraw_settings, size);
  OFFSET(foredraw_settings, threads);
  OFFSET(foredraw_settings, progress);
  OFFSET(foredraw_settings, user);
  SIZE(foredraw_stream);
  OFFSET(foredraw_stream, semantic);
  OFFSET(foredraw_stream, bytes);
  OFFSET(foredraw_stream, stride);
  OFFSET(foredraw_stream, component);
  OFFSET(foredraw_stream, components);
  OFFSET(foredraw_stream, normalized);
  SIZE(foredraw_draw);
  OFFSET(foredraw_draw, size);
  OFFSET(foredraw_draw, vertex_count);
  OFFSET(foredraw_draw, triangle_count);
  OFFSET(foredraw_draw, name);
  OFFSET(foredraw_draw, indices);
  OFFSET(foredraw_draw, positions);
  OFFSET(foredraw_draw, stream_count);
  OFFSET(foredraw_draw, streams);
  VALUE(FOREDRAW_DONE);
  VALUE(FOREDRAW_MISTAKE);
  VALUE(FOREDRAW_FAILED);
  VALUE(FOREDRAW_CANCELLED);
  VALUE(FOREDRAW_NO_MEMORY);
  VALUE(FOREDRAW_NULL_POINTER);
  VALUE(FOREDRAW_INDEX_COUNT);
  VALUE(FOREDRAW_INDEX_BYTES);
  VALUE(FOREDRAW_INDEX_RANGE);
  VALUE(FOREDRAW_TOO_LARGE);
  VALUE(FOREDRAW_OPTION_RANGE);
  VALUE(FOREDRAW_NO_CLUSTERS);
  VALUE(FOREDRAW_NO_ORDER);
  VALUE(FOREDRAW_LOOKAHEAD_FAST);
  VALUE(FOREDRAW_LOOKAHEAD_BALANCED);
  VALUE(FOREDRAW_LOOKAHEAD_HIGH);
  VALUE(FOREDRAW_LOOKAHEAD_ROBUST);
  VALUE(FOREDRAW_LOOKAHEAD_FIFO);
  VALUE(FOREDRAW_LOOKAHEAD_NVIDIA);
  VALUE(FOREDRAW_LOOKAHEAD_AMD);
  VALUE(FOREDRAW_LOOKAHEAD_INTEL);
  VALUE(FOREDRAW_INT8);
  VALUE(FOREDRAW_UINT8);
  VALUE(FOREDRAW_INT16);
  VALUE(FOREDRAW_UINT16);
  VALUE(FOREDRAW_UINT32);
  VALUE(FOREDRAW_FLOAT32);
  return 0;
}
