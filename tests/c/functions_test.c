/* From a mesh of an engine's to one that is cheaper to draw, and all that is refused. */
#include <foredraw/c/functions.h>

#include "check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CELLS = 40, POINTS = CELLS + 1, VERTICES = POINTS * POINTS, TRIANGLES = 2 * CELLS * CELLS };

typedef struct vertex {
  uint32_t colour;
  float position[3];
} vertex;

static vertex vertices[VERTICES], moved[VERTICES];
static uint16_t indices[3 * TRIANGLES], ordered[3 * TRIANGLES], clustered[3 * TRIANGLES], numbered[3 * TRIANGLES];
static uint32_t order[TRIANGLES], offsets[TRIANGLES + 1], sequence[TRIANGLES], vertex_order[VERTICES];

static foredraw_triangles list_of(const uint16_t* of) {
  foredraw_triangles list;
  list.indices = of;
  list.index_count = 3 * TRIANGLES;
  list.index_bytes = sizeof *of;
  list.vertex_count = VERTICES;
  return list;
}

/* A sheet whose triangles come in a sequence that suits no cache. */
static void make_sheet(void) {
  uint32_t at = 0, i, j;
  for (i = 0; i < VERTICES; ++i) {
    const float x = (float)(i % POINTS), y = (float)(i / POINTS);
    vertices[i].colour = i;
    vertices[i].position[0] = x;
    vertices[i].position[1] = y;
    vertices[i].position[2] = x * y / (float)CELLS;
  }
  for (i = 0; i < TRIANGLES / 2; ++i) {
    const uint32_t cell = i * 619 % (CELLS * CELLS); /* 619 is prime, so that each comes once */
    const uint32_t a = cell / CELLS * POINTS + cell % CELLS;
    const uint32_t corners[6] = {a, a + 1, a + POINTS, a + POINTS, a + 1, a + POINTS + 1};
    for (j = 0; j < 6; ++j) indices[at++] = (uint16_t)corners[j];
  }
}

static void sheets_get_cheaper(void) {
  const foredraw_triangles before = list_of(indices), cached = list_of(ordered), drawn = list_of(clustered);
  const foredraw_triangles after = list_of(numbered);
  foredraw_positions positions;
  foredraw_vertex_cache_figures first, last;
  uint32_t clusters = 0, used = 0, i;
  positions.first = vertices[0].position;
  positions.stride = sizeof vertices[0];
  CHECK(foredraw_lookahead(order, &before, FOREDRAW_LOOKAHEAD_BALANCED, FOREDRAW_LOOKAHEAD_ROBUST, 0) == FOREDRAW_DONE);
  CHECK(foredraw_reorder_triangles(ordered, &before, order) == FOREDRAW_DONE);
  CHECK(foredraw_linear_clusters(offsets, &clusters, &cached, 16, 1.05) == FOREDRAW_DONE);
  CHECK(foredraw_dot_rule(sequence, &cached, &positions, offsets, clusters) == FOREDRAW_DONE);
  CHECK(foredraw_order_of_clusters(order, offsets, clusters, sequence) == FOREDRAW_DONE);
  CHECK(foredraw_reorder_triangles(clustered, &cached, order) == FOREDRAW_DONE);
  CHECK(foredraw_vertex_fetch(vertex_order, &used, &drawn) == FOREDRAW_DONE);
  CHECK(foredraw_renumber_vertices(numbered, &drawn, vertex_order) == FOREDRAW_DONE);
  CHECK(foredraw_reorder_elements(moved, vertices, VERTICES, sizeof vertices[0], vertex_order, used) == FOREDRAW_DONE);
  CHECK(clusters > 1 && offsets[0] == 0 && offsets[clusters] == TRIANGLES);
  CHECK(used == VERTICES);
  for (i = 0; i < 3 * TRIANGLES; ++i) CHECK(moved[numbered[i]].colour == clustered[i]);
  CHECK(foredraw_vertex_cache(&first, &before, 16) == FOREDRAW_DONE);
  CHECK(foredraw_vertex_cache(&last, &after, 16) == FOREDRAW_DONE);
  CHECK(first.vertices == VERTICES && last.vertices == VERTICES);
  CHECK(first.acmr > 1.5 && last.acmr < .75);
  CHECK(last.atvr >= 1 && last.atvr < 1.5);
}

static void levels_are_cut_out_of_a_sequence(void) {
  static uint16_t half[3 * TRIANGLES], near_to_it[3 * TRIANGLES];
  static foredraw_collapse collapses[VERTICES];
  static foredraw_vertex_pair pairs[VERTICES];
  static uint32_t first_pair[VERTICES + 1];
  const foredraw_triangles mesh = list_of(indices);
  foredraw_collapses sequence;
  foredraw_simplified simplified, close;
  foredraw_positions positions;
  positions.first = vertices[0].position;
  positions.stride = sizeof vertices[0];
  memset(&sequence, 0, sizeof sequence);
  sequence.collapses = collapses;
  sequence.pairs = pairs;
  sequence.first_pair = first_pair;
  CHECK(foredraw_quadric_collapse(&sequence, &mesh, &positions, NULL, 0, 0) == FOREDRAW_DONE);
  CHECK(foredraw_simplify(half, NULL, &simplified, &mesh, &positions, &sequence, TRIANGLES / 2, HUGE_VAL) ==
        FOREDRAW_DONE);
  CHECK(foredraw_simplify(near_to_it, NULL, &close, &mesh, &positions, &sequence, 0, .01) == FOREDRAW_DONE);
  CHECK(simplified.index_count <= 3 * TRIANGLES / 2);
  CHECK(close.error < .011 && close.index_count < 3 * TRIANGLES);
}

static void levels_carry_what_their_vertices_do(void) {
  static float places[3 * VERTICES], places_then[3 * VERTICES], shades[VERTICES], shades_then[VERTICES];
  static uint16_t half[3 * TRIANGLES];
  static foredraw_collapse collapses[VERTICES];
  static foredraw_vertex_pair pairs[VERTICES];
  static uint32_t first_pair[VERTICES + 1];
  const foredraw_triangles mesh = list_of(indices);
  foredraw_weighted_attribute shade;
  foredraw_collapses sequence;
  foredraw_simplified level;
  foredraw_positions positions;
  uint32_t i;
  for (i = 0; i < VERTICES; ++i) shades[i] = vertices[i].position[0];
  positions.first = vertices[0].position;
  positions.stride = sizeof vertices[0];
  shade.first = shades;
  shade.stride = 0;
  shade.components = 1;
  shade.weight = .1;
  memset(&sequence, 0, sizeof sequence);
  sequence.collapses = collapses;
  sequence.pairs = pairs;
  sequence.first_pair = first_pair;
  sequence.places = places;
  sequence.solves = 1;
  CHECK(foredraw_quadric_collapse(&sequence, &mesh, &positions, &shade, 1, 0) == FOREDRAW_DONE);
  CHECK(foredraw_simplify(half, places_then, &level, &mesh, &positions, &sequence, TRIANGLES / 2, HUGE_VAL) ==
        FOREDRAW_DONE);
  CHECK(foredraw_level_attributes(shades_then, &mesh, &positions, &sequence, level.collapses, &shade, 1) ==
        FOREDRAW_DONE);
  for (i = 0; i < level.index_count; ++i) CHECK(fabsf(shades_then[half[i]] - places_then[3 * half[i]]) < .1f);
}

static void what_is_wrong_is_refused(void) {
  const foredraw_triangles good = list_of(indices);
  foredraw_triangles bad = good;
  foredraw_positions positions;
  foredraw_vertex_cache_figures figures;
  uint32_t clusters = 0;
  positions.first = vertices[0].position;
  positions.stride = sizeof vertices[0];
  memset(order, 7, sizeof order);
  CHECK(foredraw_tipsify(order, NULL, 16) == FOREDRAW_NULL_POINTER);
  CHECK(foredraw_tipsify(NULL, &good, 16) == FOREDRAW_NULL_POINTER);
  bad.indices = NULL;
  CHECK(foredraw_forsyth(order, &bad, 16) == FOREDRAW_NULL_POINTER);
  bad = good;
  bad.index_count = 4;
  CHECK(foredraw_lookahead(order, &bad, 0, 0, 0) == FOREDRAW_INDEX_COUNT);
  bad = good;
  bad.index_bytes = 3;
  CHECK(foredraw_vertex_cache(&figures, &bad, 0) == FOREDRAW_INDEX_BYTES);
  bad = good;
  bad.vertex_count = VERTICES - 1;
  CHECK(foredraw_vertex_fetch(vertex_order, NULL, &bad) == FOREDRAW_INDEX_RANGE);
  bad = good;
  bad.index_count = UINT64_C(0xFFFFFFFFFFFFFFFF) / 3 * 3;
  CHECK(foredraw_tipsify(order, &bad, 0) == FOREDRAW_TOO_LARGE);

  CHECK(foredraw_tipsify(order, &good, 2) == FOREDRAW_OPTION_RANGE);
  CHECK(foredraw_forsyth(order, &good, 65) == FOREDRAW_OPTION_RANGE);
  CHECK(foredraw_lookahead(order, &good, -1, 0, 0) == FOREDRAW_OPTION_RANGE);
  CHECK(foredraw_lookahead(order, &good, 4, 0, 0) == FOREDRAW_OPTION_RANGE);
  CHECK(foredraw_lookahead(order, &good, 0, 6, 0) == FOREDRAW_OPTION_RANGE);
  CHECK(foredraw_lookahead(order, &good, 0, 0, 257) == FOREDRAW_OPTION_RANGE);
  CHECK(foredraw_vertex_cache(&figures, &good, 65536) == FOREDRAW_OPTION_RANGE);
  CHECK(foredraw_linear_clusters(offsets, &clusters, &good, 16, .5) == FOREDRAW_OPTION_RANGE);
  CHECK(foredraw_linear_clusters(offsets, NULL, &good, 16, 0) == FOREDRAW_NULL_POINTER);
  CHECK(order[0] == 0x07070707 && order[TRIANGLES - 1] == 0x07070707); /* what is refused writes nothing */

  offsets[0] = 0, offsets[1] = 10, offsets[2] = 10, offsets[3] = TRIANGLES;
  CHECK(foredraw_dot_rule(sequence, &good, &positions, offsets, 3) == FOREDRAW_NO_CLUSTERS);
  offsets[2] = 11, offsets[3] = TRIANGLES - 1;
  CHECK(foredraw_dot_rule(sequence, &good, &positions, offsets, 3) == FOREDRAW_NO_CLUSTERS);
  offsets[3] = TRIANGLES;
  CHECK(foredraw_dot_rule(sequence, &good, NULL, offsets, 3) == FOREDRAW_NULL_POINTER);
  CHECK(foredraw_dot_rule(sequence, &good, &positions, NULL, 3) == FOREDRAW_NULL_POINTER);
  CHECK(foredraw_dot_rule(sequence, &good, &positions, offsets, 0) == FOREDRAW_NO_CLUSTERS);
  CHECK(foredraw_dot_rule(sequence, &good, &positions, offsets, 3) == FOREDRAW_DONE);
  offsets[0] = 1;
  CHECK(foredraw_order_of_clusters(order, offsets, 3, sequence) == FOREDRAW_NO_CLUSTERS);
  offsets[0] = 0;
  sequence[0] = sequence[1];
  CHECK(foredraw_order_of_clusters(order, offsets, 3, sequence) == FOREDRAW_NO_ORDER);

  memset(order, 0, sizeof order);
  CHECK(foredraw_reorder_triangles(ordered, &good, order) == FOREDRAW_NO_ORDER);
  CHECK(foredraw_reorder_triangles(ordered, &good, NULL) == FOREDRAW_NULL_POINTER);
  CHECK(foredraw_renumber_vertices(ordered, &good, order) == FOREDRAW_NO_ORDER);
  CHECK(foredraw_reorder_elements(ordered, indices, 2, 2, order, 2) == FOREDRAW_NO_ORDER);
  CHECK(foredraw_reorder_elements(ordered, indices, 2, 2, order, 3) == FOREDRAW_NO_ORDER);
  CHECK(foredraw_reorder_elements(ordered, NULL, 2, 2, order, 1) == FOREDRAW_NULL_POINTER);
  CHECK(foredraw_reorder_elements(ordered, indices, 2, 2, order, 1) == FOREDRAW_DONE);
}

/* 300 vertices, of which bytes can name 256: where an order would give one of those a higher number, nothing is
 * written. */
static void numbers_have_to_fit(void) {
  static const uint8_t corners[3] = {0, 1, 2};
  uint8_t answer[3] = {9, 9, 9};
  foredraw_triangles list;
  uint32_t i;
  list.indices = corners;
  list.index_count = 3;
  list.index_bytes = 1;
  list.vertex_count = 300;
  for (i = 0; i < 300; ++i) vertex_order[i] = 299 - i;
  CHECK(foredraw_renumber_vertices(answer, &list, vertex_order) == FOREDRAW_TOO_LARGE);
  CHECK(answer[0] == 9 && answer[2] == 9);
  for (i = 0; i < 300; ++i) vertex_order[i] = i < 3 ? 2 - i : i;
  CHECK(foredraw_renumber_vertices(answer, &list, vertex_order) == FOREDRAW_DONE);
  CHECK(answer[0] == 2 && answer[1] == 1 && answer[2] == 0);
}

static void nothing_is_a_mesh_too(void) {
  foredraw_triangles none;
  foredraw_vertex_cache_figures figures;
  uint32_t clusters = 7;
  memset(&none, 0, sizeof none);
  none.index_bytes = 4;
  CHECK(foredraw_tipsify(NULL, &none, 16) == FOREDRAW_DONE);
  CHECK(foredraw_lookahead(NULL, &none, 0, 0, 0) == FOREDRAW_DONE);
  CHECK(foredraw_forsyth(NULL, &none, 0) == FOREDRAW_DONE);
  CHECK(foredraw_linear_clusters(offsets, &clusters, &none, 0, 0) == FOREDRAW_DONE);
  CHECK(clusters == 0 && offsets[0] == 0);
  CHECK(foredraw_dot_rule(NULL, &none, NULL, NULL, 0) == FOREDRAW_DONE);
  CHECK(foredraw_order_of_clusters(NULL, NULL, 0, NULL) == FOREDRAW_DONE);
  CHECK(foredraw_vertex_fetch(NULL, NULL, &none) == FOREDRAW_DONE);
  CHECK(foredraw_reorder_triangles(NULL, &none, NULL) == FOREDRAW_DONE);
  CHECK(foredraw_renumber_vertices(NULL, &none, NULL) == FOREDRAW_DONE);
  CHECK(foredraw_reorder_elements(NULL, NULL, 0, 4, NULL, 0) == FOREDRAW_DONE);
  CHECK(foredraw_vertex_cache(&figures, &none, 0) == FOREDRAW_DONE);
  CHECK(figures.misses == 0 && !(figures.acmr > 0) && !(figures.atvr > 0));
}

static void each_status_has_a_text_of_its_own(void) {
  int one, other;
  for (one = FOREDRAW_DONE; one <= FOREDRAW_NO_TRANSFORM + 1; ++one) {
    for (other = FOREDRAW_DONE; other < one; ++other) {
      CHECK(strcmp(foredraw_status_text(one), foredraw_status_text(other)) != 0);
    }
  }
  CHECK(strcmp(foredraw_status_text(-1), foredraw_status_text(1000)) == 0);
}

int main(void) {
  make_sheet();
  sheets_get_cheaper();
  levels_are_cut_out_of_a_sequence();
  levels_carry_what_their_vertices_do();
  what_is_wrong_is_refused();
  numbers_have_to_fit();
  nothing_is_a_mesh_too();
  each_status_has_a_text_of_its_own();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
