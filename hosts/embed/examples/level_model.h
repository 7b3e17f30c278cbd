/* A small engine for level_walk.c, as C sees it: one draw of a scene that `foredraw optimize` wrote, with its levels,
 * what their vertices become, and the sequence in which it becomes coarser. Made of Foredraw's reader; yours has its
 * own. */
#ifndef FOREDRAW_EXAMPLES_LEVEL_MODEL_H
#define FOREDRAW_EXAMPLES_LEVEL_MODEL_H

#include <foredraw/runtime/selective_refine.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct level_model level_model;

/* All levels share the vertices of full detail. */
typedef struct model_level {
  uint32_t triangles;
  float error;               /* no point is farther from full detail, in units */
  const uint32_t* ancestors; /* [vertex] in the next level; NULL: this is the coarsest one */
} model_level;

/* The first draw that has all three. NULL where there is none, or no scene to read: stderr says which. */
level_model* level_model_load(const char* path);
void level_model_free(level_model* model);

/* What follows is good as long as the model. */
uint32_t level_model_vertices(const level_model* model);
const float* level_model_positions(const level_model* model);            /* three a vertex */
uint32_t level_model_levels(const level_model* model);                   /* full detail among them */
model_level level_model_level(const level_model* model, uint32_t level); /* 0: full detail */
void level_model_ball(const level_model* model, float centre[3], float* radius);

/* Both number vertices as they appear: level_model_vertex() says which ones of the positions they are. */
const uint32_t* level_model_vertex(const level_model* model);
foredraw_progressive_mesh level_model_progressive(level_model* model); /* at full detail */
const foredraw_refine_mesh* level_model_refine(const level_model* model);

#ifdef __cplusplus
}
#endif

#endif
