/* The surface that a tessellated, displaced triangle shows: what C, C++ and shaders compute alike. C99, no allocation,
 * no state.
 *
 * N. Tatarchuk, J. Barczak, B. Purnomo: Real-Time Tessellation on GPU, in: Advances in Real-Time Rendering in 3D
 * Graphics and Games, SIGGRAPH 2008. A triangle is divided in its plane, and each point moves along the interpolated
 * direction by a height from a map.
 *
 * For surfaces without cracks, two triangles that share an edge have to make the same points of it. Each function here
 * gives the same bits whichever triangle asks: it treats the corners alike, or the third corner has weight 0 and
 * changes nothing. In a shader, declare what is computed here `precise`, so that nothing is contracted.
 *
 *   level[e] = foredraw_edge_level(a, b, eye, pixels, 8);                 in the control stage, for every edge
 *   d = offset + factor * height;                                        see displaced_height.h
 *   foredraw_displaced_point(position, direction, tess_coord, d, point); in the evaluation stage */
#ifndef FOREDRAW_RUNTIME_DISPLACED_SURFACE_H
#define FOREDRAW_RUNTIME_DISPLACED_SURFACE_H

#include <math.h>

/* The sum of three rows by their weights. A corner of weight 0 changes no bit, as long as its row is finite. */
static inline void foredraw_weighted(const float corner[3][3], const float weight[3], float sum[3]) {
  int axis;
  for (axis = 0; axis < 3; ++axis) {
    const float a = weight[0] * corner[0][axis], b = weight[1] * corner[1][axis], c = weight[2] * corner[2][axis];
    sum[axis] = (a + b) + c;
  }
}

static inline float foredraw_length(const float v[3]) { return sqrtf((v[0] * v[0] + v[1] * v[1]) + v[2] * v[2]); }

/* A point of the displaced surface. `position` and `direction`: of the corners, posed alike; a direction's length says
 * by how much the pose scales there, and is 1 at rest. `weight`: gl_TessCoord. `displacement`: in units at rest. Where
 * the directions cancel each other out the point stays in the plane. */
static inline void foredraw_displaced_point(const float position[3][3], const float direction[3][3],
                                            const float weight[3], float displacement, float point[3]) {
  float along[3], scale[3], length;
  int i;
  foredraw_weighted(position, weight, point);
  foredraw_weighted(direction, weight, along);
  length = foredraw_length(along);
  if (!(length > 0.0f)) return;
  for (i = 0; i < 3; ++i) scale[i] = weight[i] * foredraw_length(direction[i]);
  displacement = displacement * (((scale[0] + scale[1]) + scale[2]) / length);
  for (i = 0; i < 3; ++i) point[i] = point[i] + along[i] * displacement;
}

/* The level of an edge whose parts shall be so many pixels long, from the edge alone: its length over its middle's
 * distance from the eye. `pixels_per_unit`: of a thing of size 1 at distance 1. At least 1, at most 64; NaN gives 1. */
static inline float foredraw_edge_level(const float a[3], const float b[3], const float eye[3], float pixels_per_unit,
                                        float pixels_per_part) {
  float along[3], away[3], level;
  int i;
  for (i = 0; i < 3; ++i) {
    along[i] = a[i] - b[i];
    away[i] = 0.5f * (a[i] + b[i]) - eye[i];
  }
  level = foredraw_length(along) * pixels_per_unit / (foredraw_length(away) * pixels_per_part);
  return !(level > 1.0f) ? 1.0f : level < 64.0f ? level : 64.0f;
}

#endif
