/* The levels of a crowd: which are worth their triangles, and how far each reaches. For crowd_select.h. C99, no state,
 * no allocation. */
#ifndef FOREDRAW_RUNTIME_CROWD_TABLE_H
#define FOREDRAW_RUNTIME_CROWD_TABLE_H

#include <foredraw/runtime/lod_select.h>

#include <math.h>

/* In a table. */
#define FOREDRAW_CROWD_LEVELS 128u

/* In place of a level: the instance was not drawn in the last frame. */
#define FOREDRAW_CROWD_NEW 255u

/* Distances are told apart in 128 parts of an octave, from 2^-32 to 2^32. */
#define FOREDRAW_CROWD_BUCKETS 8192u

typedef struct foredraw_crowd_level {
  uint32_t triangles; /* of one instance; may be 0 */
  float error;        /* in units; finite, and not below 0 */
} foredraw_crowd_level;

/* How an instance is drawn at a level, as crowd-levels writes it beside the level. */
typedef enum foredraw_crowd_class {
  FOREDRAW_CROWD_TESSELLATED,
  FOREDRAW_CROWD_PLAIN,
  FOREDRAW_CROWD_SIMPLIFIED
} foredraw_crowd_class;

typedef struct foredraw_crowd_mesh {
  foredraw_crowd_class kind;
  uint32_t number;   /* tessellated: parts of each edge; simplified: the level of detail */
  uint32_t vertices; /* that are stored, and posed */
  float largest;     /* distance, where the level's error is the root mean square */
} foredraw_crowd_mesh;

/* What crowd-levels writes for each character. */
typedef struct foredraw_crowd_character {
  const char* name;
  const foredraw_crowd_level* level; /* [levels] from the finest on */
  const foredraw_crowd_mesh* mesh;   /* [levels] */
  uint32_t levels;
  uint64_t budget; /* triangles, of so many characters as the stage was given, at the finest level */
} foredraw_crowd_character;

/* Levels that are worth their triangles, from the one with the fewest on: the hull. `step` s leads from hull[s] to
 * hull[s + 1]. */
typedef struct foredraw_crowd_table {
  uint32_t levels, steps;
  uint8_t hull[FOREDRAW_CROWD_LEVELS];       /* [steps taken] the level */
  uint8_t steps_to[FOREDRAW_CROWD_LEVELS];   /* [level] steps taken; FOREDRAW_CROWD_NEW: it is not on the hull */
  uint32_t triangles[FOREDRAW_CROWD_LEVELS]; /* [steps taken] of one instance */
  double squared[FOREDRAW_CROWD_LEVELS];     /* [steps taken] error at distance 1, 2^32 for the largest error of all */
  double gain[FOREDRAW_CROWD_LEVELS];        /* [step] of squared error for each triangle, at distance 1; falling */
} foredraw_crowd_table;

/* Levels in any sequence. 0, and an empty table, where it is refused: no level or too many, an error that is negative
 * or no finite number. */
static inline int foredraw_crowd_prepare(const foredraw_crowd_level* levels, uint32_t count,
                                         foredraw_crowd_table* table) {
  foredraw_lod_way ways[FOREDRAW_CROWD_LEVELS];
  foredraw_lod_step steps[FOREDRAW_CROWD_LEVELS];
  double most = 0;
  uint32_t i;
  memset(table, 0, sizeof *table);
  if (count == 0 || count > FOREDRAW_CROWD_LEVELS) return 0;
  for (i = 0; i < count; ++i) {
    if (!(levels[i].error >= 0 && levels[i].error <= 3.402823466e38f)) return 0;
    if ((double)levels[i].error > most) most = (double)levels[i].error;
  }
  for (i = 0; i < count; ++i) {
    const double error = (double)levels[i].error;
    const double squared = most > 0 ? error * error / (most * most) : 0;
    ways[i].cost = levels[i].triangles;
    ways[i].benefit = (uint32_t)((1.0 - squared) * 4294967295.0);
    table->steps_to[i] = FOREDRAW_CROWD_NEW;
  }
  table->levels = count;
  i = foredraw_lod_cheapest(ways, count);
  table->steps = foredraw_lod_steps_of(ways, count, i, UINT64_MAX, steps);
  table->hull[0] = (uint8_t)i;
  for (i = 0; i < table->steps; ++i) {
    table->hull[i + 1] = (uint8_t)steps[i].way;
    table->gain[i] = (double)steps[i].benefit / (double)steps[i].cost;
  }
  for (i = 0; i <= table->steps; ++i) {
    table->steps_to[table->hull[i]] = (uint8_t)i;
    table->triangles[i] = ways[table->hull[i]].cost;
    table->squared[i] = 4294967295.0 - (double)ways[table->hull[i]].benefit;
  }
  return 1;
}

/* FOREDRAW_CROWD_BUCKETS: no distance at all. */
static inline uint32_t foredraw_crowd_bucket(float distance) {
  uint32_t bits;
  if (!(distance >= 0 && distance <= 3.402823466e38f)) return FOREDRAW_CROWD_BUCKETS;
  if (distance < 2.3283064e-10f) return 0; /* 2^-32 */
  if (distance >= 4294967296.0f) return FOREDRAW_CROWD_BUCKETS - 1;
  memcpy(&bits, &distance, sizeof bits);
  return (bits >> 16) - ((127u - 32u) << 7);
}

/* How many buckets lie within a distance as a whole. */
static inline uint32_t foredraw_crowd_within(double distance) {
  uint64_t bits;
  if (!(distance >= 2.3283064365386963e-10)) return 0;
  if (distance >= 4294967296.0) return FOREDRAW_CROWD_BUCKETS;
  memcpy(&bits, &distance, sizeof bits);
  return (uint32_t)(bits >> 45) - ((1023u - 32u) << 7);
}

/* Where a bucket begins; the first one has 2^-32, the one behind the last is at infinity. */
static inline float foredraw_crowd_distance(uint32_t bucket) {
  const uint32_t bits = (bucket + ((127u - 32u) << 7)) << 16;
  float distance;
  if (bucket >= FOREDRAW_CROWD_BUCKETS) return (float)INFINITY;
  memcpy(&distance, &bits, sizeof distance);
  return distance;
}

static inline double foredraw_crowd_exact_reach(const foredraw_crowd_table* table, double price, uint32_t step) {
  return sqrt(table->gain[step] / price);
}

/* A step is taken at distances below that, without hysteresis. Where there is enough for all it is infinite. */
static inline float foredraw_crowd_reach(const foredraw_crowd_table* table, double price, uint32_t step) {
  const uint32_t buckets = foredraw_crowd_within(foredraw_crowd_exact_reach(table, price, step));
  return buckets == 0 ? 0 : foredraw_crowd_distance(buckets);
}

#endif
