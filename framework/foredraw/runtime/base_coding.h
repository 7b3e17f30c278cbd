/* How the mesh before its first split is written and read, and which point splits next. C99, no allocation. */
#ifndef FOREDRAW_RUNTIME_BASE_CODING_H
#define FOREDRAW_RUNTIME_BASE_CODING_H

#include <foredraw/runtime/split_coding.h>

static inline void foredraw_code_base_point(foredraw_split_coding* s, const int32_t* places) {
  foredraw_split_mesh* mesh = &s->mesh;
  uint32_t point, k;
  if (mesh->points == mesh->most_points) s->damaged = 1;
  if (s->damaged) return;
  point = foredraw_add_point(mesh);
  for (k = 0; k < 3; ++k) {
    const int32_t before = point > 0 ? mesh->point[point - 1].place[k] : 0;
    const int64_t value =
        (int64_t)before +
        foredraw_code_number(&s->coder, &s->models->base[0], s->wanted ? places[3 * (size_t)point + k] - before : 0);
    if (value < 0 || value >= (int64_t)mesh->grid) s->damaged = 1;
    mesh->point[point].place[k] = s->damaged ? 0 : (int32_t)value;
  }
}

/* A corner by how far its point lies behind the last one; 0 is a new point. */
static inline void foredraw_code_base_triangle(foredraw_split_coding* s, foredraw_wanted_triangle* wanted,
                                               const int32_t* places) {
  foredraw_split_mesh* mesh = &s->mesh;
  uint32_t points[3] = {0, 0, 0}, expected[3], k;
  for (k = 0; k < 3; ++k) {
    const uint32_t back = (uint32_t)foredraw_code_number(&s->coder, &s->models->base[1],
                                                         wanted ? (int32_t)(mesh->points - wanted->points[k]) : 0);
    if (back > mesh->points) s->damaged = 1;
    if (s->damaged) return;
    points[k] = mesh->points - back;
    if (back == 0) foredraw_code_base_point(s, places);
  }
  if (points[0] == points[1] || points[1] == points[2] || points[2] == points[0]) s->damaged = 1;
  for (k = 0; k < 3 && !s->damaged; ++k) expected[k] = mesh->point[points[k]].first_vertex;
  if (!s->damaged) foredraw_add_triangle(s, points, expected, 0, wanted, 0);
}

/* Of a writer `wanted` has the triangles, and the places of all `points`, which come in the sequence in which triangles
 * have them; those of none come last. */
static inline void foredraw_code_base(foredraw_split_coding* s, uint32_t points) {
  foredraw_split_mesh* mesh = &s->mesh;
  const foredraw_wanted* wanted = s->wanted;
  const int32_t* places = wanted ? wanted->place : NULL;
  const uint32_t triangles =
      (uint32_t)foredraw_code_number(&s->coder, &s->models->base[2], wanted ? (int32_t)wanted->added_count : 0);
  uint32_t i, k;
  points = (uint32_t)foredraw_code_number(&s->coder, &s->models->base[2], (int32_t)points);
  if (triangles > mesh->most_triangles || points > mesh->most_points) s->damaged = 1;
  for (i = 0; i < triangles && !s->damaged; ++i) {
    const uint32_t first_vertex = mesh->vertices;
    foredraw_code_base_triangle(s, wanted ? wanted->added + i : NULL, places);
    for (k = first_vertex; k < mesh->vertices && !s->damaged; ++k) foredraw_code_values(s, k, first_vertex);
  }
  while (mesh->points < points && !s->damaged) foredraw_code_base_point(s, places);
  if (mesh->points != points) s->damaged = 1;
}

/* Whether the point that is next splits. All points are asked, over and over, and those that split are asked again. */
static inline uint32_t foredraw_code_is_split(foredraw_split_coding* s, uint32_t is_split) {
  const foredraw_split_mesh* mesh = &s->mesh;
  const int64_t beside = mesh->points > 0 ? (int64_t)4 * mesh->point[s->at].size - s->usual_size + 8 : 0;
  const uint32_t of_size = beside < 0 ? 0 : foredraw_least_of((uint32_t)beside, 15);
  if (mesh->points == 0 || s->budget == 0) {
    s->damaged = 1;
    return 0;
  }
  --s->budget;
  is_split = foredraw_code_bit(
      &s->coder, &s->models->is_split[foredraw_least_of(mesh->point[s->at].valence, 15)][of_size], is_split);
  if (is_split) return 1;
  if (++s->at == mesh->points) {
    if (s->splits > 0) s->usual_size = (uint32_t)(4 * s->sizes / s->splits);
    s->at = s->splits = 0;
    s->sizes = 0;
  }
  return 0;
}

/* Splits the point that is next. */
static inline void foredraw_code_next_split(foredraw_split_coding* s) {
  if (s->mesh.points == s->mesh.most_points) s->damaged = 1;
  if (s->damaged) return;
  foredraw_code_split(s, s->at);
  ++s->splits;
  s->sizes += s->mesh.point[s->at].size;
}

#endif
