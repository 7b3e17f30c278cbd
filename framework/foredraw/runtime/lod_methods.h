/* Simpler ways to choose levels than lod_select.h, without a promise. C99, no allocation.
 *
 * T. Funkhouser, C. Sequin: Adaptive Display Algorithm for Interactive Frame Rates, SIGGRAPH 1993: levels by the size
 * of their triangles on the screen (static), and the same with a size that follows the last frame's time (feedback). */
#ifndef FOREDRAW_RUNTIME_LOD_METHODS_H
#define FOREDRAW_RUNTIME_LOD_METHODS_H

#include <stdint.h>

/* Static: the coarsest level whose triangles have no more than `most` pixels each, or full detail. triangles[level]:
 * fewer from level to level. */
static inline uint32_t foredraw_lod_by_size(const uint32_t* triangles, uint32_t levels, float pixels, float most) {
  uint32_t level = 0;
  while (level + 1 < levels && pixels <= most * (float)triangles[level + 1]) ++level;
  return level;
}

/* Feedback: the next frame's `most` pixels of a triangle, after a frame of that time. It follows by a factor of 2 at
 * most, and from 2^-10 to 2^24, so that it comes back from both ends. A time below 0 or a target that is not above it,
 * as of a clock that was set back, tells nothing. */
static inline float foredraw_lod_fed_back(float most, float time, float target) {
  const float ratio = target > 0 && time >= 0 ? time / target : 1;
  const float next = most * (ratio > 0.5f ? (ratio < 2 ? ratio : 2) : 0.5f);
  return next > 1.0f / 1024 ? (next < 16777216.0f ? next : 16777216.0f) : 1.0f / 1024;
}

#endif
