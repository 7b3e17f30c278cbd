/* Levels of a tessellator that were chosen by what a map of heights shows, and how far to lower them. C99, no
 * allocation, no state.
 *
 * Each edge and inside has a level, stored as a power of two (FOREDRAW_tessellation_levels). What lies farther away
 * needs less: `scale` is taken from all of them alike, so triangles still agree on their edges. A table says which
 * error each whole scale has; it belongs to the draw.
 *
 *   s = foredraw_tessellation_scale_for(table, scales, pixels * distance / pixels_per_unit);
 *   level = foredraw_tessellation_scaled(stored, (float)s);                  in the control stage, for every edge */
#ifndef FOREDRAW_RUNTIME_TESSELLATION_SCALE_H
#define FOREDRAW_RUNTIME_TESSELLATION_SCALE_H

#include <math.h>
#include <stdint.h>

/* Displacements are off by so much, in the draw's units. Number s of a table: s is taken from each level. Triangles
 * fall, errors rise. */
typedef struct foredraw_tessellation_scale {
  uint32_t triangles;
  float rms, largest;
} foredraw_tessellation_scale;

/* The coarsest scale whose rms error is at most `error`; 0 where none is, or `error` is NaN. */
static inline uint32_t foredraw_tessellation_scale_for(const foredraw_tessellation_scale* table, uint32_t scales,
                                                       float error) {
  uint32_t s = scales;
  while (s > 1 && !(table[s - 1].rms <= error)) --s;
  return s > 0 ? s - 1 : 0;
}

/* The finest scale of at most so many triangles; the coarsest where none is. */
static inline uint32_t foredraw_tessellation_scale_within(const foredraw_tessellation_scale* table, uint32_t scales,
                                                          uint32_t triangles) {
  uint32_t s = 0;
  while (s + 1 < scales && table[s].triangles > triangles) ++s;
  return s;
}

/* The level of an edge or an inside: 1 to 64. A scale between two whole ones lies between their levels, for fractional
 * spacing. Below 0, and NaN: as 0. What is stored and is no power up to 6 is taken as 6. */
static inline float foredraw_tessellation_scaled(uint8_t stored, float scale) {
  const float power = (float)(stored < 6 ? stored : 6) - (scale > 0.0f ? scale : 0.0f);
  return power > 0.0f ? exp2f(power) : 1.0f;
}

#endif
