/* Choices of levels from what should not be: no numbers, negative ones, no ways, no time, all the time there is. */
#include "check.h"

#include <foredraw/runtime/lod_benefit.h>
#include <foredraw/runtime/lod_methods.h>
#include <foredraw/runtime/lod_select.h>

#include <stdlib.h>

static foredraw_lod_result select_of(const foredraw_lod_scene* scene, uint64_t budget, uint32_t* chosen) {
  void* memory = malloc(foredraw_lod_memory(scene));
  const foredraw_lod_result result = foredraw_lod_select(scene, budget, chosen, memory);
  free(memory);
  return result;
}

static foredraw_lod_way way_of(float cost, float benefit) {
  foredraw_lod_way way;
  way.cost = foredraw_lod_cost(cost);
  way.benefit = foredraw_lod_benefit(benefit);
  return way;
}

/* A benefit that is no number is worth nothing, a cost that is none is the dearest, one below 0 is free. */
static void no_numbers(void) {
  const float none = (float)NAN, all = (float)INFINITY;
  foredraw_lod_way ways[6];
  static const uint32_t first[4] = {0, 2, 4, 6};
  const foredraw_lod_scene scene = {3, first, ways};
  uint32_t chosen[3];
  foredraw_lod_result result;
  ways[0] = way_of(1, 1);
  ways[1] = way_of(2, none);
  ways[2] = way_of(1, 1);
  ways[3] = way_of(none, 5);
  ways[4] = way_of(1, 1);
  ways[5] = way_of(-3, 2);
  result = select_of(&scene, 1000, chosen);
  CHECK(chosen[0] == 0 && chosen[1] == 0 && chosen[2] == 1);
  CHECK(result.cost == 2 && result.benefit == 64 + 64 + 128 && result.bound >= result.benefit && !result.is_over);
  CHECK(way_of(all, all).cost == 2147483647u && way_of(all, all).benefit == 2147483647u);
  CHECK(way_of(-all, -all).cost == 0 && way_of(-all, -all).benefit == 0);
}

/* No factor makes something out of no number. */
static void factors_of_no_numbers(void) {
  const float none = (float)NAN, all = (float)INFINITY;
  const foredraw_lod_rendering known = {1, 1, 1}, unknown = {none, 1, 1}, unknown_pixel = {1, 1, none};
  const uint32_t dearest = 2147483647u;
  CHECK(foredraw_lod_cost(foredraw_lod_pipeline(&known, none, 1, 1)) == dearest);
  CHECK(foredraw_lod_cost(foredraw_lod_pipeline(&known, 1, none, 1)) == dearest);
  CHECK(foredraw_lod_cost(foredraw_lod_pipeline(&known, 1, 1, none)) == dearest);
  CHECK(foredraw_lod_cost(foredraw_lod_pipeline(&unknown, 1, 1, 1)) == dearest);
  CHECK(foredraw_lod_cost(foredraw_lod_pipeline(&unknown_pixel, 1, 1, 1)) == dearest);
  CHECK(foredraw_lod_cost(foredraw_lod_sum(&known, none, 1, 1)) == dearest);
  CHECK(foredraw_lod_accuracy_of_samples(none, 1, 1) == 0 && foredraw_lod_accuracy_of_samples(4, none, 1) == 0);
  CHECK(foredraw_lod_accuracy_of_samples(4, none, 2) == 0 && foredraw_lod_accuracy_of_samples(-4, 1, 1) == 0);
  CHECK(foredraw_lod_accuracy_of_samples(4, -1, 1) == 1); /* never above 1 */
  CHECK(foredraw_lod_accuracy_of_error(none) == 0 && foredraw_lod_accuracy_of_error(all) == 0);
  CHECK(foredraw_lod_accuracy_of_error(-1) == 1);
  CHECK(foredraw_lod_focus(none, 0.25f) == 0.25f && foredraw_lod_focus(0.5f, none) == 0.5f);
  CHECK(foredraw_lod_focus(-1, 0.25f) == 1 && foredraw_lod_focus(1, 7) == 1 && foredraw_lod_focus(1, -7) == 0);
  CHECK(foredraw_lod_motion(none, 4) == 0 && foredraw_lod_motion(4, none) == 0 && foredraw_lod_motion(all, 4) == 0);
  CHECK(foredraw_lod_motion(all, all) == 0 && foredraw_lod_motion(4, -1) == 0 && foredraw_lod_motion(-4, 4) == 1);
  CHECK(foredraw_lod_hysteresis(1, none) == 0 && foredraw_lod_hysteresis(1, -4) == 1);
  CHECK(foredraw_lod_benefit(foredraw_lod_held(none, 4, 1)) == 0 && foredraw_lod_held(3, none, 1) == 3);
  CHECK(foredraw_lod_held(3, 4, none) == 3 && foredraw_lod_held(3, 4, -1) == 3 && foredraw_lod_held(3, 4, all) == 4);
  CHECK(foredraw_lod_held(3, 2, 1) == 3 && foredraw_lod_benefit(foredraw_lod_held(3, all, 0)) == 0);
  CHECK(foredraw_lod_hysteresis(INT32_MIN, 1) == 0 && foredraw_lod_hysteresis(INT32_MIN, 0) == 1);
}

/* Objects without ways are not drawn; those with one are drawn so, whatever the budget. */
static void no_ways_and_one(void) {
  static const foredraw_lod_way ways[3] = {{5, 5}, {1, 1}, {4, 9}};
  static const uint32_t first[7] = {0, 0, 1, 1, 3, 3, 3}, nothing[3] = {0, 0, 0};
  const foredraw_lod_scene scene = {6, first, ways}, empty = {2, nothing, NULL};
  uint32_t chosen[6] = {9, 9, 9, 9, 9, 9}, i;
  foredraw_lod_result result = select_of(&scene, 100, chosen);
  for (i = 0; i < 6; ++i) CHECK(chosen[i] == (i == 3 ? 1u : 0u));
  CHECK(result.cost == 9 && result.benefit == 14 && result.bound == 14 && !result.is_over);
  result = select_of(&scene, 8, chosen);
  CHECK(chosen[3] == 0 && result.cost == 6 && result.bound == 6 && !result.is_over);
  result = select_of(&scene, 5, chosen);
  CHECK(chosen[1] == 0 && result.cost == 6 && result.is_over);
  chosen[0] = chosen[1] = 9;
  result = select_of(&empty, 0, chosen);
  CHECK(chosen[0] == 0 && chosen[1] == 0 && result.cost == 0 && result.bound == 0 && !result.is_over);
}

/* Objects in front that have no ways do not take room from one that has many. */
static void room_for_one_of_many(void) {
  enum { empty = 5000, ways = 3000 };
  foredraw_lod_way* all = (foredraw_lod_way*)malloc(ways * sizeof *all);
  uint32_t* first = (uint32_t*)calloc(empty + 2, sizeof *first);
  uint32_t* chosen = (uint32_t*)malloc((empty + 1) * sizeof *chosen);
  foredraw_lod_scene scene = {empty + 1, NULL, NULL};
  foredraw_lod_result result;
  uint32_t i;
  for (i = 0; i < ways; ++i) {
    all[i].cost = i;
    all[i].benefit = i * (2 * ways - i); /* all on the hull */
  }
  first[empty + 1] = ways;
  scene.first = first;
  scene.ways = all;
  result = select_of(&scene, 2000, chosen);
  CHECK(chosen[empty] == 2000 && result.cost == 2000 && result.benefit == result.bound);
  free(all);
  free(first);
  free(chosen);
}

static void budgets(void) {
  static const foredraw_lod_way ways[4] = {{0, 1}, {3, 9}, {2, 2}, {7, 20}};
  static const uint32_t first[3] = {0, 2, 4};
  const foredraw_lod_scene scene = {2, first, ways}, free_one = {1, first, ways};
  uint32_t chosen[2];
  foredraw_lod_result result = select_of(&scene, 0, chosen);
  CHECK(result.is_over && result.cost == 2 && result.benefit == 3);
  result = select_of(&free_one, 0, chosen);
  CHECK(!result.is_over && chosen[0] == 0 && result.cost == 0 && result.bound == 1);
  result = select_of(&scene, UINT64_MAX, chosen);
  CHECK(!result.is_over && chosen[0] == 1 && chosen[1] == 1 && result.cost == 10 && result.bound == 29);
  result = select_of(&scene, 10, chosen); /* all of it, and nothing is left */
  CHECK(chosen[0] == 1 && chosen[1] == 1 && result.cost == 10 && result.bound == 29);
  result = select_of(&scene, 9, chosen);
  CHECK(chosen[0] == 0 && chosen[1] == 1 && result.cost == 7 && result.bound == 21 + (8 * 2 + 2) / 3);
}

/* The size of memory, without any. */
static void room(void) {
  static const uint32_t none[1] = {0}, most[2] = {0, UINT32_MAX}, ten_millions[2] = {0, 60000000};
  const foredraw_lod_scene no_object = {0, none, NULL}, largest = {1, most, NULL}, large = {1, ten_millions, NULL};
  const size_t base = foredraw_lod_memory(&no_object);
  CHECK(base >= FOREDRAW_LOD_BUCKETS * sizeof(foredraw_lod_bucket) && base < 1000000);
  CHECK((foredraw_lod_memory(&large) - base) / 60000000 == 24);
  if (SIZE_MAX > UINT32_MAX) {
    CHECK((foredraw_lod_memory(&largest) - base) / UINT32_MAX == 24);
  } else {
    CHECK(foredraw_lod_memory(&largest) == SIZE_MAX);
  }
}

/* 10,000,000 objects of two ways each: what fits is the steepest steps, to the last. */
static void ten_million_objects(void) {
  const uint32_t objects = 10000000, kinds = 1000;
  const uint64_t kept = 123;
  foredraw_lod_way* ways = (foredraw_lod_way*)malloc(2 * (size_t)objects * sizeof *ways);
  uint32_t* first = (uint32_t*)malloc(((size_t)objects + 1) * sizeof *first);
  uint32_t* chosen = (uint32_t*)malloc((size_t)objects * sizeof *chosen);
  foredraw_lod_scene scene = {objects, NULL, NULL};
  foredraw_lod_result result;
  uint32_t i, wrong = 0;
  for (i = 0; i < objects; ++i) {
    first[i] = 2 * i;
    ways[2 * i].cost = 1;
    ways[2 * i].benefit = 0;
    ways[2 * i + 1].cost = 11;
    ways[2 * i + 1].benefit = 1000 + i % kinds;
  }
  first[objects] = 2 * objects;
  scene.first = first;
  scene.ways = ways;
  result = select_of(&scene, objects + 10 * kept * (objects / kinds), chosen);
  for (i = 0; i < objects; ++i) wrong += chosen[i] != (i % kinds >= kinds - kept);
  CHECK(wrong == 0 && result.cost == objects + 10 * kept * (objects / kinds) && result.bound == result.benefit);
  free(ways);
  free(first);
  free(chosen);
}

/* A clock that is set back, that stands, or that tells no number, and no target. */
static void feedback(void) {
  const float none = (float)NAN, all = (float)INFINITY;
  float most = 4;
  int i;
  CHECK(foredraw_lod_fed_back(4, -5, 10) == 4 && foredraw_lod_fed_back(4, none, 10) == 4);
  CHECK(foredraw_lod_fed_back(4, 5, 0) == 4 && foredraw_lod_fed_back(4, 5, -1) == 4);
  CHECK(foredraw_lod_fed_back(4, 5, none) == 4);
  CHECK(foredraw_lod_fed_back(4, 0, 10) == 2 && foredraw_lod_fed_back(4, all, 10) == 8);
  CHECK(foredraw_lod_fed_back(none, 10, 10) > 0 && foredraw_lod_fed_back(-4, 10, 10) > 0);
  for (i = 0; i < 1000; ++i) most = foredraw_lod_fed_back(most, 0, 10); /* a view of nothing, for a while */
  CHECK(most == 1.0f / 1024);
  for (i = 0; i < 12; ++i) most = foredraw_lod_fed_back(most, 30, 10);
  CHECK(most == 4);
  for (i = 0; i < 1000; ++i) most = foredraw_lod_fed_back(most, 30, 10);
  CHECK(most == 16777216.0f && foredraw_lod_fed_back(most, 1, 10) == 8388608.0f);
}

static void sizes(void) {
  static const uint32_t triangles[3] = {100, 10, 0};
  CHECK(foredraw_lod_by_size(triangles, 0, 50, 1) == 0 && foredraw_lod_by_size(triangles, 1, 0, 1) == 0);
  CHECK(foredraw_lod_by_size(triangles, 3, (float)NAN, 1) == 0 && foredraw_lod_by_size(triangles, 3, -1, 1) == 2);
  CHECK(foredraw_lod_by_size(triangles, 3, 5, (float)NAN) == 0);
}

int lod_hostile_test(void) {
  no_numbers();
  factors_of_no_numbers();
  no_ways_and_one();
  room_for_one_of_many();
  budgets();
  room();
  ten_million_objects();
  feedback();
  sizes();
  return failures == 0 ? 0 : 1;
}
