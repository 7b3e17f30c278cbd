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
  OFFSET(foredraw_draw, cluster_count);
  OFFSET(foredraw_draw, cluster_offsets);
  SIZE(foredraw_value);
  OFFSET(foredraw_value, integer);
  OFFSET(foredraw_value, number);
  OFFSET(foredraw_value, text);
  SIZE(foredraw_option);
  OFFSET(foredraw_option, name);
  OFFSET(foredraw_option, doc);
  OFFSET(foredraw_option, unit);
  OFFSET(foredraw_option, type);
  OFFSET(foredraw_option, choice_count);
  OFFSET(foredraw_option, choices);
  OFFSET(foredraw_option, initial);
  OFFSET(foredraw_option, least);
  OFFSET(foredraw_option, most);
  SIZE(foredraw_metric);
  OFFSET(foredraw_metric, name);
  OFFSET(foredraw_metric, unit);
  OFFSET(foredraw_metric, doc);
  OFFSET(foredraw_metric, higher_is_better);
  SIZE(foredraw_answer);
  OFFSET(foredraw_answer, values);
  OFFSET(foredraw_answer, count);
  SIZE(foredraw_host);
  OFFSET(foredraw_host, size);
  OFFSET(foredraw_host, reserved);
  OFFSET(foredraw_host, seed);
  OFFSET(foredraw_host, self);
  OFFSET(foredraw_host, cancelled);
  OFFSET(foredraw_host, keep);
  OFFSET(foredraw_host, fail);
  OFFSET(foredraw_host, note);
  OFFSET(foredraw_host, count);
  OFFSET(foredraw_host, measure);
  SIZE(foredraw_plugin);
  OFFSET(foredraw_plugin, size);
  OFFSET(foredraw_plugin, kind);
  OFFSET(foredraw_plugin, name);
  OFFSET(foredraw_plugin, summary);
  OFFSET(foredraw_plugin, reference);
  OFFSET(foredraw_plugin, needs);
  OFFSET(foredraw_plugin, provides);
  OFFSET(foredraw_plugin, breaks);
  OFFSET(foredraw_plugin, options);
  OFFSET(foredraw_plugin, metrics);
  OFFSET(foredraw_plugin, option_count);
  OFFSET(foredraw_plugin, metric_count);
  OFFSET(foredraw_plugin, runs_on_many_threads);
  OFFSET(foredraw_plugin, user);
  OFFSET(foredraw_plugin, run);
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
  VALUE(FOREDRAW_TRIANGLE_ORDERER);
  VALUE(FOREDRAW_VERTEX_ORDERER);
  VALUE(FOREDRAW_CLUSTERER);
  VALUE(FOREDRAW_EVALUATOR);
  VALUE(FOREDRAW_BOOLEAN);
  VALUE(FOREDRAW_INTEGER);
  VALUE(FOREDRAW_NUMBER);
  VALUE(FOREDRAW_TEXT);
  VALUE(FOREDRAW_CHOICE);
  return 0;
}
