/* A level for each of a crowd: budgets that hold, levels that stay, and input that is none. */
#include "check.h"

#include <foredraw/runtime/crowd_select.h>
#include <foredraw/runtime/tessellation_level.h>

#include <stdlib.h>

enum { most_instances = 5000, tessellated = 15, levels = 21 };

static uint64_t state;
static float drawn(void) { /* 0 to 1 */
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (float)(state >> 40) / 16777216.0f;
}

static float distances[most_instances];
static uint8_t chosen[most_instances], before[most_instances];
static foredraw_crowd_level rows[levels];
static foredraw_crowd_table table;
static void* memory;

/* Tessellated up to 15, plain, and four meshes of fewer triangles. */
static void make_table(void) {
  static const uint32_t simplified[4] = {1290, 320, 80, 20};
  uint32_t i;
  for (i = 0; i < tessellated; ++i) {
    rows[i].triangles = 5160 * foredraw_tessellation_triangles(i + 1);
    rows[i].error = 0.02f / (float)(i + 1);
  }
  rows[15].triangles = 5160, rows[15].error = 0.03f; /* plain costs as much as level 1 */
  for (i = 0; i < 4; ++i) rows[16 + i].triangles = simplified[i], rows[16 + i].error = 0.05f * (float)(i + 1);
  rows[20].triangles = 900, rows[20].error = 0.3f; /* never worth it */
  CHECK(foredraw_crowd_prepare(rows, levels, &table));
  free(memory);
  memory = malloc(foredraw_crowd_memory(&table));
}

static void make_crowd(uint32_t n, uint64_t seed) {
  uint32_t i;
  state = seed;
  for (i = 0; i < n; ++i) distances[i] = sqrtf(4 + 1596 * drawn());
  memset(chosen, FOREDRAW_CROWD_NEW, sizeof chosen);
}

static uint64_t triangles_of(uint32_t n) {
  uint64_t sum = 0;
  uint32_t i;
  for (i = 0; i < n; ++i) sum += rows[chosen[i]].triangles;
  return sum;
}

static const uint64_t budget = (uint64_t)10 * 337 * 5160;

static void only_levels_worth_their_triangles_are_chosen(void) {
  foredraw_crowd_level reversed[levels];
  foredraw_crowd_table other;
  uint32_t i;
  make_table();
  CHECK(table.steps == 18 && table.hull[0] == 19 && table.hull[18] == 14);
  CHECK(table.steps_to[15] == FOREDRAW_CROWD_NEW && table.steps_to[20] == FOREDRAW_CROWD_NEW);
  for (i = 0; i + 1 < table.steps; ++i) CHECK(table.gain[i] >= table.gain[i + 1]);
  for (i = 0; i < levels; ++i) reversed[i] = rows[levels - 1 - i];
  CHECK(foredraw_crowd_prepare(reversed, levels, &other) && other.steps == table.steps);
  for (i = 0; i <= table.steps; ++i) CHECK(other.hull[i] == levels - 1 - table.hull[i]);
}

static void the_budget_holds_and_is_used(void) {
  uint32_t n, frame, i;
  make_table();
  for (n = 1; n <= most_instances; n += 1 + n / 50) {
    make_crowd(n, n);
    for (frame = 0; frame < 4; ++frame) {
      const float hysteresis = frame == 0 ? 0 : 0.35f;
      const foredraw_crowd_result r = foredraw_crowd_select(&table, distances, n, budget, hysteresis, chosen, memory);
      CHECK(r.triangles == triangles_of(n));
      CHECK(r.triangles <= budget && !r.is_over && r.unplaced == 0);
      if (n < 10) CHECK(r.triangles == (uint64_t)n * 337 * 5160 && r.price == 0);
      if (n >= 10) CHECK(r.triangles * 100 >= budget * 98);
      for (i = 0; i < n; ++i) distances[i] *= 0.9f + 0.2f * drawn();
    }
  }
}

static void who_is_nearer_has_no_less(void) {
  uint32_t i, j;
  make_table();
  make_crowd(600, 3);
  foredraw_crowd_select(&table, distances, 600, budget, 0, chosen, memory);
  for (i = 0; i < 600; ++i)
    for (j = 0; j < 600; ++j)
      if (foredraw_crowd_bucket(distances[i]) < foredraw_crowd_bucket(distances[j]))
        CHECK(table.steps_to[chosen[i]] >= table.steps_to[chosen[j]]);
}

/* As a GPU does it: no list of instances, only how far each step reaches. */
static void reaches_hold_the_budget(void) {
  uint32_t n, i, step;
  make_table();
  for (n = 7; n < most_instances; n += 331) {
    foredraw_crowd_result r;
    uint64_t sum = 0;
    make_crowd(n, n);
    r = foredraw_crowd_select(&table, distances, n, budget, 0, chosen, memory);
    for (i = 0; i < n; ++i) {
      uint32_t steps = 0;
      for (step = 0; step < table.steps; ++step) steps += distances[i] < foredraw_crowd_reach(&table, r.price, step);
      sum += table.triangles[steps];
      CHECK(steps <= table.steps_to[chosen[i]]);
    }
    CHECK(sum <= r.triangles && sum * 100 >= r.triangles * 75);
  }
}

static void one_distance_for_all(void) {
  uint32_t i, highest = 0;
  foredraw_crowd_result r;
  make_table();
  make_crowd(1000, 1);
  for (i = 0; i < 1000; ++i) distances[i] = 7;
  r = foredraw_crowd_select(&table, distances, 1000, budget, 0, chosen, memory);
  CHECK(r.triangles <= budget && r.triangles * 100 >= budget * 98);
  for (i = 0; i < 1000; ++i) {
    CHECK(chosen[i] == 0 || chosen[i] == 1); /* 1,000 triangles of 5,160 each are 30 % of the budget */
    highest += chosen[i] == 1;
  }
  CHECK(highest == (budget - (uint64_t)1000 * 5160) / (uint64_t)(5 * 5160));
  for (i = 0; i < highest; ++i) CHECK(chosen[i] == 1); /* the first ones */
}

static void what_does_not_move_stays(void) {
  uint32_t frame;
  make_table();
  make_crowd(2000, 5);
  foredraw_crowd_select(&table, distances, 2000, budget, 0.35f, chosen, memory);
  memcpy(before, chosen, sizeof before);
  for (frame = 0; frame < 5; ++frame) {
    foredraw_crowd_select(&table, distances, 2000, budget, 0.35f, chosen, memory);
    CHECK(memcmp(before, chosen, 2000) == 0);
  }
}

/* Distances that tremble by two hundredths: without hysteresis levels flicker, with it almost none changes. */
static void what_trembles_stays(void) {
  uint32_t changes[2] = {0, 0}, with, frame, i;
  static float at_rest[most_instances];
  make_table();
  for (with = 0; with < 2; ++with) {
    make_crowd(2000, 9);
    memcpy(at_rest, distances, sizeof at_rest);
    for (frame = 0; frame < 20; ++frame) {
      foredraw_crowd_result r;
      for (i = 0; i < 2000; ++i) distances[i] = at_rest[i] * (0.98f + 0.04f * drawn());
      memcpy(before, chosen, sizeof before);
      r = foredraw_crowd_select(&table, distances, 2000, budget, with ? 0.35f : 0, chosen, memory);
      CHECK(r.triangles <= budget);
      for (i = 0; frame > 0 && i < 2000; ++i) changes[with] += chosen[i] != before[i];
    }
  }

  CHECK(changes[0] > 100);
  CHECK(changes[1] * 20 < changes[0]);
}

/* Who leaves, comes in, or is told of by no level at all. */
static void new_ones_have_no_history(void) {
  make_table();
  make_crowd(500, 2);
  foredraw_crowd_select(&table, distances, 500, budget, 0, chosen, memory);
  memcpy(before, chosen, sizeof before);
  memset(chosen, FOREDRAW_CROWD_NEW, sizeof chosen);
  foredraw_crowd_select(&table, distances, 500, budget, 0.35f, chosen, memory);
  CHECK(memcmp(before, chosen, 500) == 0);
  memset(chosen, 15, sizeof chosen); /* on no hull */
  foredraw_crowd_select(&table, distances, 500, budget, 0.35f, chosen, memory);
  CHECK(memcmp(before, chosen, 500) == 0);
  memset(chosen, 200, sizeof chosen); /* in no table */
  foredraw_crowd_select(&table, distances, 500, budget, 0.35f, chosen, memory);
  CHECK(memcmp(before, chosen, 500) == 0);
}

static void distances_that_are_none(void) {
  static const float wrong[6] = {NAN, -NAN, INFINITY, -INFINITY, -1, -1e-30f};
  uint32_t i;
  foredraw_crowd_result r;
  make_table();
  make_crowd(40, 1);
  for (i = 0; i < 6; ++i) distances[3 * i] = wrong[i];
  distances[1] = 0, distances[2] = -0.0f, distances[4] = 1e-45f, distances[5] = 3.4e38f;
  r = foredraw_crowd_select(&table, distances, 40, budget, 0, chosen, memory);
  CHECK(r.unplaced == 6 && r.triangles == triangles_of(40) && r.triangles <= budget);
  for (i = 0; i < 6; ++i) CHECK(chosen[3 * i] == 19);
  CHECK(chosen[1] == 14 && chosen[2] == 14 && chosen[4] == 14);
  r = foredraw_crowd_select(&table, distances, 40, UINT64_MAX, 1, chosen, memory);
  CHECK(r.unplaced == 6 && r.price == 0 && chosen[5] == 14 && chosen[0] == 19);
  for (i = 0; i < 40; ++i) distances[i] = NAN;
  r = foredraw_crowd_select(&table, distances, 40, budget, 0.35f, chosen, memory);
  CHECK(r.unplaced == 40 && r.triangles == 40 * 20);
}

static void budgets_that_are_none(void) {
  float nearest = 40;
  uint32_t i;
  foredraw_crowd_result r;
  make_table();
  make_crowd(100, 1);
  for (i = 0; i < 100; ++i)
    if (distances[i] < nearest) nearest = distances[i];
  r = foredraw_crowd_select(&table, distances, 100, 1999, 0, chosen, memory);
  CHECK(r.is_over && r.triangles == 2000);
  for (i = 0; i < 100; ++i) CHECK(chosen[i] == 19);
  r = foredraw_crowd_select(&table, distances, 100, 2000, 0, chosen, memory);
  CHECK(!r.is_over && r.triangles == 2000 && foredraw_crowd_reach(&table, r.price, 0) <= nearest);
  r = foredraw_crowd_select(&table, distances, 100, 0, 0.35f, chosen, memory);
  CHECK(r.is_over && r.triangles == 2000 && foredraw_crowd_reach(&table, r.price, 0) == 0);
  r = foredraw_crowd_select(&table, distances, 0, 0, 0.35f, chosen, memory);
  CHECK(!r.is_over && r.triangles == 0);
  for (i = 0; i < 3; ++i) { /* no hysteresis that is one */
    static const float wrong[3] = {NAN, -1, 1e30f};
    make_crowd(100, 1);
    foredraw_crowd_select(&table, distances, 100, budget, 0, chosen, memory);
    memcpy(before, chosen, sizeof before);
    memset(chosen, 19, sizeof chosen);
    r = foredraw_crowd_select(&table, distances, 100, budget, wrong[i], chosen, memory);
    CHECK(memcmp(before, chosen, 100) == 0);
  }
}

static void tables_that_are_none(void) {
  static foredraw_crowd_level many[FOREDRAW_CROWD_LEVELS + 1];
  foredraw_crowd_level row = {7, 0.5f};
  foredraw_crowd_table refused;
  const float wrong[3] = {NAN, INFINITY, -0.5f};
  uint32_t i;
  CHECK(!foredraw_crowd_prepare(many, 0, &refused));
  CHECK(!foredraw_crowd_prepare(many, FOREDRAW_CROWD_LEVELS + 1, &refused));
  chosen[0] = 77;
  CHECK(foredraw_crowd_select(&refused, distances, 1, 100, 0, chosen, memory).triangles == 0 && chosen[0] == 77);
  for (i = 0; i < 3; ++i) {
    row.error = wrong[i];
    CHECK(!foredraw_crowd_prepare(&row, 1, &refused));
  }
  for (i = 0; i < FOREDRAW_CROWD_LEVELS; ++i) /* as many as there may be */
    many[i].triangles = i * i, many[i].error = 1.0f / (float)(i + 1);
  CHECK(foredraw_crowd_prepare(many, FOREDRAW_CROWD_LEVELS, &refused));
  CHECK(refused.steps + 1 <= FOREDRAW_CROWD_LEVELS && refused.triangles[0] == 0);
  row.error = 0; /* a single one that is always right */
  CHECK(foredraw_crowd_prepare(&row, 1, &refused) && refused.steps == 0);
  make_crowd(10, 1);
  CHECK(foredraw_crowd_select(&refused, distances, 10, 70, 0.35f, chosen, memory).triangles == 70 && chosen[9] == 0);
}

/* The same levels from every compiler, as C and as C++. */
static void the_choice_is_the_same_everywhere(void) {
  uint32_t i, frame, sum = 2166136261u;
  make_table();
  make_crowd(most_instances, 77);
  for (frame = 0; frame < 3; ++frame) {
    foredraw_crowd_select(&table, distances, most_instances, budget, 0.35f, chosen, memory);
    for (i = 0; i < most_instances; ++i) {
      sum = (sum ^ chosen[i]) * 16777619u;
      distances[i] *= 0.9f + 0.2f * drawn();
    }
  }
  if (sum != 1314708027u) printf("sum %uu\n", (unsigned)sum);
  CHECK(sum == 1314708027u);
}

int crowd_select_test(void) {
  only_levels_worth_their_triangles_are_chosen();
  the_budget_holds_and_is_used();
  who_is_nearer_has_no_less();
  reaches_hold_the_budget();
  one_distance_for_all();
  what_does_not_move_stays();
  what_trembles_stays();
  new_ones_have_no_history();
  distances_that_are_none();
  budgets_that_are_none();
  tables_that_are_none();
  the_choice_is_the_same_everywhere();
  free(memory);
  return failures != 0;
}
