/* Renderings are ways, as levels are: where a cheaper one is right and a coarser level wrong, and the other way round;
 * and classes of characters that share one choice. */
#include "check.h"

#include <foredraw/runtime/lod_benefit.h>
#include <foredraw/runtime/lod_select.h>

enum { full, plain, coarse, coarse_and_plain, ways };

typedef float (*cost_of)(const foredraw_lod_rendering* rendering, float triangles, float vertices, float pixels);

typedef struct {
  float triangles, pixels, error; /* the coarse level has an eighth of them, and that many pixels of error */
  float accuracy_of_plain;
} object;

static uint64_t memory[20000];

static foredraw_lod_way way_of(const object* one, cost_of cost, uint32_t way) {
  static const foredraw_lod_rendering with_map = {1, 1, 2}, without = {1, 1, 0.5f};
  const int is_coarse = way >= coarse, is_plain = way % 2 != 0;
  const float left = is_coarse ? one->triangles / 8 : one->triangles;
  foredraw_lod_way made;
  made.cost = foredraw_lod_cost(cost(is_plain ? &without : &with_map, left, left / 2, one->pixels));
  made.benefit = foredraw_lod_benefit(one->pixels * foredraw_lod_accuracy_of_error(is_coarse ? one->error : 0) *
                                      (is_plain ? one->accuracy_of_plain : 1));
  return made;
}

static uint32_t chosen_of(const object* one, cost_of cost, uint64_t budget) {
  static const uint32_t first[2] = {0, ways};
  foredraw_lod_way all[ways];
  foredraw_lod_scene scene = {1, first, all};
  foredraw_lod_result result;
  uint32_t way, chosen;
  for (way = 0; way < ways; ++way) all[way] = way_of(one, cost, way);
  result = foredraw_lod_select(&scene, budget, &chosen, memory);
  CHECK(!result.is_over && result.cost == all[chosen].cost && result.benefit == all[chosen].benefit);
  return chosen;
}

/* A wall before the eye: few triangles, many pixels. A coarser level saves nothing at all of the larger of both, and a
 * little of their sum; the budget is kept by the cheaper rendering alone, in full detail. */
static void bound_by_pixels(void) {
  const object wall = {1000, 100000, 0.05f, 0.6f}; /* the coarse level would look better than the plain rendering */
  CHECK(way_of(&wall, foredraw_lod_pipeline, coarse).cost == way_of(&wall, foredraw_lod_pipeline, full).cost);
  CHECK(way_of(&wall, foredraw_lod_sum, coarse).cost < way_of(&wall, foredraw_lod_sum, full).cost);
  CHECK(way_of(&wall, foredraw_lod_sum, coarse).benefit > way_of(&wall, foredraw_lod_sum, plain).benefit);
  CHECK(chosen_of(&wall, foredraw_lod_pipeline, 200000) == full && chosen_of(&wall, foredraw_lod_sum, 201500) == full);
  CHECK(chosen_of(&wall, foredraw_lod_pipeline, 199999) == plain);
  CHECK(chosen_of(&wall, foredraw_lod_pipeline, 50000) == plain);
  CHECK(chosen_of(&wall, foredraw_lod_sum, 199999) == plain);
  CHECK(chosen_of(&wall, foredraw_lod_sum, 51500) == plain);
  CHECK(chosen_of(&wall, foredraw_lod_sum, 51499) == coarse_and_plain); /* now the level helps too */
}

/* A tree far away: many triangles on few pixels. */
static void bound_by_triangles(void) {
  const object tree = {100000, 1000, 1, 0.9f}; /* the plain rendering would look better than the coarse level */
  CHECK(way_of(&tree, foredraw_lod_pipeline, plain).cost == way_of(&tree, foredraw_lod_pipeline, full).cost);
  CHECK(way_of(&tree, foredraw_lod_sum, plain).cost < way_of(&tree, foredraw_lod_sum, full).cost);
  CHECK(way_of(&tree, foredraw_lod_sum, plain).benefit > way_of(&tree, foredraw_lod_sum, coarse).benefit);
  CHECK(chosen_of(&tree, foredraw_lod_pipeline, 150000) == full && chosen_of(&tree, foredraw_lod_sum, 152000) == full);
  CHECK(chosen_of(&tree, foredraw_lod_pipeline, 149999) == coarse);
  CHECK(chosen_of(&tree, foredraw_lod_pipeline, 18750) == coarse);
  CHECK(chosen_of(&tree, foredraw_lod_sum, 150000) == coarse);
  CHECK(chosen_of(&tree, foredraw_lod_sum, 20750) == coarse);
  CHECK(chosen_of(&tree, foredraw_lod_sum, 20749) == coarse_and_plain);
}

/* Where both take as long, the larger of both falls only with both of them; their sum with either. */
static void bound_by_both(void) {
  const object statue = {40000, 30000, 0.2f, 0.8f};
  CHECK(chosen_of(&statue, foredraw_lod_pipeline, 60000) == full);
  CHECK(chosen_of(&statue, foredraw_lod_pipeline, 59999) == coarse_and_plain);
  CHECK(chosen_of(&statue, foredraw_lod_sum, 119999) == coarse);
  CHECK(chosen_of(&statue, foredraw_lod_sum, 67499) == coarse_and_plain);
}

/* One frame with all of them, and time for a part: each gives what costs it least. */
static void side_by_side(void) {
  static const object all[2] = {{1000, 100000, 0.5f, 0.8f}, {100000, 1000, 0.5f, 0.8f}};
  static const uint32_t first[3] = {0, ways, 2 * ways};
  foredraw_lod_way both[2 * ways];
  foredraw_lod_scene scene = {2, first, both};
  uint32_t way, chosen[2];
  for (way = 0; way < 2 * ways; ++way) both[way] = way_of(&all[way / ways], foredraw_lod_pipeline, way % ways);
  foredraw_lod_select(&scene, 200000 + 18750, chosen, memory);
  CHECK(chosen[0] == full && chosen[1] == coarse); /* pixels of the wall show more for their time */
  foredraw_lod_select(&scene, 50000 + 18750, chosen, memory);
  CHECK(chosen[0] == plain && chosen[1] == coarse);
}

/* Characters that are displaced copies of a few share their class's choice: what the class costs is what one of them
 * does, times their number, and it is worth what they are worth together. */
static void crowds(void) {
  enum { classes = 3, levels = 3 };
  static const float triangles[levels] = {1000, 4000, 16000}, error[levels] = {0.08f, 0.02f, 0}; /* units */
  static const uint32_t count[classes] = {50, 10, 2}, first[classes + 1] = {0, levels, 2 * levels, 3 * levels};
  static const float away[classes] = {80, 20, 5}; /* of the first of them; each next one is a hundredth farther */
  const foredraw_lod_rendering rendering = {1, 0, 0};
  foredraw_lod_way of_class[classes * levels];
  foredraw_lod_scene scene = {classes, first, of_class};
  uint32_t one, member, level, chosen[classes];
  uint64_t budget, cost = 0;
  foredraw_lod_result result;
  for (one = 0; one < classes; ++one) {
    for (level = 0; level < levels; ++level) {
      foredraw_lod_way* way = &of_class[one * levels + level];
      float benefit = 0;
      for (member = 0; member < count[one]; ++member) {
        const float pixels_a_unit = 935 / (away[one] * (1 + 0.01f * (float)member));
        benefit += pixels_a_unit * pixels_a_unit * foredraw_lod_accuracy_of_error(error[level] * pixels_a_unit);
      }
      way->cost = foredraw_lod_cost((float)count[one] *
                                    foredraw_lod_pipeline(&rendering, triangles[level], triangles[level] / 2, 0));
      way->benefit = foredraw_lod_benefit(benefit);
    }
  }
  budget = 62 * 1000 + 10 * 3000 + 2 * 15000;
  result = foredraw_lod_select(&scene, budget, chosen, memory);
  for (one = 0; one < classes; ++one) cost += (uint64_t)count[one] * (uint64_t)triangles[chosen[one]];
  CHECK(cost == result.cost && cost <= budget); /* what is drawn, character by character */
  CHECK(chosen[0] == 0 && chosen[1] == 1 && chosen[2] == 2);
  CHECK(foredraw_lod_select(&scene, 61999, chosen, memory).is_over);
  CHECK(foredraw_lod_cost(1e6f * 16000) == 2147483647u); /* a million characters are dear, and do not wrap around */
}

int lod_renderings_test(void) {
  bound_by_pixels();
  bound_by_triangles();
  bound_by_both();
  side_by_side();
  crowds();
  return failures == 0 ? 0 : 1;
}
