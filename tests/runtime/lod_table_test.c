/* A table by hand, what its ways come to, and that nothing which is left out would have been chosen. */
#include "check.h"

#include <foredraw/runtime/lod_table.h>

#include <stdlib.h>

#define LEVELS 4
#define WAYS (LEVELS * FOREDRAW_LOD_RENDERINGS)

static const foredraw_lod_machine by_max = {{{2, 1, 4}, {2, 1, 2}, {1, 1, 0.5f}}, 100000, 500, 0};
static const foredraw_lod_table_level rock[LEVELS] = {
    {8000, 5000, 4100, 0}, {4000, 2500, 2100, 0.01f}, {2000, 1300, 1100, 0.03f}, {400, 280, 220, 0.2f}};

static foredraw_lod_table_draw rock_draw(const foredraw_lod_machine* machine) {
  foredraw_lod_table_draw draw;
  foredraw_lod_way ways[WAYS];
  draw.name = "rock";
  draw.level = rock;
  draw.levels = LEVELS;
  draw.radius = 2;
  draw.coverage = 0.5f;
  draw.importance = 0.5f;
  draw.accuracy[0] = 1;
  draw.accuracy[1] = 0.9f;
  draw.accuracy[2] = 0.4f;
  foredraw_lod_table_fill(machine, &draw, ways);
  return draw;
}

static void octaves(void) {
  CHECK(foredraw_lod_octave(0) == 0 && foredraw_lod_octave(-5) == 0 && foredraw_lod_octave((float)NAN) == 0);
  CHECK(foredraw_lod_octave(4) == 0 && foredraw_lod_octave(7.9f) == 0);
  CHECK(foredraw_lod_octave(8) == 1 && foredraw_lod_octave(15.9f) == 1 && foredraw_lod_octave(16) == 2);
  CHECK(foredraw_lod_octave(2047) == 8 && foredraw_lod_octave(2048) == 9 && foredraw_lod_octave(4096) == 9);
  CHECK(foredraw_lod_octave((float)INFINITY) == 9);
}

static int near(double a, double b) { return fabs(a - b) <= 0.5 + 1e-5 * fabs(b); }

static void ways_by_hand(void) {
  const foredraw_lod_table_draw draw = rock_draw(&by_max);
  foredraw_lod_machine by_sum = by_max;
  const float pixels = foredraw_lod_table_pixels(&draw, 100);
  foredraw_lod_way way;
  CHECK(near((double)pixels, 3.14159265 / 4 * 100 * 100 / 2));
  way = foredraw_lod_table_way(&by_max, &draw, 0, 0, 100, 1);
  CHECK(way.cost == 500 + 2 * 8000 + 5000); /* its triangles take longer than its pixels */
  CHECK(near(way.benefit, 64 * (double)pixels * 0.5));
  way = foredraw_lod_table_way(&by_max, &draw, 3, 0, 100, 1); /* 0.2 of a diameter of 4, 100 pixels across: 5 pixels */
  CHECK(near(way.cost, 500 + 4 * (double)pixels));
  CHECK(near(way.benefit, 64 * (double)pixels * 0.5 / 6));
  way = foredraw_lod_table_way(&by_max, &draw, 3, 2, 100, 0.5f);
  CHECK(near(way.cost, 500 + 0.5 * (double)pixels) && near(way.benefit, 64 * (double)pixels * 0.5 / 6 * 0.4 * 0.5));
  by_sum.is_sum = 1;
  way = foredraw_lod_table_way(&by_sum, &draw, 0, 0, 100, 1);
  CHECK(near(way.cost, 500 + 21000 + 4 * (double)pixels));
  CHECK(foredraw_lod_table_samples(&rock[1], 0) == 2100 && foredraw_lod_table_samples(&rock[1], 1) == 2100);
  CHECK(foredraw_lod_table_samples(&rock[1], 2) == 4000);
}

static uint32_t bits(const uint32_t* masks) {
  uint32_t i, count = 0;
  for (i = 0; i < 32 * FOREDRAW_LOD_RENDERINGS; ++i) count += masks[i / 32] >> (i % 32) & 1u;
  return count;
}

/* The best is always there, and the cheapest: of several that are as cheap, as where pixels count alone, the best. */
static void hulls_by_size(void) {
  const foredraw_lod_table_draw draw = rock_draw(&by_max);
  uint32_t octave;
  for (octave = 0; octave < FOREDRAW_LOD_OCTAVES; ++octave) {
    CHECK((draw.hulls[octave][0] & 1u) == 1 && draw.hulls[octave][2] != 0);
    CHECK(bits(draw.hulls[octave]) < WAYS);
    CHECK(draw.hulls[octave][0] < 1u << LEVELS && draw.hulls[octave][1] < 1u << LEVELS);
  }
  CHECK((draw.hulls[0][2] & 8u) == 8 && (draw.hulls[9][2] & 8u) == 0);
  CHECK((draw.hulls[9][0] & 8u) == 0); /* large, the coarsest level in full light is no good */
}

static uint64_t seed = 1;
static float unit(void) {
  seed = seed * 6364136223846793005u + 1442695040888963407u;
  return (float)(seed >> 40) / 16777216.0f;
}

#define OBJECTS 64u

static uint64_t benefit_of(const foredraw_lod_way* ways, const uint32_t* first, uint64_t budget) {
  foredraw_lod_scene scene = {OBJECTS, NULL, NULL};
  uint32_t chosen[OBJECTS];
  foredraw_lod_result result;
  void* memory;
  scene.first = first;
  scene.ways = ways;
  memory = malloc(foredraw_lod_memory(&scene));
  result = foredraw_lod_select(&scene, budget, chosen, memory);
  free(memory);
  CHECK(result.cost <= budget && !result.is_over);
  return result.benefit;
}

/* Objects of all sizes: with all their ways and with those of the hulls the same is shown, but for what lies between
 * the sizes at which hulls were made, and where the budget ends. */
static void nothing_that_is_left_out_is_missed(void) {
  int round;
  for (round = 0; round < 20; ++round) {
    foredraw_lod_machine machine = by_max;
    foredraw_lod_way all[OBJECTS * WAYS], some[OBJECTS * WAYS], room[WAYS];
    uint32_t numbers[WAYS], first_of_all[OBJECTS + 1] = {0}, first_of_some[OBJECTS + 1] = {0}, i, way;
    uint64_t least = 0, most = 0;
    machine.is_sum = round % 2;
    for (i = 0; i < OBJECTS; ++i) {
      const float across = 4 * powf(1000, unit());
      foredraw_lod_way* own = all + i * WAYS;
      foredraw_lod_table_draw draw = rock_draw(&machine);
      draw.accuracy[1] = unit();
      draw.accuracy[2] = unit();
      draw.coverage = unit();
      draw.radius = 0.1f + unit();
      foredraw_lod_table_fill(&machine, &draw, room);
      for (way = 0; way < WAYS; ++way)
        own[way] = foredraw_lod_table_way(&machine, &draw, way / 3, way % 3, across, 0.7f);
      least += own[foredraw_lod_cheapest(own, WAYS)].cost;
      most += own[0].cost;
      first_of_all[i + 1] = (i + 1) * WAYS;
      first_of_some[i + 1] =
          first_of_some[i] + foredraw_lod_table_ways(&machine, &draw, across, 0.7f, some + first_of_some[i], numbers);
      CHECK(first_of_some[i + 1] > first_of_some[i]);
      for (way = first_of_some[i]; way < first_of_some[i + 1]; ++way) {
        const foredraw_lod_way* same = &own[numbers[way - first_of_some[i]]];
        CHECK(some[way].cost == same->cost && some[way].benefit == same->benefit);
      }
    }
    CHECK(first_of_some[OBJECTS] < first_of_all[OBJECTS] * 2 / 3); /* or it would not be worth the trouble */
    for (i = 0; i <= 8; ++i) {
      const uint64_t budget = least + (most - least) * i / 8;
      const uint64_t of_all = benefit_of(all, first_of_all, budget), of_some = benefit_of(some, first_of_some, budget);
      CHECK((double)of_some >= 0.999 * (double)of_all);
    }
  }
}

static void odd_rows(void) {
  foredraw_lod_table_level one = {0, 0, 0, 0};
  foredraw_lod_table_draw draw = rock_draw(&by_max);
  foredraw_lod_way ways[3];
  uint32_t numbers[3];
  draw.level = &one;
  draw.levels = 1;
  draw.radius = 0;
  draw.importance = 0;
  foredraw_lod_table_fill(&by_max, &draw, ways);
  CHECK(bits(draw.hulls[5]) == 1); /* nothing is worth anything: the cheapest alone */
  CHECK(foredraw_lod_table_ways(&by_max, &draw, 100, 1, ways, numbers) == 1 && numbers[0] == 2);
  draw.levels = 0;
  foredraw_lod_table_fill(&by_max, &draw, ways);
  CHECK(bits(draw.hulls[5]) == 0 && foredraw_lod_table_ways(&by_max, &draw, 100, 1, ways, numbers) == 0);
}

int lod_table_test(void) {
  octaves();
  ways_by_hand();
  hulls_by_size();
  nothing_that_is_left_out_is_missed();
  odd_rows();
  return failures != 0;
}
