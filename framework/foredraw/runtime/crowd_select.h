/* At which level each instance of a crowd is drawn, so that all together stay within a budget of triangles and are off
 * by as little as can be on the screen. C99, no allocation.
 *
 * Levels are of three classes (N. Tatarchuk, J. Barczak, B. Purnomo: Real-Time Tessellation on GPU, SIGGRAPH 2008
 * course notes): tessellated, plain, and simplified meshes. All are rows of one table: triangles, and an error in
 * units. On the screen, an instance is off by error / distance; chosen is what makes the sum of its squares least.
 *
 * This is the problem of lod_select.h, where each object has ways, and steps between them are taken by what they gain
 * for their cost. In a crowd all have the same ways, up to a factor of 1 / distance^2. So there is one hull, which
 * lod_select.h makes, and each of its steps is taken up to some distance. A histogram of distances says what that
 * costs. One price of a triangle, found by bisection, says how far each step reaches. What is left of the budget goes
 * to instances of the first bucket that does not fit as a whole.
 *
 *   foredraw_crowd_prepare(levels, count, &table);                                                once
 *   r = foredraw_crowd_select(&table, distances, n, budget, 0.35f, chosen, memory);               for every frame
 *   draw(instance i, level chosen[i])
 *
 * It may be called a frame ahead, or with distances of the last frame: triangles depend on the levels chosen alone, so
 * the budget holds all the same. On a GPU, with a histogram and no choice for each instance: an instance has taken as
 * many steps as there are with distance < foredraw_crowd_reach(&table, r.price, step). Without hysteresis that holds
 * the budget too, for the distances that were counted.
 *
 * Hysteresis: an instance keeps its level of the last frame while a step to the next one would gain little: no more
 * than that part of the mean squared error, which bounds what all that is kept costs together. So a change has to pay,
 * as with foredraw_lod_hysteresis() (lod_benefit.h) for any ways. Levels that are kept are in the search for the price,
 * and the budget holds with them.
 *
 * The same input gives the same choice on every machine: budgets and costs are whole numbers, buckets are bits of
 * distances, and nothing is added to a product, which some compilers would round once instead of twice. */
#ifndef FOREDRAW_RUNTIME_CROWD_SELECT_H
#define FOREDRAW_RUNTIME_CROWD_SELECT_H

#include <foredraw/runtime/crowd_table.h>

typedef struct foredraw_crowd_result {
  uint64_t triangles; /* of all instances */
  double price;       /* of a triangle, in the unit of gains: for foredraw_crowd_reach() */
  uint32_t unplaced;  /* instances whose distance is negative or no finite number: they get the fewest triangles */
  int is_over;        /* the fewest triangles are more than the budget; each instance is drawn so, and none left out */
} foredraw_crowd_result;

/* What happens at a price, in buckets. */
typedef struct foredraw_crowd_bounds {
  uint32_t within[FOREDRAW_CROWD_LEVELS]; /* [step] it is taken within so many buckets */
  /* [steps taken in the last frame] from where to where an instance keeps them */
  uint32_t kept_from[FOREDRAW_CROWD_LEVELS], kept_to[FOREDRAW_CROWD_LEVELS];
} foredraw_crowd_bounds;

typedef struct foredraw_crowd_counts {
  const foredraw_crowd_table* table;
  const uint8_t* last; /* [instance] level in the last frame; NULL: there is no hysteresis */
  /* [steps taken in the last frame, and behind these all instances][bucket] how many are in this bucket or a nearer
   * one. New instances count among all alone. */
  uint32_t* instances;
  uint32_t first, end; /* buckets that are not empty */
  double inertia;      /* triangles that a change has to be worth beside its own */
} foredraw_crowd_counts;

/* How many bytes foredraw_crowd_select() needs, aligned for a uint32_t. */
static inline size_t foredraw_crowd_memory(const foredraw_crowd_table* table) {
  return FOREDRAW_CROWD_BUCKETS * ((table->steps + 2) * sizeof(uint32_t) + 2 * sizeof(uint8_t));
}

/* That an instance took in the last frame; FOREDRAW_CROWD_NEW if that is not known. */
static inline uint32_t foredraw_crowd_last_steps(const foredraw_crowd_counts* counts, uint32_t instance) {
  if (counts->last == NULL || counts->last[instance] >= counts->table->levels) return FOREDRAW_CROWD_NEW;
  return counts->table->steps_to[counts->last[instance]];
}

/* Answers with how many instances have a place. */
static inline uint32_t foredraw_crowd_count(foredraw_crowd_counts* counts, const float* distances, uint32_t n) {
  const uint32_t all = counts->table->steps + 1;
  uint32_t i, row, bucket, placed = 0;
  counts->first = FOREDRAW_CROWD_BUCKETS;
  counts->end = 0;
  for (i = 0; i < n; ++i) {
    bucket = foredraw_crowd_bucket(distances[i]);
    if (bucket == FOREDRAW_CROWD_BUCKETS) continue;
    if (bucket < counts->first) counts->first = bucket;
    if (bucket >= counts->end) counts->end = bucket + 1;
    ++placed;
  }
  if (placed == 0) counts->first = 0;
  for (row = 0; row <= all; ++row) {
    uint32_t* of_row = counts->instances + row * FOREDRAW_CROWD_BUCKETS;
    memset(of_row + counts->first, 0, (counts->end - counts->first) * sizeof *of_row);
  }
  for (i = 0; i < n; ++i) {
    const uint32_t steps = foredraw_crowd_last_steps(counts, i);
    bucket = foredraw_crowd_bucket(distances[i]);
    if (bucket == FOREDRAW_CROWD_BUCKETS) continue;
    ++counts->instances[all * FOREDRAW_CROWD_BUCKETS + bucket];
    if (steps != FOREDRAW_CROWD_NEW) ++counts->instances[steps * FOREDRAW_CROWD_BUCKETS + bucket];
  }
  for (row = 0; row <= all; ++row) {
    uint32_t* of_row = counts->instances + row * FOREDRAW_CROWD_BUCKETS;
    uint32_t nearer = 0;
    for (bucket = counts->first; bucket < counts->end; ++bucket) of_row[bucket] = nearer += of_row[bucket];
  }
  return placed;
}

/* Of a row, in nearer buckets. */
static inline uint64_t foredraw_crowd_nearer(const foredraw_crowd_counts* counts, uint32_t row, uint32_t bucket) {
  if (bucket > counts->end) bucket = counts->end;
  if (bucket <= counts->first) return 0;
  return counts->instances[row * FOREDRAW_CROWD_BUCKETS + bucket - 1];
}

static inline uint64_t foredraw_crowd_step_cost(const foredraw_crowd_table* table, uint32_t step) {
  return table->triangles[step + 1] - table->triangles[step];
}

static inline void foredraw_crowd_bound(const foredraw_crowd_counts* counts, double price,
                                        foredraw_crowd_bounds* bounds) {
  const uint32_t steps = counts->table->steps;
  uint32_t step;
  bounds->kept_from[steps] = 0;
  bounds->kept_to[0] = FOREDRAW_CROWD_BUCKETS;
  for (step = 0; step < steps; ++step) {
    const double reach = foredraw_crowd_exact_reach(counts->table, price, step);
    const double part = counts->inertia / (double)foredraw_crowd_step_cost(counts->table, step);
    const double factor = sqrt(1.0 + part);
    bounds->within[step] = foredraw_crowd_within(reach);
    bounds->kept_from[step] = foredraw_crowd_within(reach / factor);
    bounds->kept_to[step + 1] = foredraw_crowd_within(reach * factor);
  }
}

/* What instances that keep their last level take more than by their distances. Modulo 2^64, as it may be less. */
static inline uint64_t foredraw_crowd_kept_cost(const foredraw_crowd_counts* counts,
                                                const foredraw_crowd_bounds* bounds, uint32_t last) {
  const foredraw_crowd_table* table = counts->table;
  const uint32_t* within = bounds->within;
  const uint32_t begin = bounds->kept_from[last], end = bounds->kept_to[last];
  uint64_t more = 0;
  uint32_t step;
  if (begin >= end) return 0;
  for (step = last; step > 0 && within[step - 1] < end; --step) {
    const uint32_t from = within[step - 1] > begin ? within[step - 1] : begin;
    more += foredraw_crowd_step_cost(table, step - 1) *
            (foredraw_crowd_nearer(counts, last, end) - foredraw_crowd_nearer(counts, last, from));
  }
  for (step = last; step < table->steps && within[step] > begin; ++step) {
    const uint32_t to = within[step] < end ? within[step] : end;
    more -= foredraw_crowd_step_cost(table, step) *
            (foredraw_crowd_nearer(counts, last, to) - foredraw_crowd_nearer(counts, last, begin));
  }
  return more;
}

/* Triangles of all steps at that price. The lower it is, the more. */
static inline uint64_t foredraw_crowd_cost(const foredraw_crowd_counts* counts, double price) {
  const foredraw_crowd_table* table = counts->table;
  foredraw_crowd_bounds bounds;
  uint64_t cost = 0;
  uint32_t step;
  foredraw_crowd_bound(counts, price, &bounds);
  for (step = 0; step < table->steps; ++step)
    cost +=
        foredraw_crowd_step_cost(table, step) * foredraw_crowd_nearer(counts, table->steps + 1, bounds.within[step]);
  if (counts->inertia <= 0) return cost;
  for (step = 0; step <= table->steps; ++step) cost += foredraw_crowd_kept_cost(counts, &bounds, step);
  return cost;
}

/* Prices have 21 bits of fraction. */
static inline double foredraw_crowd_price(uint32_t number) {
  const uint64_t bits = (uint64_t)number << 32;
  double price;
  memcpy(&price, &bits, sizeof price);
  return price;
}

/* Bounds at that price, and steps by distance alone, [bucket]. */
static inline void foredraw_crowd_steps_at(const foredraw_crowd_counts* counts, double price,
                                           foredraw_crowd_bounds* bounds, uint8_t* steps) {
  uint32_t taken = counts->table->steps, bucket;
  foredraw_crowd_bound(counts, price, bounds);
  for (bucket = counts->first; bucket < counts->end; ++bucket) {
    while (taken > 0 && bucket >= bounds->within[taken - 1]) --taken;
    steps[bucket] = (uint8_t)taken;
  }
}

/* Of an instance: as many as in the last frame, if its distance is not too far off. */
static inline uint32_t foredraw_crowd_steps(const foredraw_crowd_bounds* bounds, const uint8_t* steps, uint32_t bucket,
                                            uint32_t last) {
  const int is_kept = last != FOREDRAW_CROWD_NEW && bucket >= bounds->kept_from[last] && bucket < bounds->kept_to[last];
  return is_kept ? last : steps[bucket];
}

/* The lowest price, of those with 21 bits of fraction, at which steps take no more than `most`; its number, and that of
 * the next lower one. */
typedef struct foredraw_crowd_prices {
  uint32_t found, below;
} foredraw_crowd_prices;

static inline foredraw_crowd_prices foredraw_crowd_find_price(const foredraw_crowd_counts* counts, uint64_t most) {
  foredraw_crowd_prices prices = {0x7fefffffu, 0}; /* nobody pays that */
  if (foredraw_crowd_cost(counts, 0) <= most) prices.found = 0;
  while (prices.found > prices.below + 1) {
    const uint32_t middle = prices.below + (prices.found - prices.below) / 2;
    if (foredraw_crowd_cost(counts, foredraw_crowd_price(middle)) <= most) {
      prices.found = middle;
    } else {
      prices.below = middle;
    }
  }
  return prices;
}

/* Squared errors at that price, without hysteresis, in the unit of gains. Those of the best level are left out: no
 * price would lower them, and who stands before the eye is not to decide how still all others are. */
static inline double foredraw_crowd_squares(const foredraw_crowd_counts* counts, double price, uint8_t* steps) {
  const foredraw_crowd_table* table = counts->table;
  const uint32_t* all = counts->instances + (table->steps + 1) * FOREDRAW_CROWD_BUCKETS;
  foredraw_crowd_bounds bounds;
  double sum = 0;
  uint32_t bucket, nearer = 0;
  foredraw_crowd_steps_at(counts, price, &bounds, steps);
  for (bucket = counts->first; bucket < counts->end; nearer = all[bucket++]) {
    const double distance = (double)foredraw_crowd_distance(bucket);
    if (all[bucket] == nearer || steps[bucket] == table->steps) continue;
    sum += (double)(all[bucket] - nearer) * table->squared[steps[bucket]] / (distance * distance);
  }
  return sum;
}

/* Levels for n instances. chosen[instance]: in, the last frame's level, or FOREDRAW_CROWD_NEW; out, this frame's.
 * `hysteresis`: 0 for none, then chosen is not read; at most 1, else none. A table that was refused
 * chooses nothing. `memory`: foredraw_crowd_memory() bytes. O(n + steps * buckets that are not empty). */
static inline foredraw_crowd_result foredraw_crowd_select(const foredraw_crowd_table* table, const float* distances,
                                                          uint32_t n, uint64_t budget, float hysteresis,
                                                          uint8_t* chosen, void* memory) {
  foredraw_crowd_counts counts;
  foredraw_crowd_result result = {0, HUGE_VAL, 0, 0};
  foredraw_crowd_bounds least, most; /* at the price found, and at the one below it */
  uint8_t *least_steps, *most_steps;
  foredraw_crowd_prices prices;
  uint32_t i;
  uint64_t left;
  if (table->levels == 0 || n == 0) return result;
  counts.table = table;
  counts.instances = (uint32_t*)memory;
  counts.last = hysteresis > 0 && hysteresis <= 1 ? chosen : NULL;
  counts.inertia = 0;
  least_steps = (uint8_t*)(counts.instances + (table->steps + 2) * FOREDRAW_CROWD_BUCKETS);
  most_steps = least_steps + FOREDRAW_CROWD_BUCKETS;
  result.triangles = (uint64_t)n * table->triangles[0];
  result.is_over = result.triangles > budget;
  left = result.is_over ? 0 : budget - result.triangles;
  result.unplaced = n - foredraw_crowd_count(&counts, distances, n);
  if (result.is_over) {
    memset(chosen, table->hull[0], n);
    return result;
  }
  prices = foredraw_crowd_find_price(&counts, left);
  if (counts.last != NULL && prices.found > 0) {
    const double price = foredraw_crowd_price(prices.found);
    counts.inertia = (double)hysteresis * foredraw_crowd_squares(&counts, price, least_steps) / (price * (double)n);
    prices = foredraw_crowd_find_price(&counts, left);
  }
  result.price = foredraw_crowd_price(prices.found);
  foredraw_crowd_steps_at(&counts, result.price, &least, least_steps);
  foredraw_crowd_steps_at(&counts, foredraw_crowd_price(prices.below), &most, most_steps);
  left -= foredraw_crowd_cost(&counts, result.price);
  for (i = 0; i < n; ++i) {
    const uint32_t bucket = foredraw_crowd_bucket(distances[i]), last = foredraw_crowd_last_steps(&counts, i);
    uint32_t steps = 0, end = 0;
    if (bucket < FOREDRAW_CROWD_BUCKETS) {
      steps = foredraw_crowd_steps(&least, least_steps, bucket, last);
      end = foredraw_crowd_steps(&most, most_steps, bucket, last);
    }
    for (; steps < end && foredraw_crowd_step_cost(table, steps) <= left; ++steps)
      left -= foredraw_crowd_step_cost(table, steps);
    chosen[i] = table->hull[steps];
  }
  result.triangles = budget - left;
  return result;
}

#endif
