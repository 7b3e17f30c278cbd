/* A mesh that grows by vertex splits. C99, no allocation; split_coding.h says how a split is written.
 *
 * A point is a place. Corners of triangles have vertices, and vertices at one place are of one point; so borders of
 * texture coordinates stay closed. What comes later has a higher number: points, vertices and triangles that are there
 * are the front of their arrays.
 */
#ifndef FOREDRAW_RUNTIME_SPLIT_MESH_H
#define FOREDRAW_RUNTIME_SPLIT_MESH_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#define FOREDRAW_NONE 0xffffffffu
/* So many triangles of a point are brought into the sequence in which they lie around it. Points with more are rare. */
#define FOREDRAW_STAR 64

/* What one of a vertex's numbers is. */
typedef struct foredraw_component {
  uint32_t form; /* 0: a whole number; 1: number * step + least; 2: a float, see foredraw_ordered_float() */
  uint32_t axis; /* 0 to 2: of form 2, the exact x, y or z of the vertex; 3: something else */
  float least, step;
} foredraw_component;

/* Draws of one part have vertices with the same numbers. */
typedef struct foredraw_part {
  uint32_t first, count; /* of the components */
} foredraw_part;

typedef struct foredraw_point {
  int32_t place[3];
  uint32_t first_corner, first_vertex; /* none where it has none */
  uint32_t valence;                    /* how many corners it has */
  uint32_t size;                       /* of its triangles when it was split last: bits of the mean square of edges */
} foredraw_point;

typedef struct foredraw_vertex {
  uint32_t point, part;
  uint32_t next; /* another of the same point, or none */
} foredraw_vertex;

typedef struct foredraw_corner {
  uint32_t point;
  uint32_t next; /* another of the same point, or none */
} foredraw_corner;

typedef struct foredraw_split_mesh {
  uint32_t most_points, most_vertices, most_triangles; /* that there is room for */
  uint32_t points, vertices, triangles;                /* that there are */
  uint32_t grid;                                       /* places are below it */
  float least[3], step;                                /* place * step + least */
  uint32_t draws, parts, components;
  uint32_t width; /* the most numbers that a vertex has */
  const foredraw_component* component;
  const foredraw_part* part; /* [part] */
  const uint32_t* draw_part; /* [draw] */

  uint32_t* indices; /* [corner] its vertex; three corners a triangle */
  uint32_t* draw;    /* [triangle] */
  int32_t* values;   /* [width * vertex] */
  foredraw_vertex* vertex;
  foredraw_point* point;
  foredraw_corner* corner;
} foredraw_split_mesh;

/* Floats as whole numbers that rise with them, and back. */
static inline int32_t foredraw_float_order(float value) {
  uint32_t bits;
  memcpy(&bits, &value, sizeof bits);
  return (int32_t)(bits >> 31 ? bits ^ 0x7fffffffu : bits);
}
static inline float foredraw_ordered_float(int32_t order) {
  const uint32_t bits = order < 0 ? (uint32_t)order ^ 0x7fffffffu : (uint32_t)order;
  float value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

/* The product is exact, so that the sum is the same whether a compiler rounds the product or not. */
static inline float foredraw_place(const foredraw_split_mesh* mesh, uint32_t point, uint32_t axis) {
  return (float)((double)mesh->point[point].place[axis] * (double)mesh->step + (double)mesh->least[axis]);
}

static inline uint32_t foredraw_next_in_triangle(uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
static inline uint32_t foredraw_last_in_triangle(uint32_t corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

static inline uint32_t foredraw_add_point(foredraw_split_mesh* mesh) {
  const uint32_t point = mesh->points++;
  mesh->point[point].first_corner = mesh->point[point].first_vertex = FOREDRAW_NONE;
  mesh->point[point].valence = mesh->point[point].size = 0;
  return point;
}

static inline uint32_t foredraw_add_vertex(foredraw_split_mesh* mesh, uint32_t point, uint32_t part) {
  const uint32_t vertex = mesh->vertices++;
  mesh->vertex[vertex].point = point;
  mesh->vertex[vertex].part = part;
  mesh->vertex[vertex].next = mesh->point[point].first_vertex;
  mesh->point[point].first_vertex = vertex;
  return vertex;
}

static inline void foredraw_put_corner(foredraw_split_mesh* mesh, uint32_t corner, uint32_t point, uint32_t vertex) {
  mesh->indices[corner] = vertex;
  mesh->corner[corner].point = point;
  mesh->corner[corner].next = mesh->point[point].first_corner;
  mesh->point[point].first_corner = corner;
  ++mesh->point[point].valence;
}

/* The triangles of a point. Its link is the edges that lie opposite of it, from `from` to `to`. */
typedef struct foredraw_star {
  uint32_t count; /* FOREDRAW_STAR at most are held */
  int is_ring;    /* each begins where the one before ends, all around */
  uint32_t corner[FOREDRAW_STAR], from[FOREDRAW_STAR], to[FOREDRAW_STAR];
} foredraw_star;

static inline void foredraw_swap_in_star(foredraw_star* star, uint32_t a, uint32_t b) {
  const uint32_t corner = star->corner[a], from = star->from[a], to = star->to[a];
  star->corner[a] = star->corner[b];
  star->from[a] = star->from[b];
  star->to[a] = star->to[b];
  star->corner[b] = corner;
  star->from[b] = from;
  star->to[b] = to;
}

/* Fan after fan, each triangle behind the one that it borders on; a fan begins where nothing comes before. */
static inline void foredraw_order_star(foredraw_star* star) {
  uint32_t begin = 0, end, i;
  star->is_ring = 0;
  while (begin < star->count) {
    end = begin + 1; /* of the fan */
    for (i = end; i < star->count; ++i) {
      if (star->from[i] != star->to[end - 1]) continue;
      foredraw_swap_in_star(star, i, end);
      i = end++;
    }
    if (star->to[end - 1] == star->from[begin]) {
      star->is_ring = begin == 0 && end == star->count;
    } else {
      for (i = end; i < star->count; ++i) {
        uint32_t at;
        if (star->to[i] != star->from[begin]) continue;
        foredraw_swap_in_star(star, i, end);
        for (at = end++; at > begin; --at) foredraw_swap_in_star(star, at, at - 1);
        i = end - 1;
      }
    }
    begin = end;
  }
}

#endif
