/* How finely the characters of a crowd are tessellated, so that all of them together stay within a budget of triangles.
 * C99, no state, no allocation.
 *
 * N. Tatarchuk, J. Barczak, B. Purnomo: Real-Time Tessellation on GPU, SIGGRAPH 2008 course notes: one level for all,
 * clamp(M Tmax / N, 1, Tmax), so that N characters take no more triangles than M of the highest level Tmax. They take
 * far fewer, as triangles grow with the level's square: at N = 4 M a quarter. And from N = M Tmax^2 on they take more,
 * as no level is below 1. foredraw_tessellation_by_root() divides triangles evenly, and has the same end.
 * crowd_select.h gives each instance a level of its own, knows coarser meshes, and never takes more.
 *
 *   level = foredraw_tessellation_floor(foredraw_tessellation_by_root(m, t_max, n), FOREDRAW_SPACING_EQUAL);
 *
 * Levels have to be made whole before they are set. A tessellator rounds them up: five characters of 4 at 15 get 13.4,
 * are drawn as of 14, and take 1,470 triangles for each one of the cage instead of 1,348. */
#ifndef FOREDRAW_RUNTIME_TESSELLATION_LEVEL_H
#define FOREDRAW_RUNTIME_TESSELLATION_LEVEL_H

#include <math.h>
#include <stdint.h>

/* Of points on an edge, in the words of shaders. */
typedef enum foredraw_spacing {
  FOREDRAW_SPACING_EQUAL,
  FOREDRAW_SPACING_FRACTIONAL_ODD,
  FOREDRAW_SPACING_FRACTIONAL_EVEN
} foredraw_spacing;

/* That Vulkan and Direct3D 11 promise. With fractional odd spacing it is one less. */
#define FOREDRAW_TESSELLATION_MOST 64u

/* The paper's level, for n characters. None of them at all, or m that reach for all: the highest. */
static inline float foredraw_tessellation_by_count(uint32_t m, uint32_t t_max, uint32_t n) {
  const double level = n > m ? (double)m * (double)t_max / (double)n : (double)t_max;
  return level > 1 ? (float)level : 1;
}

/* The level at which n characters take as many triangles as m at the highest, where a triangle becomes 1.5 level^2 of
 * them. An odd level makes half a triangle less of each: at 15, 225 characters of level 2 take 1,350 for each triangle
 * of the cage, and 4 of level 15 take 1,348. */
static inline float foredraw_tessellation_by_root(uint32_t m, uint32_t t_max, uint32_t n) {
  const double level = n > m ? (double)t_max * sqrt((double)m / (double)n) : (double)t_max;
  return level > 1 ? (float)level : 1;
}

/* Into how many parts an edge of that level is divided, in all three spacings: rounded up to a whole number, to an odd
 * or to an even one. What is no number is the least level. */
static inline uint32_t foredraw_tessellation_parts(float level, foredraw_spacing spacing) {
  const uint32_t step = spacing == FOREDRAW_SPACING_EQUAL ? 1 : 2;
  const uint32_t most = FOREDRAW_TESSELLATION_MOST - (spacing == FOREDRAW_SPACING_FRACTIONAL_ODD ? 1 : 0);
  uint32_t parts = spacing == FOREDRAW_SPACING_FRACTIONAL_EVEN ? 2 : 1;
  while (parts < most && (float)parts < level) parts += step;
  return parts;
}

/* The highest level that is not above, and that stays as it is where it is rounded up: the one to set. The least one
 * (1, with fractional even spacing 2) is never left. */
static inline uint32_t foredraw_tessellation_floor(float level, foredraw_spacing spacing) {
  const uint32_t parts = foredraw_tessellation_parts(level, spacing);
  const uint32_t step = spacing == FOREDRAW_SPACING_EQUAL ? 1 : 2;
  return (float)parts > level && parts > step ? parts - step : parts;
}

/* That a triangle becomes, where its edges and its inside have so many parts: floor(1.5 parts^2). `parts`: at most
 * FOREDRAW_TESSELLATION_MOST. */
static inline uint32_t foredraw_tessellation_triangles(uint32_t parts) { return parts * parts * 3 / 2; }

#endif
