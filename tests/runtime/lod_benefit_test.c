/* Each factor alone, and what a frame makes of them. */
#include "check.h"

#include <foredraw/runtime/lod_benefit.h>
#include <foredraw/runtime/lod_select.h>

#include <stdlib.h>

static int near(float a, float b) { return fabsf(a - b) <= 1e-6f * (1 + fabsf(b)); }

static void costs(void) {
  const foredraw_lod_rendering full = {2, 1, 0.5f};
  CHECK(near(foredraw_lod_pipeline(&full, 100, 60, 400), 260)); /* triangles and vertices take longer than pixels */
  CHECK(near(foredraw_lod_pipeline(&full, 100, 60, 4000), 2000));
  CHECK(near(foredraw_lod_pipeline(&full, 10, 6, 4000), 2000)); /* fewer triangles save nothing then */
  CHECK(near(foredraw_lod_sum(&full, 100, 60, 400), 460));
}

static void factors(void) {
  CHECK(near(foredraw_lod_accuracy_of_samples(100, 5, 1), 0.95f));
  CHECK(near(foredraw_lod_accuracy_of_samples(10, 5, 2), 0.95f));
  CHECK(foredraw_lod_accuracy_of_samples(3, 5, 1) == 0); /* never below 0 */
  CHECK(foredraw_lod_accuracy_of_samples(0, 5, 1) == 0);
  CHECK(foredraw_lod_accuracy_of_error(0) == 1 && near(foredraw_lod_accuracy_of_error(1), 0.5f));
  CHECK(foredraw_lod_accuracy_of_error(3) < foredraw_lod_accuracy_of_error(2));
  CHECK(foredraw_lod_focus(0, 0.25f) == 1 && near(foredraw_lod_focus(1, 0.25f), 0.25f));
  CHECK(near(foredraw_lod_focus(2, 0.25f), 0.25f) && foredraw_lod_focus(0.7f, 1) == 1);
  CHECK(foredraw_lod_motion(0, 10) == 1 && near(foredraw_lod_motion(10, 10), 0.5f) && foredraw_lod_motion(1, 0) == 0);
  CHECK(foredraw_lod_hysteresis(0, 0.1f) == 1 && near(foredraw_lod_hysteresis(-2, 0.1f), 0.8f));
  CHECK(near(foredraw_lod_hysteresis(2, 0.1f), 0.8f) && foredraw_lod_hysteresis(20, 0.1f) == 0);
  CHECK(foredraw_lod_held(90, 100, 0) == 90 && near(foredraw_lod_held(90, 100, 0.3f), 93));
  CHECK(foredraw_lod_held(90, 100, 1) == 100 && foredraw_lod_held(100, 100, 0.3f) == 100);
}

static void whole_numbers(void) {
  const float none = (float)NAN;
  CHECK(foredraw_lod_cost(12.4f) == 12 && foredraw_lod_cost(-1) == 0);
  CHECK(foredraw_lod_cost(1e20f) == 2147483647u && foredraw_lod_cost(none) == 2147483647u);
  CHECK(foredraw_lod_benefit(2) == 128 && foredraw_lod_benefit(none) == 0);
  CHECK(foredraw_lod_benefit((float)INFINITY) == 2147483647u);
}

/* An object of two levels, full detail and a tenth, each with and without its normal map. */
static uint32_t chosen_of(float triangles, float pixels, float error_in_pixels, float budget) {
  const foredraw_lod_rendering full = {1, 1, 2}, plain = {1, 1, 0.5f};
  const float without_map = 0.7f; /* how near the rendering comes to the full one, measured */
  foredraw_lod_way ways[4];
  const uint32_t first[2] = {0, 4};
  foredraw_lod_scene scene = {1, NULL, NULL};
  uint32_t chosen, w;
  void* memory;
  for (w = 0; w < 4; ++w) {
    const float left = w < 2 ? triangles : triangles / 10;
    const float accuracy = foredraw_lod_accuracy_of_error(w < 2 ? 0 : error_in_pixels) * (w % 2 ? without_map : 1);
    ways[w].cost = foredraw_lod_cost(foredraw_lod_pipeline(w % 2 ? &plain : &full, left, left / 2, pixels));
    ways[w].benefit = foredraw_lod_benefit(pixels * accuracy);
  }
  scene.first = first;
  scene.ways = ways;
  memory = malloc(foredraw_lod_memory(&scene));
  foredraw_lod_select(&scene, (uint64_t)budget, &chosen, memory);
  free(memory);
  return chosen;
}

/* Near, pixels take the time: a coarser level would save nothing, a cheaper rendering does. Far, it is the triangles.
 */
static void renderings_and_levels(void) {
  CHECK(chosen_of(10000, 100000, 0.2f, 200000) == 0); /* full */
  CHECK(chosen_of(10000, 100000, 4, 60000) == 1);     /* the cheaper rendering of full detail */
  CHECK(chosen_of(10000, 1000, 0.2f, 3000) == 2);     /* the coarser level in full */
}

int lod_benefit_test(void) {
  costs();
  factors();
  whole_numbers();
  renderings_and_levels();
  return failures == 0 ? 0 : 1;
}
