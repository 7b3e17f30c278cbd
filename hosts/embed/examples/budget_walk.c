/* Walks a camera through a city of 10,000 objects, and draws each frame within a budget: which object at which level,
 * and with or without its normal map. Says what the frames cost, and how near they come to the best there is.
 *
 *   budget_walk [milliseconds a frame, 4] [frames, 120]
 *
 * Levels are what `foredraw optimize -p @levels` writes: numbers of triangles, and errors in units. The city is made
 * up, so nothing is drawn: costs are what a machine was measured to take. */

#include <foredraw/runtime/lod_benefit.h>
#include <foredraw/runtime/lod_select.h>

#include <stdio.h>
#include <stdlib.h>

enum { side = 100, objects = side * side, levels = 5, ways = 2 * levels };

/* Nanoseconds of each rendering, and how near the plain one comes to the full one. */
static const foredraw_lod_rendering full = {1.5f, 1.0f, 0.9f}, plain = {1.5f, 1.0f, 0.3f};
static const float accuracy_of_plain = 0.8f;

static foredraw_lod_way way[objects * ways], held[objects * ways]; /* held: with hysteresis */
static uint32_t first[objects + 1], number[objects], last[objects], before[objects], chosen[objects];

/* The ways of an object, as it is seen from there. Way 2 * level is the full rendering. */
static void add_ways(uint32_t object, uint32_t visible, float away, float from_middle) {
  const float radius = 3 + (float)(object * 7919u % 13), triangles = 500 + (float)(object * 104729u % 20000);
  const float pixels_a_unit = 935 / away; /* of a picture of 1080 lines, 60 degrees high */
  const float pixels = 3.14159f * radius * radius * pixels_a_unit * pixels_a_unit;
  const float best = pixels * foredraw_lod_focus(from_middle, 0.5f);
  uint32_t i;
  for (i = first[visible]; i < first[visible] + ways; ++i) {
    const int level = (int)(i % ways / 2), is_plain = i % 2;
    const float left = triangles / (float)(1 << (2 * level)), error = level == 0 ? 0 : 2 * radius / sqrtf(left);
    const float benefit =
        best * foredraw_lod_accuracy_of_error(error * pixels_a_unit) * (is_plain ? accuracy_of_plain : 1);
    way[i].cost = held[i].cost =
        foredraw_lod_cost(foredraw_lod_pipeline(is_plain ? &plain : &full, left, left / 2, pixels));
    way[i].benefit = foredraw_lod_benefit(benefit);
    held[i].benefit = foredraw_lod_benefit(foredraw_lod_held(benefit, best, i % ways == last[object] ? 0.1f : 0));
  }
  number[visible] = object;
  before[visible] = last[object];
  first[visible + 1] = first[visible] + ways;
}

int main(int argc, char** argv) {
  const uint64_t budget = (uint64_t)(1e6 * (argc > 1 ? strtod(argv[1], NULL) : 4));
  const unsigned long frames = argc > 2 ? strtoul(argv[2], NULL, 10) : 120;
  foredraw_lod_scene scene = {objects, first, way}, calm = {objects, first, held};
  unsigned long frame;
  void* memory;
  uint32_t i;
  for (i = 0; i <= objects; ++i) first[i] = i * ways;
  memory = malloc(foredraw_lod_memory(&scene)); /* for all of them, once */
  for (frame = 0; frame < frames; ++frame) {
    const float eye_x = (float)side * 10, eye_z = 20 * (float)side * (float)frame / (float)frames;
    uint32_t visible = 0, switched = 0, without_map = 0;
    foredraw_lod_result result;
    uint64_t bound;
    for (i = 0; i < objects; ++i) {
      const float x = 20 * (float)(i % side) - eye_x, z = 20 * (float)(i / side) - eye_z;
      if (z > 1 && fabsf(x) < z + 16) add_ways(i, visible++, sqrtf(x * x + z * z), fabsf(x) / (z + 16));
    }
    scene.objects = calm.objects = visible;
    bound = foredraw_lod_select(&scene, budget, chosen, memory).bound; /* to be printed */
    foredraw_lod_select(&calm, budget - budget / 200, chosen, memory); /* the rest is for the frames to come */
    if (foredraw_lod_may_keep(&scene, budget, before, chosen, 0.05)) memcpy(chosen, before, sizeof chosen);
    result = foredraw_lod_kept(&scene, budget, chosen);
    for (i = 0; i < visible; ++i) { /* draw(number[i], level chosen[i] / 2, rendering chosen[i] % 2) */
      switched += chosen[i] / 2 != last[number[i]] / 2;
      without_map += chosen[i] % 2;
      last[number[i]] = chosen[i];
    }
    if (frame % (frames / 8 + 1) == 0)
      printf("frame %3lu: %4u visible, %5.2f ms%s, %.4f of the best there can be, %u without normal map, %u switched\n",
             frame, visible, 1e-6 * (double)result.cost, result.is_over ? " (the least)" : "",
             (double)result.benefit / (double)(bound ? bound : 1), without_map, switched);
  }
  free(memory);
  return 0;
}
