/* Meshes made coarser, for C: a sequence of collapses, and what is cut out of it. Part of functions.h. */
#ifndef FOREDRAW_C_SIMPLIFICATION_H
#define FOREDRAW_C_SIMPLIFICATION_H

#include <foredraw/c/mesh.h>
#include <foredraw/c/status.h>

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* One of two points goes, and with it the triangles that have both. A point is what lies at one position, and known by
 * its first vertex. */
typedef struct foredraw_collapse {
  uint32_t removed, kept;
  float blend; /* 0: attributes of the kept one stay; 1: they become those of the removed one */
  float error; /* an estimate of the distance from the original so far; never falls */
} foredraw_collapse;

/* A vertex of the removed point, and the one of the kept point that triangles have in its place. */
typedef struct foredraw_vertex_pair {
  uint32_t removed, kept;
} foredraw_vertex_pair;

/* A mesh made coarser edge by edge: levels of any size are cut out of it. The arrays are the caller's. Each has room
 * for as many elements as there are vertices, first_pair for one more, places for three times as many. */
typedef struct foredraw_collapses {
  foredraw_collapse* collapses; /* in their sequence */
  foredraw_vertex_pair* pairs;  /* of collapse i: first_pair[i] to first_pair[i + 1] - 1 */
  uint32_t* first_pair;
  float* places; /* [3 * i] where the kept point lies then; NULL: points stay where they are */
  uint32_t count;
  /* 1: where a point comes to lie at neither of both places, what its vertices carry is solved for from the triangles
   * around, and foredraw_level_attributes() tells it; 0: it is blended, and so it is where places are NULL. */
  uint32_t solves;
} foredraw_collapses;

/* Added to the components of an attribute. */
enum {
  /* Three or four: the first three point somewhere and are of length 1; a fourth is a sign, and costs nothing. */
  FOREDRAW_DIRECTION = 0x100,
  /* What moves vertices, such as joint weights: blended in every case, alike for all vertices of a point. */
  FOREDRAW_BLENDED = 0x200
};

/* Numbers of vertices that count beside distances: a difference times `weight` is a length. */
typedef struct foredraw_weighted_attribute {
  const void* first;   /* 32-bit floats of vertex 0, at any alignment; what is not finite counts as 0 */
  uint32_t stride;     /* bytes from one vertex to the next; 0: none between them */
  uint32_t components; /* 1 to 16, and FOREDRAW_DIRECTION or FOREDRAW_BLENDED */
  double weight;       /* 0 or more */
} foredraw_weighted_attribute;

/* The edges in the sequence in which they cost least, until `least` triangles are left or none may go. Attributes, up
 * to 16, may be none. Where sequence->places is not NULL points move to where the cost is least: smaller errors, and
 * vertices of each level's own. sequence->solves, 0 or 1, says what becomes of attributes there. Hoppe: Progressive
 * Meshes, SIGGRAPH 1996; costs after Garland and Heckbert 1997, Lindstrom and Turk 1998, Hoppe 1999. */
int foredraw_quadric_collapse(foredraw_collapses* sequence, const foredraw_triangles* triangles,
                              const foredraw_positions* positions, const foredraw_weighted_attribute* attributes,
                              uint32_t attribute_count, uint32_t least);

typedef struct foredraw_simplified {
  uint64_t index_count; /* that are left */
  uint32_t collapses;   /* of the sequence, that were done */
  uint32_t reserved;
  double error; /* proved: no point of either surface is farther from the other, a float's precision aside */
} foredraw_simplified;

/* As much of the sequence as leaves `triangle_count` triangles, or more where the surfaces would otherwise be farther
 * apart than `most_error`, 0 or more; INFINITY: any. `indices` gets the triangles that are left, with as many bytes
 * each as they have, and has room for all. `places`, three a vertex, gets where all vertices lie then; may be NULL
 * where the sequence has no places. A sequence that does not fit the mesh is FOREDRAW_NO_ORDER. */
int foredraw_simplify(void* indices, float* places, foredraw_simplified* simplified,
                      const foredraw_triangles* triangles, const foredraw_positions* positions,
                      const foredraw_collapses* sequence, uint32_t triangle_count, double most_error);

/* What vertices carry after `collapses` of the sequence, as many as foredraw_simplify() told: `values` gets the
 * components of all attributes of vertex 0, one attribute after the other, then those of vertex 1. Directions are of
 * length 1. Other numbers that are solved for lie between those of the corners around. A vertex that no triangle has
 * any more, or that no collapse changed, has what it had. Weights do not count. A sequence that does not fit the mesh
 * is FOREDRAW_NO_ORDER. */
int foredraw_level_attributes(float* values, const foredraw_triangles* triangles, const foredraw_positions* positions,
                              const foredraw_collapses* sequence, uint32_t collapses,
                              const foredraw_weighted_attribute* attributes, uint32_t attribute_count);

#ifdef __cplusplus
}
#endif

#endif
