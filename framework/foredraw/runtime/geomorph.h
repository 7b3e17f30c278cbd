/* A level of detail on its way to the next coarser one: every vertex moves to its ancestor at once, so that no change
 * of levels is seen. C99, no allocation, no state; the plugin geomorphs writes the ancestors.
 *
 *   for (v = 0; v < vertex_count; ++v) {
 *     foredraw_geomorph(positions + 3 * v, coarse_positions + 3 * ancestors[v], alpha, 3, blended + 3 * v);
 *     foredraw_geomorph_direction(normals + 3 * v, coarse_normals + 3 * ancestors[v], alpha, blended_normals + 3 * v);
 *   }
 *
 * At alpha 0 it is the level, at 1 the next one, to the bit. Several levels are crossed by ancestors of ancestors.
 */
#ifndef FOREDRAW_RUNTIME_GEOMORPH_H
#define FOREDRAW_RUNTIME_GEOMORPH_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>

/* `components` numbers between those of a vertex and of its ancestor. A component never leaves the two, whatever alpha;
 * below 0 and NaN it is 0, above 1 it is 1. `to` may be `fine`. */
static inline void foredraw_geomorph(const float* fine, const float* coarse, float alpha, size_t components,
                                     float* to) {
  size_t c;
  for (c = 0; c < components; ++c) {
    const float a = fine[c], b = coarse[c];
    if (!(alpha > 0.0f)) {
      to[c] = a;
    } else if (alpha >= 1.0f) {
      to[c] = b;
    } else {
      const float blended = a + (b - a) * alpha;
      const float least = a < b ? a : b, most = a < b ? b : a;
      to[c] = blended < least ? least : blended > most ? most : blended;
    }
  }
}

/* The same of normals, or of the three numbers of a tangent that point somewhere: of length 1, where neither is 0 nor
 * the two are opposite. At the ends they are what they were, of whatever length. */
static inline void foredraw_geomorph_direction(const float fine[3], const float coarse[3], float alpha, float to[3]) {
  float length;
  foredraw_geomorph(fine, coarse, alpha, 3, to);
  if (!(alpha > 0.0f) || alpha >= 1.0f) return;
  length = sqrtf(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]);
  if (!(length > 0.0f)) return;
  to[0] /= length;
  to[1] /= length;
  to[2] /= length;
}

/* Ancestors over two steps: those of a level in the next but one. `first` are those of the level, `second` those of the
 * level that they name. `to` may be `first`. */
static inline void foredraw_geomorph_chain(const uint32_t* first, const uint32_t* second, size_t vertex_count,
                                           uint32_t* to) {
  size_t v;
  for (v = 0; v < vertex_count; ++v) to[v] = second[first[v]];
}

#endif
