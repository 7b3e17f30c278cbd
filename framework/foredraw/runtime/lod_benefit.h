/* What a way to draw an object costs, and what it is worth: costs and benefits for lod_select.h. C99, no state.
 *
 * T. Funkhouser, C. Sequin: Adaptive Display Algorithm for Interactive Frame Rates, SIGGRAPH 1993, sections 4 (cost)
 * and 5 (benefit). Each factor is a function of its own, from 0 to 1, and is 1 where it is left out:
 *
 *   way.cost = foredraw_lod_cost(foredraw_lod_pipeline(&rendering, triangles, vertices, pixels));
 *   way.benefit = foredraw_lod_benefit(pixels * foredraw_lod_accuracy_of_error(error_in_pixels) *
 *                                      foredraw_lod_focus(from_middle, 0.5f) *
 *                                      foredraw_lod_motion(pixels_a_frame, sqrtf(pixels)) *
 *                                      foredraw_lod_hysteresis(levels_from_the_last, 0.02f));
 *
 * Hysteresis must be in the benefits before ways are chosen, as it bends what they are worth.
 *
 * What is no number (NaN) makes a way cost most, and be worth nothing. */
#ifndef FOREDRAW_RUNTIME_LOD_BENEFIT_H
#define FOREDRAW_RUNTIME_LOD_BENEFIT_H

#include <math.h>
#include <stdint.h>

/* Nanoseconds that one more of each takes, measured on the machine that draws. */
typedef struct foredraw_lod_rendering {
  float triangle, vertex, pixel;
} foredraw_lod_rendering;

/* 0 of what is no number. */
static inline float foredraw_lod_within_1(float value) { return value > 0 ? (value < 1 ? value : 1) : 0; }

/* Stages of a pipeline work at once, so that the slowest one counts. No number if one of them is none. */
static inline float foredraw_lod_pipeline(const foredraw_lod_rendering* rendering, float triangles, float vertices,
                                          float pixels) {
  const float geometry = rendering->triangle * triangles + rendering->vertex * vertices;
  const float shading = rendering->pixel * pixels;
  if (!(geometry == geometry)) return geometry;
  return geometry > shading ? geometry : shading;
}

/* The same where nothing works at once, as on a processor. */
static inline float foredraw_lod_sum(const foredraw_lod_rendering* rendering, float triangles, float vertices,
                                     float pixels) {
  return rendering->triangle * triangles + rendering->vertex * vertices + rendering->pixel * pixels;
}

/* 1 - base_error / samples^power: of flat triangles power is 1 and samples are triangles; of smooth ones power is 2 and
 * samples are vertices; where each pixel is traced, samples are pixels. */
static inline float foredraw_lod_accuracy_of_samples(float samples, float base_error, int power) {
  const float parts = power == 2 ? samples * samples : samples;
  return samples > 0 ? foredraw_lod_within_1(1 - base_error / parts) : 0;
}

/* Of a level whose measured error is so many pixels on the screen: 1 for none, a half for one, 0 for no number. */
static inline float foredraw_lod_accuracy_of_error(float pixels) {
  return pixels > 0 ? 1 / (1 + pixels) : pixels <= 0 ? 1 : 0;
}

/* Less at the rim of the screen than in its middle. from_middle: 0 to 1, no number is the rim; least: what an object at
 * the rim is worth. */
static inline float foredraw_lod_focus(float from_middle, float least) {
  const float aside = from_middle < 1 ? foredraw_lod_within_1(from_middle) : 1;
  return 1 - (1 - foredraw_lod_within_1(least)) * aside;
}

/* What moves fast past the eye is blurred. `speed`: pixels a frame; `size`: pixels across. 0 for no number. */
static inline float foredraw_lod_motion(float speed, float size) {
  return speed <= 0 ? 1 : size > 0 ? foredraw_lod_within_1(size / (size + speed)) : 0;
}

/* Another level than in the last frame is worth a little less, so that levels do not flicker. `weight`: for each level
 * of difference. */
static inline float foredraw_lod_hysteresis(int levels_from_last, float weight) {
  return foredraw_lod_within_1(1 - weight * fabsf((float)levels_from_last));
}

/* Hysteresis by what is lost: the benefit of the way of the last frame, as if so large a part of what is missing to the
 * benefit of the object's best way were there (weight: 0 to 1). Other ways stay as they are. So a choice loses at most
 * 1 / (1 - weight) times what the best choice would. The paper's, above, is a part of the benefit itself, most of which
 * coarse levels have too: it may hold one that loses many times as much as the one that would be chosen. */
static inline float foredraw_lod_held(float benefit, float best, float weight) {
  return best > benefit ? benefit + foredraw_lod_within_1(weight) * (best - benefit) : benefit;
}

/* As lod_select.h has it: whole numbers, here below 2^31. */
static inline uint32_t foredraw_lod_whole(double value, uint32_t if_none) {
  if (!(value == value)) return if_none;
  return value <= 0 ? 0 : value < 2147483647.0 ? (uint32_t)(value + 0.5) : 2147483647u;
}
static inline uint32_t foredraw_lod_cost(float nanoseconds) {
  return foredraw_lod_whole((double)nanoseconds, 2147483647u);
}
/* In 64ths of a pixel that is shown right. */
static inline uint32_t foredraw_lod_benefit(float pixels) { return foredraw_lod_whole(64.0 * (double)pixels, 0); }

#endif
