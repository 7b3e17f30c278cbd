/* A mesh that is fine where it is looked at and coarse elsewhere, changed a little each frame. C99, no allocation;
 * foredraw::refine_records() makes the arrays.
 *
 *   uint32_t* memory = malloc(sizeof(uint32_t) * foredraw_refine_words(&mesh));
 *   foredraw_refinement state;
 *   foredraw_refine_begin(&state, &mesh, memory);
 *   ...
 *   foredraw_refine(&state, foredraw_refine_view_wants, &view, 2000);  // each frame
 *   draw(state.indices, 3 * state.triangles);
 *
 * The arrays are never written, so that many states may share them. The vertices are those of full detail, and stay
 * where they are. Hoppe: View-Dependent Refinement of Progressive Meshes, SIGGRAPH 1997.
 *
 * A split may be done once those that it needs are: those that add the point that it splits, the points at both of its
 * sides, and the triangles that it changes. So what is drawn depends on which splits are done, and not on their
 * sequence, and is as closed and as much a manifold as the base.
 */
#ifndef FOREDRAW_RUNTIME_SELECTIVE_REFINE_H
#define FOREDRAW_RUNTIME_SELECTIVE_REFINE_H

#include <foredraw/runtime/progressive_mesh.h>

#include <math.h>

/* What a split needs, and where on the surface it is. Each adds a point, and points are known by the split that adds
 * them; those of the base have numbers from split_count on. Where a split is named, split_count says none. */
typedef struct foredraw_refine_node {
  uint32_t point;        /* that is split; the split that adds it is the parent of this one */
  uint32_t first_child;  /* of the splits whose parent this is */
  uint32_t next_sibling; /* of the same parent */
  uint32_t first_need;   /* the splits that it needs, its parent among them; the next one's begin where they end */
  float centre[3];       /* of a ball that holds what the split and those below it change, and their balls */
  float radius;
  float axis[3]; /* no normal of full detail there, of length 1, is farther from the axis than the spread */
  float spread;
} foredraw_refine_node;

typedef struct foredraw_refine_mesh {
  const foredraw_split* splits;      /* as for progressive_mesh.h; one more than split_count */
  const foredraw_refine_node* nodes; /* one more than split_count: the last one's children have no parent */
  uint32_t split_count;
  const foredraw_patch* patches;
  const uint32_t* needs;   /* splits, rising for each node; all come before it */
  const uint32_t* corners; /* three for each triangle, as it appears */
  uint32_t triangles;      /* of full detail */
} foredraw_refine_mesh;

typedef struct foredraw_refinement {
  const foredraw_refine_mesh* mesh;
  uint32_t* indices;  /* three for each triangle that is drawn; the buffer holds those of full detail */
  uint32_t triangles; /* that are drawn */
  uint32_t done;      /* splits */
  uint32_t open;      /* splits that are done, or whose parents are */
  uint32_t* order;    /* [place] = split: those that are done, the other open ones, all others */
  uint32_t* place;    /* [split] */
  uint32_t* holders;  /* [split] how many of those that are done need it */
  uint32_t* asker;    /* [split] which one waits for it */
  uint32_t* drawn;    /* [slot] = triangle: those that are drawn, all others */
  uint32_t* slot;     /* [triangle] */
} foredraw_refinement;

/* Whether the mesh is to be as fine as the split makes it. It should want a split wherever it wants one below it, or
 * what is drawn depends on what was drawn before. */
typedef int (*foredraw_refine_wants)(const void* context, const foredraw_refine_mesh* mesh, uint32_t split);

/* How many numbers the memory of a state holds. */
static inline size_t foredraw_refine_words(const foredraw_refine_mesh* mesh) {
  return 4 * (size_t)mesh->split_count + 5 * (size_t)mesh->triangles;
}

/* ---- What the functions below are made of. ---- */

static inline void foredraw_refine_put(uint32_t* order, uint32_t* place, uint32_t one, uint32_t to) {
  const uint32_t from = place[one], other = order[to];
  order[from] = other;
  place[other] = from;
  order[to] = one;
  place[one] = to;
}

static inline void foredraw_refine_show(foredraw_refinement* state, uint32_t triangle) {
  const uint32_t* corners = state->mesh->corners + 3 * (size_t)triangle;
  uint32_t* to = state->indices + 3 * (size_t)state->triangles;
  foredraw_refine_put(state->drawn, state->slot, triangle, state->triangles++);
  to[0] = corners[0];
  to[1] = corners[1];
  to[2] = corners[2];
}

static inline void foredraw_refine_hide(foredraw_refinement* state, uint32_t triangle) {
  uint32_t* to = state->indices + 3 * (size_t)state->slot[triangle];
  const uint32_t* last = state->indices + 3 * (size_t)--state->triangles;
  to[0] = last[0];
  to[1] = last[1];
  to[2] = last[2];
  foredraw_refine_put(state->drawn, state->slot, triangle, state->triangles);
}

static inline uint32_t* foredraw_refine_corner(foredraw_refinement* state, uint32_t corner) {
  return state->indices + 3 * (size_t)state->slot[corner / 3] + corner % 3;
}

static inline void foredraw_refine_do(foredraw_refinement* state, uint32_t split) {
  const foredraw_refine_mesh* mesh = state->mesh;
  const foredraw_split* record = mesh->splits + split;
  const foredraw_refine_node* node = mesh->nodes + split;
  uint32_t i;
  for (i = record[0].first_patch; i < record[1].first_patch; ++i)
    *foredraw_refine_corner(state, mesh->patches[i].corner) = mesh->patches[i].fine;
  for (i = record[0].triangles; i < record[1].triangles; ++i) foredraw_refine_show(state, i);
  for (i = node[0].first_need; i < node[1].first_need; ++i) ++state->holders[mesh->needs[i]];
  foredraw_refine_put(state->order, state->place, split, state->done++);
  for (i = node->first_child; i < mesh->split_count; i = mesh->nodes[i].next_sibling)
    foredraw_refine_put(state->order, state->place, i, state->open++);
}

static inline void foredraw_refine_undo(foredraw_refinement* state, uint32_t split) {
  const foredraw_refine_mesh* mesh = state->mesh;
  const foredraw_split* record = mesh->splits + split;
  const foredraw_refine_node* node = mesh->nodes + split;
  uint32_t i;
  for (i = node->first_child; i < mesh->split_count; i = mesh->nodes[i].next_sibling)
    foredraw_refine_put(state->order, state->place, i, --state->open);
  foredraw_refine_put(state->order, state->place, split, --state->done);
  for (i = node[0].first_need; i < node[1].first_need; ++i) --state->holders[mesh->needs[i]];
  for (i = record[1].triangles; i > record[0].triangles; --i) foredraw_refine_hide(state, i - 1);
  for (i = record[1].first_patch; i > record[0].first_patch; --i)
    *foredraw_refine_corner(state, mesh->patches[i - 1].corner) = mesh->patches[i - 1].coarse;
}

/* ---- States. ---- */

/* The base. `memory` holds foredraw_refine_words() numbers, for as long as the state. */
static inline void foredraw_refine_begin(foredraw_refinement* state, const foredraw_refine_mesh* mesh,
                                         uint32_t* memory) {
  const uint32_t splits = mesh->split_count, triangles = mesh->triangles, base = mesh->splits[0].triangles;
  uint32_t i;
  state->mesh = mesh;
  state->order = memory;
  state->place = state->order + splits;
  state->holders = state->place + splits;
  state->asker = state->holders + splits;
  state->drawn = state->asker + splits;
  state->slot = state->drawn + triangles;
  state->indices = state->slot + triangles;
  state->triangles = state->done = state->open = 0;
  for (i = 0; i < splits; ++i) {
    state->order[i] = state->place[i] = i;
    state->holders[i] = 0;
  }
  for (i = 0; i < triangles; ++i) state->drawn[i] = state->slot[i] = i;
  for (i = 0; i < base; ++i) foredraw_refine_show(state, i);
  for (i = mesh->nodes[splits].first_child; i < splits; i = mesh->nodes[i].next_sibling)
    foredraw_refine_put(state->order, state->place, i, state->open++);
}

static inline int foredraw_refine_is_done(const foredraw_refinement* state, uint32_t split) {
  return state->place[split] < state->done;
}

/* The first that the split needs and that is not done; split_count: none, and it may be done now. */
static inline uint32_t foredraw_refine_missing(const foredraw_refinement* state, uint32_t split) {
  const foredraw_refine_node* node = state->mesh->nodes + split;
  uint32_t i;
  for (i = node[0].first_need; i < node[1].first_need; ++i) {
    if (!foredraw_refine_is_done(state, state->mesh->needs[i])) return state->mesh->needs[i];
  }
  return state->mesh->split_count;
}

/* Does the split, and before it all that it needs: at most so many, the split last. How many were done. */
static inline uint32_t foredraw_refine_split(foredraw_refinement* state, uint32_t split, uint32_t most) {
  const uint32_t none = state->mesh->split_count;
  uint32_t count = 0;
  if (foredraw_refine_is_done(state, split)) return 0;
  state->asker[split] = none;
  while (split != none && count < most) {
    const uint32_t missing = foredraw_refine_missing(state, split);
    if (missing != none) {
      state->asker[missing] = split;
      split = missing;
    } else {
      foredraw_refine_do(state, split);
      ++count;
      split = state->asker[split];
    }
  }
  return count;
}

/* Takes the split back, unless it is not done, or one that is done needs it: then 0. */
static inline uint32_t foredraw_refine_collapse(foredraw_refinement* state, uint32_t split) {
  if (!foredraw_refine_is_done(state, split) || state->holders[split] != 0) return 0;
  foredraw_refine_undo(state, split);
  return 1;
}

/* One frame: takes back splits that are not wanted, then does those that are and what they need, the coarse ones first:
 * at most so many of each. How many were done or taken back; 0: nothing is left to be changed. Looks once at each split
 * that is done or open. */
static inline uint32_t foredraw_refine(foredraw_refinement* state, foredraw_refine_wants wants, const void* context,
                                       uint32_t most) {
  uint32_t collapses = 0, splits = 0, i;
  for (i = state->done; i > 0 && collapses < most; --i) {
    const uint32_t split = state->order[i - 1];
    if (state->holders[split] == 0 && !wants(context, state->mesh, split))
      collapses += foredraw_refine_collapse(state, split);
  }
  i = state->done;
  while (i < state->open && splits < most) {
    const uint32_t split = state->order[i++];
    if (wants(context, state->mesh, split)) splits += foredraw_refine_split(state, split, most - splits);
  }
  return collapses + splits;
}

/* ---- What a view wants. ---- */

/* All in the space of the mesh. */
typedef struct foredraw_refine_view {
  float eye[3];
  float planes[6][4]; /* (n, d), n of length 1: a place p is seen where n * p + d >= 0 for all; zeros: no plane */
  float pixels;       /* that a unit takes at a distance of 1: half the height / tan(half the vertical angle) */
  float surface;      /* pixels that the surface may be off where it is seen from the front */
  float silhouette;   /* and where it turns away from the eye, so that its outline shows; at most as many */
  int back_sides;     /* not 0: they are seen, too */
} foredraw_refine_view;

static inline float foredraw_refine_dot(const float a[3], const float b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Wants what is in the frustum, does not show its back as a whole, and is off by more pixels than the view says. The
 * context is the view. The criteria of Hoppe 1997. */
static inline int foredraw_refine_view_wants(const void* context, const foredraw_refine_mesh* mesh, uint32_t split) {
  const foredraw_refine_view* view = (const foredraw_refine_view*)context;
  const foredraw_refine_node* node = mesh->nodes + split;
  float towards[3], distance, facing, slack, limit;
  int i;
  for (i = 0; i < 6; ++i) {
    if (foredraw_refine_dot(view->planes[i], node->centre) + view->planes[i][3] < -node->radius) return 0;
  }
  for (i = 0; i < 3; ++i) towards[i] = node->centre[i] - view->eye[i];
  distance = sqrtf(foredraw_refine_dot(towards, towards));
  facing = foredraw_refine_dot(node->axis, towards);
  slack = node->spread * distance + node->radius; /* so far may a normal there, and a place, change what is facing */
  if (facing > slack && !view->back_sides) return 0;
  limit = facing > slack || facing < -slack ? view->surface : view->silhouette;
  distance = distance > node->radius ? distance - node->radius : 0.0f;
  return mesh->splits[split].error * view->pixels > limit * distance;
}

#endif
