/* The ways of choosing that lod_select.h is compared with. */
#include "check.h"

#include <benchmarks/lod_select/lod_methods.h>
#include <foredraw/runtime/lod_methods.h>

#include <stdlib.h>

static uint64_t state = 1;
static uint32_t drawn(uint32_t below) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (uint32_t)((state >> 33) % below);
}

static void by_size_and_feedback(void) {
  const uint32_t triangles[4] = {8000, 2000, 500, 100};
  CHECK(foredraw_lod_by_size(triangles, 4, 50, 1) == 3);
  CHECK(foredraw_lod_by_size(triangles, 4, 499, 1) == 2 && foredraw_lod_by_size(triangles, 4, 501, 1) == 1);
  CHECK(foredraw_lod_by_size(triangles, 4, 100000, 1) == 0 && foredraw_lod_by_size(triangles, 1, 0, 1) == 0);
  CHECK(foredraw_lod_fed_back(4, 15, 10) == 6 && foredraw_lod_fed_back(4, 100, 10) == 8);
  CHECK(foredraw_lod_fed_back(4, 1, 10) == 2 && foredraw_lod_fed_back(4, 1, 0) == 4);
}

enum { objects = 300, ways = 5 };
typedef struct {
  foredraw_lod_way way[objects * ways];
  uint32_t first[objects + 1];
  foredraw_lod_scene scene;
  uint64_t least, most;
} frame;

/* Benefits that rise less and less, or in jumps. */
static void draw_frame(frame* one, int has_jumps) {
  uint32_t i, w;
  one->least = one->most = 0;
  for (i = 0; i < objects; ++i) {
    const uint32_t size = 1 + drawn(1000), triangles = 16 + drawn(5000);
    one->first[i] = i * ways;
    for (w = 0; w < ways; ++w) {
      foredraw_lod_way* way = &one->way[i * ways + w];
      way->cost = triangles >> (ways - 1 - w);
      way->benefit = has_jumps ? size * (w < 3 ? w + 1 : 40 * w) : size * (100 - (100u >> (w + 1)));
    }
    one->least += one->way[i * ways].cost;
    one->most += one->way[i * ways + ways - 1].cost;
  }
  one->first[objects] = objects * ways;
  one->scene.objects = objects;
  one->scene.first = one->first;
  one->scene.ways = one->way;
}

static int adds_up(const frame* one, const uint32_t* chosen, const foredraw_lod_result* result) {
  uint64_t cost = 0, benefit = 0;
  uint32_t i;
  for (i = 0; i < objects; ++i) {
    cost += one->way[i * ways + chosen[i]].cost;
    benefit += one->way[i * ways + chosen[i]].benefit;
  }
  return cost == result->cost && benefit == result->benefit;
}

static void beside_each_other(void) {
  static frame one;
  static uint32_t chosen[objects], last[objects], memory[4 * objects * ways];
  uint32_t round;
  double by_value = 0, from_last = 0, ours = 0, far_off = 0;
  for (round = 0; round < 200; ++round) {
    foredraw_lod_result best, result;
    uint64_t budget;
    void* room;
    draw_frame(&one, round >= 100);
    budget = one.least + (one.most - one.least) * (1 + drawn(60)) / 100;
    room = malloc(foredraw_lod_memory(&one.scene));
    best = foredraw_lod_select(&one.scene, budget, chosen, room);
    free(room);
    result = foredraw_lod_by_value(&one.scene, budget, chosen, memory);
    CHECK(adds_up(&one, chosen, &result) && result.cost <= budget && !result.is_over);
    CHECK(result.benefit <= best.bound);
    if (round < 100) by_value += (double)result.benefit / (double)best.bound;
    memset(last, 0, sizeof last);
    result = foredraw_lod_from_last(&one.scene, budget, last, memory, NULL);
    CHECK(adds_up(&one, last, &result) && result.cost <= budget && !result.is_over);
    CHECK(result.benefit <= best.bound);
    if (round < 100) {
      uint32_t rounds = 0;
      from_last += (double)result.benefit / (double)best.bound;
      ours += (double)best.benefit / (double)best.bound;
      /* The same frame again: little is left to do. */
      result = foredraw_lod_from_last(&one.scene, budget, last, memory, &rounds);
      CHECK(rounds <= 3);
    } else {
      far_off += (double)result.benefit / (double)best.bound;
    }
  }
  CHECK(by_value > 95 && from_last > 95 && ours > 99.99);
  CHECK(far_off < 90); /* where a way of low value stands before one of high value */
}

static void at_the_ends(void) {
  static const foredraw_lod_way ways_of[4] = {{5, 5}, {9, 9}, {5, 5}, {9, 9}};
  static const uint32_t first[3] = {0, 2, 4};
  const foredraw_lod_scene two = {2, first, ways_of}, none = {0, first, ways_of};
  uint32_t chosen[2] = {0, 0}, memory[8];
  CHECK(foredraw_lod_from_last(&two, 9, chosen, memory, NULL).is_over && chosen[0] == 0 && chosen[1] == 0);
  CHECK(foredraw_lod_by_value(&two, 9, chosen, memory).is_over);
  chosen[0] = chosen[1] = 1; /* the last frame had more time; all values are equal */
  CHECK(foredraw_lod_from_last(&two, 14, chosen, memory, NULL).cost <= 14);
  CHECK(foredraw_lod_from_last(&two, 18, chosen, memory, NULL).benefit == 18);
  CHECK(foredraw_lod_from_last(&none, 1, chosen, memory, NULL).cost == 0);
  CHECK(foredraw_lod_by_value(&none, 1, chosen, memory).cost == 0);
}

int lod_methods_test(void) {
  by_size_and_feedback();
  beside_each_other();
  at_the_ends();
  return failures == 0 ? 0 : 1;
}
