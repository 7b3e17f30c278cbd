/* How vertices and triangles are written and read, as splits of split_coding.h add them. C99, no allocation. */
#ifndef FOREDRAW_RUNTIME_TRIANGLE_CODING_H
#define FOREDRAW_RUNTIME_TRIANGLE_CODING_H

#include <foredraw/runtime/range_coder.h>
#include <foredraw/runtime/split_mesh.h>

typedef struct foredraw_split_models {
  foredraw_bit_model is_split[16][16];  /* by the point's triangles, and by their size beside others' */
  foredraw_bit_model moves[3][8][8][8]; /* see foredraw_code_star() */
  foredraw_bit_model crowd[2];          /* by the one before */
  foredraw_bit_model closes[2];         /* inside of a surface, and at its border */
  foredraw_bit_model has_more, turns;
  foredraw_bit_model is_expected[4], is_known, is_of_neighbour;
  foredraw_number_model which;   /* a vertex or a draw, by number */
  foredraw_number_model base[3]; /* corners, counts and places before the first split */
  foredraw_number_model place[3][64];
} foredraw_split_models;

/* What a writer wants to be written. Names are its own numbers for vertices. */
typedef struct foredraw_wanted_triangle {
  uint32_t points[3], names[3], draw;
  uint32_t number; /* that it got; none before it is written */
} foredraw_wanted_triangle;

typedef struct foredraw_wanted {
  const uint8_t* moves;         /* [triangle] whether it goes to the new point */
  const uint32_t* corner_names; /* [corner] of triangles that are there: behind the split */
  foredraw_wanted_triangle* added;
  uint32_t added_count;
  const int32_t* place;  /* of the new point */
  uint32_t* names;       /* [vertex] of all that are there; new ones are put in */
  const int32_t* values; /* [width * name] */
} foredraw_wanted;

typedef struct foredraw_split_coding {
  foredraw_range_coder coder;
  foredraw_split_mesh mesh;
  foredraw_split_models* models;
  foredraw_number_model* value_models; /* [width] */
  const foredraw_wanted* wanted;       /* none: it reads */
  uint64_t budget;                     /* of what may be looked at: what is damaged must come to an end */
  uint32_t at;                         /* the point that is asked next whether it splits */
  uint32_t usual_size;                 /* of points that were split, on the way over all points before; in quarters */
  uint32_t splits;                     /* on this way, */
  uint64_t sizes;                      /* and their sizes together */
  int damaged;
} foredraw_split_coding;

static inline uint32_t foredraw_least_of(uint32_t a, uint32_t b) { return a < b ? a : b; }

/* A vertex of the point: the expected one, none being a new one; or another; or a new one. */
static inline uint32_t foredraw_code_vertex(foredraw_split_coding* s, uint32_t point, uint32_t part, uint32_t expected,
                                            uint32_t kind, uint32_t name) {
  foredraw_split_mesh* mesh = &s->mesh;
  uint32_t vertex = FOREDRAW_NONE, i = 0;
  if (s->wanted) {
    vertex = mesh->point[point].first_vertex;
    for (; vertex != FOREDRAW_NONE && s->wanted->names[vertex] != name; ++i) vertex = mesh->vertex[vertex].next;
  }
  if (foredraw_code_bit(&s->coder, &s->models->is_expected[kind], vertex == expected)) {
    vertex = expected;
  } else if (foredraw_code_bit(&s->coder, &s->models->is_known, vertex != FOREDRAW_NONE)) {
    i = (uint32_t)foredraw_code_number(&s->coder, &s->models->which, (int32_t)i);
    vertex = mesh->point[point].first_vertex;
    for (; vertex != FOREDRAW_NONE && i > 0; --i) vertex = mesh->vertex[vertex].next;
    if (vertex == FOREDRAW_NONE) s->damaged = 1;
  } else {
    vertex = FOREDRAW_NONE;
  }
  if (vertex != FOREDRAW_NONE ? mesh->vertex[vertex].part != part : mesh->vertices == mesh->most_vertices)
    s->damaged = 1;
  if (s->damaged) return 0;
  if (vertex != FOREDRAW_NONE) return vertex;
  vertex = foredraw_add_vertex(mesh, point, part);
  if (s->wanted) s->wanted->names[vertex] = name;
  return vertex;
}

/* A number of a vertex, beside what is expected. */
static inline void foredraw_code_value(foredraw_split_coding* s, uint32_t vertex, uint32_t i, int32_t expected) {
  foredraw_split_mesh* mesh = &s->mesh;
  const uint32_t at = mesh->part[mesh->vertex[vertex].part].first + i, axis = mesh->component[at].axis;
  uint32_t value = 0;
  if (axis < 3) expected = foredraw_float_order(foredraw_place(mesh, mesh->vertex[vertex].point, axis));
  if (s->wanted) value = (uint32_t)s->wanted->values[(size_t)mesh->width * s->wanted->names[vertex] + i];
  value -= (uint32_t)expected;
  value = (uint32_t)foredraw_code_number(&s->coder, s->value_models + i, (int32_t)value) + (uint32_t)expected;
  mesh->values[(size_t)mesh->width * vertex + i] = (int32_t)value;
}

static inline uint32_t foredraw_code_draw(foredraw_split_coding* s, uint32_t expected, uint32_t draw) {
  if (s->mesh.draws < 2) return 0;
  if (foredraw_code_bit(&s->coder, &s->models->is_of_neighbour, draw == expected)) return expected;
  draw = (uint32_t)foredraw_code_number(&s->coder, &s->models->which, (int32_t)draw);
  if (draw < s->mesh.draws) return draw;
  s->damaged = 1;
  return 0;
}

static inline void foredraw_add_triangle(foredraw_split_coding* s, const uint32_t* points, const uint32_t* expected,
                                         uint32_t expected_draw, foredraw_wanted_triangle* wanted, uint32_t turn) {
  foredraw_split_mesh* mesh = &s->mesh;
  uint32_t draw, vertex, k;
  if (mesh->triangles == mesh->most_triangles) s->damaged = 1;
  draw = foredraw_code_draw(s, expected_draw, wanted ? wanted->draw : 0);
  for (k = 0; k < 3 && !s->damaged; ++k) {
    vertex = foredraw_code_vertex(s, points[k], mesh->draw_part[draw], expected[k], 1 + k,
                                  wanted ? wanted->names[(k + turn) % 3] : 0);
    if (s->damaged) return;
    foredraw_put_corner(mesh, 3 * mesh->triangles + k, points[k], vertex);
  }
  if (s->damaged) return;
  if (wanted) wanted->number = mesh->triangles;
  mesh->draw[mesh->triangles++] = draw;
}

#endif
