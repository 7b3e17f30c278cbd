/* Choices beside the best ones, which are found by trying all. */
#include "check.h"

#include <foredraw/runtime/lod_select.h>

#include <math.h>
#include <stdlib.h>

enum { most_objects = 6, most_ways = 5 };

static uint64_t state = 1;
static uint32_t drawn(uint32_t below) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (uint32_t)((state >> 33) % below);
}

typedef struct {
  foredraw_lod_way ways[most_objects * most_ways];
  uint32_t first[most_objects + 1];
  foredraw_lod_scene scene;
} instance;

static void point(instance* one, uint32_t objects) {
  one->scene.objects = objects;
  one->scene.first = one->first;
  one->scene.ways = one->ways;
}

/* Few costs and benefits, so that many are equal, or many. */
static void draw_instance(instance* one) {
  const uint32_t objects = 1 + drawn(most_objects), costs = drawn(2) ? 8 : 1000, benefits = drawn(2) ? 6 : 100000;
  uint32_t i, w;
  one->first[0] = 0;
  for (i = 0; i < objects; ++i) {
    one->first[i + 1] = one->first[i] + 1 + drawn(most_ways);
    for (w = one->first[i]; w < one->first[i + 1]; ++w) {
      one->ways[w].cost = drawn(costs);
      one->ways[w].benefit = drawn(benefits);
    }
  }
  point(one, objects);
}

static foredraw_lod_result select_of(const instance* one, uint64_t budget, uint32_t* chosen) {
  void* memory = malloc(foredraw_lod_memory(&one->scene));
  const foredraw_lod_result result = foredraw_lod_select(&one->scene, budget, chosen, memory);
  free(memory);
  return result;
}

/* The most benefit within the budget; -1: there is none. */
static int64_t best_of(const instance* one, uint64_t budget) {
  uint32_t choice[most_objects] = {0}, i;
  int64_t best = -1;
  for (;;) {
    uint64_t cost = 0, benefit = 0;
    for (i = 0; i < one->scene.objects; ++i) {
      cost += one->ways[one->first[i] + choice[i]].cost;
      benefit += one->ways[one->first[i] + choice[i]].benefit;
    }
    if (cost <= budget && (int64_t)benefit > best) best = (int64_t)benefit;
    for (i = 0; i < one->scene.objects && ++choice[i] == one->first[i + 1] - one->first[i]; ++i) choice[i] = 0;
    if (i == one->scene.objects) return best;
  }
}

static void beside_the_best(void) {
  uint32_t round, chosen[most_objects], i;
  uint64_t sum = 0, most = 0;
  for (round = 0; round < 20000; ++round) {
    instance one;
    foredraw_lod_result result;
    uint64_t budget, cost = 0, benefit = 0, least_cost = 0, least_benefit = 0, step = 0;
    int64_t best;
    draw_instance(&one);
    for (i = 0; i < one.scene.objects; ++i) {
      const foredraw_lod_way* ways = one.ways + one.first[i];
      const uint32_t n = one.first[i + 1] - one.first[i], cheapest = foredraw_lod_cheapest(ways, n);
      uint32_t w;
      least_cost += ways[cheapest].cost;
      least_benefit += ways[cheapest].benefit;
      for (w = 0; w < n; ++w)
        if (ways[w].benefit > ways[cheapest].benefit && ways[w].benefit - ways[cheapest].benefit > step)
          step = ways[w].benefit - ways[cheapest].benefit;
    }
    budget = drawn(4) == 0 ? drawn(10) : least_cost + drawn(4000) * (uint64_t)drawn(2);
    result = select_of(&one, budget, chosen);
    best = best_of(&one, budget);
    for (i = 0; i < one.scene.objects; ++i) {
      CHECK(chosen[i] < one.first[i + 1] - one.first[i]);
      cost += one.ways[one.first[i] + chosen[i]].cost;
      benefit += one.ways[one.first[i] + chosen[i]].benefit;
    }
    CHECK(cost == result.cost && benefit == result.benefit);
    CHECK(result.is_over == (best < 0));
    CHECK(result.is_over ? cost == least_cost : cost <= budget);
    if (result.is_over) continue;
    CHECK(result.bound >= (uint64_t)best);
    CHECK(result.bound <= result.benefit + step);
    CHECK(2 * (result.benefit - least_benefit) >= (uint64_t)best - least_benefit);
    sum += result.benefit - least_benefit;
    most += (uint64_t)best - least_benefit;
  }
  CHECK(sum * 100 >= most * 97);
}

/* Beyond all costs everything is at its best; no budget leaves the cheapest. */
static void at_the_ends(void) {
  instance one = {{{5, 10}, {1, 2}, {9, 11}, {3, 3}, {3, 8}, {7, 8}}, {0, 3, 6}, {0, NULL, NULL}};
  uint32_t chosen[2];
  foredraw_lod_result result;
  point(&one, 2);
  result = select_of(&one, UINT64_MAX / 2, chosen);
  CHECK(chosen[0] == 2 && chosen[1] == 1); /* (7, 8) is no better than (3, 8) */
  CHECK(result.benefit == 19 && result.bound == 19 && !result.is_over);
  result = select_of(&one, 4, chosen);
  CHECK(chosen[0] == 1 && chosen[1] == 1 && result.cost == 4 && !result.is_over);
  result = select_of(&one, 3, chosen);
  CHECK(chosen[0] == 1 && chosen[1] == 1 && result.cost == 4 && result.is_over);
  point(&one, 0);
  result = select_of(&one, 0, chosen);
  CHECK(result.cost == 0 && result.benefit == 0 && result.bound == 0 && !result.is_over);
}

/* A way that is never worth its cost is left out, though it would fit: the raw steps rise there. */
static void by_the_hull(void) {
  instance one = {{{0, 0}, {10, 1}, {11, 100}, {0, 0}, {10, 50}}, {0, 3, 5}, {0, NULL, NULL}};
  uint32_t chosen[2];
  point(&one, 2);
  select_of(&one, 11, chosen);
  CHECK(chosen[0] == 2 && chosen[1] == 0);
  select_of(&one, 10, chosen);
  CHECK(chosen[0] == 0 && chosen[1] == 1);
}

/* A small step that gains a little more for its cost must not keep out a large one. */
static void half_at_least(void) {
  instance one = {{{0, 0}, {1, 2}, {0, 0}, {1000, 1000}}, {0, 2, 4}, {0, NULL, NULL}};
  uint32_t chosen[2];
  foredraw_lod_result result;
  point(&one, 2);
  result = select_of(&one, 1000, chosen);
  CHECK(chosen[0] == 0 && chosen[1] == 1 && result.benefit == 1000 && result.bound == 1001);
}

/* The largest numbers. */
static void at_the_limits(void) {
  const uint32_t most = 0x7fffffffu;
  instance one = {{{0, 0}, {most, most}, {0, 0}, {1, most}, {0, 0}, {most, 1}}, {0, 2, 4, 6}, {0, NULL, NULL}};
  uint32_t chosen[3];
  foredraw_lod_result result;
  point(&one, 3);
  result = select_of(&one, (uint64_t)most + 1, chosen);
  CHECK(chosen[0] == 1 && chosen[1] == 1 && chosen[2] == 0);
  CHECK(result.benefit == 2 * (uint64_t)most && result.bound == result.benefit);
}

/* An earlier choice, in a scene that has changed since. */
static void kept(void) {
  instance one = {{{5, 10}, {1, 2}, {9, 11}, {3, 3}}, {0, 3, 3, 4}, {0, NULL, NULL}};
  const uint32_t chosen[3] = {2, 0, 0};
  foredraw_lod_result result;
  point(&one, 3);
  result = foredraw_lod_kept(&one.scene, 12, chosen);
  CHECK(result.cost == 12 && result.benefit == 14 && result.bound == UINT64_MAX && !result.is_over);
  CHECK(foredraw_lod_kept(&one.scene, 11, chosen).is_over);
}

/* The best ways are worth 100 and 1000; the new choice loses 10 of them. */
static void kept_for_its_loss(void) {
  instance one = {{{1, 100}, {0, 91}, {0, 80}, {3, 1000}, {2, 990}, {1, 985}}, {0, 3, 6}, {0, NULL, NULL}};
  const uint32_t next[2] = {0, 1}, a_tenth_more[2] = {1, 0}, half_more[2] = {0, 2}, best[2] = {0, 0};
  point(&one, 2);
  CHECK(foredraw_lod_may_keep(&one.scene, 3, next, next, 0));
  CHECK(foredraw_lod_may_keep(&one.scene, 3, a_tenth_more, next, 0)); /* it loses 9 */
  CHECK(foredraw_lod_may_keep(&one.scene, 3, next, a_tenth_more, 0.12));
  CHECK(!foredraw_lod_may_keep(&one.scene, 3, next, a_tenth_more, 0.11));
  CHECK(foredraw_lod_may_keep(&one.scene, 3, half_more, next, 0.5));
  CHECK(!foredraw_lod_may_keep(&one.scene, 3, half_more, next, 0.49)); /* though it has 99.5 % of the benefit */
  CHECK(!foredraw_lod_may_keep(&one.scene, 1, half_more, next, 0.5));  /* it does not fit */
  /* There is time for everything: only what is as good stays. */
  CHECK(foredraw_lod_may_keep(&one.scene, 4, best, best, 0.1));
  CHECK(!foredraw_lod_may_keep(&one.scene, 4, a_tenth_more, best, 1e9));
  CHECK(!foredraw_lod_may_keep(&one.scene, 3, next, next, NAN));
  one.scene.objects = 0;
  CHECK(foredraw_lod_may_keep(&one.scene, 0, next, next, 0));
}

/* 20,000 objects: more budget is never worse, and the gap to the bound is one step of them. */
static void many_objects(void) {
  enum { objects = 20000, ways = 6 };
  foredraw_lod_way* all = (foredraw_lod_way*)malloc(objects * ways * sizeof *all);
  uint32_t* first = (uint32_t*)malloc((objects + 1) * sizeof *first);
  uint32_t* chosen = (uint32_t*)malloc(objects * sizeof *chosen);
  foredraw_lod_scene scene;
  uint64_t all_cost = 0, before = 0;
  void* memory;
  uint32_t i, w, tenth;
  for (i = 0; i < objects; ++i) {
    const uint32_t size = 1 + drawn(10000), triangles = 100 + drawn(20000);
    first[i] = i * ways;
    for (w = 0; w < ways; ++w) {
      all[i * ways + w].cost = triangles >> w;
      all[i * ways + w].benefit = size * (1000 - (1000u >> (ways - w)));
    }
    all_cost += triangles;
  }
  first[objects] = objects * ways;
  scene.objects = objects;
  scene.first = first;
  scene.ways = all;
  memory = malloc(foredraw_lod_memory(&scene));
  for (tenth = 1; tenth <= 10; ++tenth) {
    const foredraw_lod_result result = foredraw_lod_select(&scene, all_cost * tenth / 10, chosen, memory);
    CHECK(result.cost <= all_cost * tenth / 10 && result.benefit >= before);
    CHECK((result.bound - result.benefit) * 1000000 < result.bound);
    before = result.benefit;
  }
  free(all);
  free(first);
  free(chosen);
  free(memory);
}

int lod_select_test(void) {
  beside_the_best();
  at_the_ends();
  by_the_hull();
  half_at_least();
  at_the_limits();
  kept();
  kept_for_its_loss();
  many_objects();
  return failures == 0 ? 0 : 1;
}
