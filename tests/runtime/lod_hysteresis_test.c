/* Levels that stay: a camera that trembles, one that comes near, and what becomes of hysteresis after the hull. */
#include "check.h"

#include <foredraw/runtime/lod_benefit.h>
#include <foredraw/runtime/lod_select.h>

#include <stdlib.h>

enum { objects = 400, near_ones = 8, levels = 5 };

static uint64_t state;
static float drawn(void) { /* 0 to 1 */
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (float)(state >> 40) / 16777216.0f;
}

/* A field of objects, and how it is looked at. */
typedef struct {
  float away[objects], radius[objects], triangles[objects];
  float pixel;          /* nanoseconds; 0: triangles take all the time */
  float weight;         /* of hysteresis */
  uint64_t full, least; /* what full detail and the coarsest levels cost */
  foredraw_lod_way plain_ways[objects * levels], ways[objects * levels]; /* without and with hysteresis */
  uint32_t first[objects + 1], last[objects], chosen[objects];
  foredraw_lod_scene plain, scene;
  void* memory;
} field;

static void make_field(field* all, float pixel, float weight) {
  uint32_t i;
  state = 1;
  for (i = 0; i < objects; ++i) {
    const float x = 200 * drawn() - 100, z = 20 + 300 * drawn();
    all->away[i] = sqrtf(x * x + z * z);
    all->radius[i] = 1 + 2 * drawn();
    all->triangles[i] = 2000 + 20000 * drawn();
    all->last[i] = levels; /* none */
  }
  for (i = 0; i <= objects; ++i) all->first[i] = i * levels;
  all->pixel = pixel;
  all->weight = weight;
  all->scene.objects = objects;
  all->scene.first = all->first;
  all->scene.ways = all->ways;
  all->plain = all->scene;
  all->plain.ways = all->plain_ways;
  all->memory = malloc(foredraw_lod_memory(&all->scene));
}

/* As it is seen from there; `nearer` is a factor of all distances. */
static void see(field* all, float nearer) {
  const foredraw_lod_rendering rendering = {1.5f, 1, all->pixel};
  uint32_t i;
  int level;
  all->full = all->least = 0;
  for (i = 0; i < objects; ++i) {
    const float pixels_a_unit = 935 / (nearer * all->away[i]);
    const float pixels = 3.14159f * all->radius[i] * all->radius[i] * pixels_a_unit * pixels_a_unit;
    for (level = 0; level < levels; ++level) {
      const float left = all->triangles[i] / (float)(1 << (2 * level));
      const float error = level == 0 ? 0 : 2 * all->radius[i] / sqrtf(left);
      const float weight = level == (int)all->last[i] ? all->weight : 0;
      const float benefit = pixels * foredraw_lod_accuracy_of_error(error * pixels_a_unit);
      const uint32_t way = all->first[i] + (uint32_t)level;
      all->ways[way].cost = foredraw_lod_cost(foredraw_lod_pipeline(&rendering, left, left / 2, pixels));
      all->ways[way].benefit = foredraw_lod_benefit(foredraw_lod_held(benefit, pixels, weight));
      all->plain_ways[way].cost = all->ways[way].cost;
      all->plain_ways[way].benefit = foredraw_lod_benefit(benefit);
    }
    all->full += all->ways[all->first[i]].cost;
    all->least += all->ways[all->first[i] + levels - 1].cost;
  }
}

/* How many objects get another level than in the last frame; they have it then. */
static uint32_t switched(field* all) {
  uint32_t i, count = 0;
  for (i = 0; i < objects; ++i) {
    count += all->last[i] != levels && all->chosen[i] != all->last[i];
    all->last[i] = all->chosen[i];
  }
  return count;
}

/* A frame whose last choice is kept while it is within the budget and loses a fifth more than a new one at most. */
static void choose_or_keep(field* all, uint64_t budget) {
  const foredraw_lod_result next = foredraw_lod_select(&all->scene, budget - budget / 200, all->chosen, all->memory);
  CHECK(next.cost <= budget);
  if (all->last[0] != levels && foredraw_lod_may_keep(&all->plain, budget, all->last, all->chosen, 0.2))
    memcpy(all->chosen, all->last, sizeof all->last);
  CHECK(!foredraw_lod_kept(&all->scene, budget, all->chosen).is_over);
}

/* Distances change by a thousandth at most. How often an object switches in 200 frames. */
static uint32_t switched_by_jitter(float pixel, float weight, float share, int may_keep) {
  static field all;
  uint64_t budget = 0;
  uint32_t frame, count = 0;
  make_field(&all, pixel, weight);
  for (frame = 0; frame < 200; ++frame) {
    see(&all, frame == 0 ? 1 : 1 + 0.001f * (2 * drawn() - 1));
    if (frame == 0) budget = all.least + (uint64_t)(share * (float)(all.full - all.least));
    if (may_keep) {
      choose_or_keep(&all, budget);
    } else {
      foredraw_lod_select(&all.scene, budget, all.chosen, all.memory);
    }
    count += switched(&all);
  }
  free(all.memory);
  return count;
}

static void jitter(void) {
  static const float shares[5] = {2, 0.9f, 0.5f, 0.2f, 0.1f};
  uint32_t i, without = 0;
  for (i = 0; i < 5; ++i) {
    without += switched_by_jitter(0, 0, shares[i], 0);
    CHECK(switched_by_jitter(0, 0.1f, shares[i], 0) == 0); /* costs stand, benefits change */
    CHECK(switched_by_jitter(0.9f, 0.1f, shares[i], 1) == 0);
  }
  CHECK(without > 0);
  /* Where costs change too, a full budget is kept by switching, and no weight helps. */
  CHECK(switched_by_jitter(0.9f, 0.1f, 0.1f, 0) > 0);
  CHECK(switched_by_jitter(0.9f, 0.1f, 2, 0) == 0);
}

/* Eight objects come near, the others stand. The former get each level once, and full detail in the end if no choice is
 * kept. How often the latter switch. */
static uint32_t switched_by_approach(float pixel, float share, int may_keep) {
  static field all;
  uint64_t budget = 0;
  uint32_t frame, i, count = 0, levels_had[near_ones] = {0};
  make_field(&all, pixel, 0.05f);
  for (i = 0; i < near_ones; ++i) all.radius[i] = 3;
  for (frame = 0; frame < 600; ++frame) {
    for (i = 0; i < near_ones; ++i) all.away[i] = 10 * (float)i + 400 * powf(0.02f, (float)frame / 600);
    see(&all, 1);
    if (frame == 0) budget = all.least + (uint64_t)(share * (float)(all.full - all.least));
    if (may_keep) {
      choose_or_keep(&all, budget);
    } else {
      CHECK(foredraw_lod_select(&all.scene, budget, all.chosen, all.memory).cost <= budget);
    }
    for (i = 0; i < near_ones; ++i) {
      const uint32_t level = all.chosen[i];
      if (level == all.last[i]) continue;
      CHECK((levels_had[i] >> level & 1) == 0);            /* each once */
      CHECK(all.last[i] == levels || level < all.last[i]); /* and finer */
      levels_had[i] |= 1u << level;
      if (all.last[i] != levels) --count; /* others alone */
    }
    count += switched(&all);
  }
  for (i = 0; i < near_ones; ++i) CHECK(may_keep || all.last[i] == 0);
  free(all.memory);
  return count;
}

static void approach(void) {
  CHECK(switched_by_approach(0, 2, 0) == 0); /* there is time for all */
  CHECK(switched_by_approach(0.9f, 2, 0) == 0);
  CHECK(switched_by_approach(0, 0.1f, 1) < switched_by_approach(0, 0.1f, 0));
  CHECK(4 * switched_by_approach(0.9f, 0.2f, 1) < switched_by_approach(0.9f, 0.2f, 0));
  switched_by_approach(0, 0.5f, 0);
}

/* One of three levels lies on the hull, or a little below it, from frame to frame. With hysteresis in its benefit it
 * stays on the hull. If the hull is made of the plain benefits first, the level is gone before hysteresis could hold
 * it. */
static void before_the_hull(void) {
  static const uint32_t first[2] = {0, 3}, first_of_2[2] = {0, 2};
  uint32_t frame, last = 1, last_of_wrong = 1, switches = 0, wrong_switches = 0;
  uint64_t memory[20000];
  for (frame = 0; frame < 10; ++frame) {
    const uint32_t plain[3] = {0, frame % 2 ? 5000u : 5200u, 10100}, costs[3] = {0, 10, 20};
    foredraw_lod_way ways[3], hull[2];
    foredraw_lod_scene scene = {1, NULL, NULL};
    uint32_t chosen, level, is_below = 2 * plain[1] < plain[2];
    for (level = 0; level < 3; ++level) {
      ways[level].cost = costs[level];
      ways[level].benefit =
          (uint32_t)((float)plain[level] * foredraw_lod_hysteresis((int)level - (int)last, 0.02f) + 0.5f);
    }
    scene.first = first;
    scene.ways = ways;
    CHECK(foredraw_lod_memory(&scene) <= sizeof memory);
    foredraw_lod_select(&scene, 15, &chosen, memory);
    switches += chosen != last;
    last = chosen;
    /* the other way round */
    for (level = 0; level < 3; ++level)
      ways[level].benefit =
          (uint32_t)((float)plain[level] * foredraw_lod_hysteresis((int)level - (int)last_of_wrong, 0.02f) + 0.5f);
    if (is_below) {
      hull[0] = ways[0];
      hull[1] = ways[2];
      scene.first = first_of_2;
      scene.ways = hull;
    }
    foredraw_lod_select(&scene, 15, &chosen, memory);
    if (is_below) chosen *= 2;
    wrong_switches += chosen != last_of_wrong;
    last_of_wrong = chosen;
  }
  CHECK(switches == 0 && wrong_switches == 9);
}

int lod_hysteresis_test(void) {
  jitter();
  approach();
  before_the_hull();
  return failures == 0 ? 0 : 1;
}
