/* In which way each visible object is drawn in the next frame, so that the frame shows most for its time. C99, no
 * allocation.
 *
 * An object can be drawn in several ways: at each level, by each rendering (T. Funkhouser, C. Sequin: Adaptive Display
 * Algorithm for Interactive Frame Rates, SIGGRAPH 1993, section 3). Each has a cost and a benefit. To choose one for
 * each object, within a budget, is a multiple-choice knapsack problem. It is solved here up to the last few objects:
 * ways that are never worth their cost are left out (the rest is the upper hull), and steps from one way to the next
 * are taken by how much they gain for their cost. A histogram finds where the budget ends, so only steps near there are
 * sorted. The answer comes with a bound: no choice within the budget can have more benefit than that.
 *
 *   foredraw_lod_result r = foredraw_lod_select(&scene, budget, chosen, memory);                       for every frame
 *   draw(object, way chosen[object])                                                                   for all objects
 *
 * The same input gives the same choice on every machine: costs and benefits are whole numbers. */
#ifndef FOREDRAW_RUNTIME_LOD_SELECT_H
#define FOREDRAW_RUNTIME_LOD_SELECT_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* A way to draw an object. Any numbers; their units are the caller's, such as nanoseconds, and thousandths of a pixel.
 */
typedef struct foredraw_lod_way {
  uint32_t cost, benefit;
} foredraw_lod_way;

typedef struct foredraw_lod_scene {
  uint32_t objects;             /* that are visible */
  const uint32_t* first;        /* [object], and the number of ways behind the last: object i has ways first[i] to
                                 * first[i + 1] - 1; first[0] is 0. An object without ways costs nothing, and is not
                                 * drawn */
  const foredraw_lod_way* ways; /* in any sequence; by their costs, it takes least time */
} foredraw_lod_scene;

typedef struct foredraw_lod_result {
  uint64_t cost, benefit; /* of what was chosen */
  uint64_t bound;         /* no choice within the budget has more benefit */
  int is_over; /* the cheapest ways cost more than the budget: each object is drawn so, and none is left out */
} foredraw_lod_result;

/* From one way of an object to the next better one. */
typedef struct foredraw_lod_step {
  uint32_t object, way;   /* the better one: a number among the object's */
  uint32_t cost, benefit; /* that are added; above 0 */
} foredraw_lod_step;

/* Steps are told apart by how much they gain for their cost, in 128 parts of an octave. */
#define FOREDRAW_LOD_BUCKETS 8192u

typedef struct foredraw_lod_bucket {
  uint64_t cost;
  uint64_t steps;
} foredraw_lod_bucket;

/* How many bytes foredraw_lod_select() needs, aligned for a uint64_t. Where a size_t cannot tell, the most it can. */
static inline size_t foredraw_lod_memory(const foredraw_lod_scene* scene) {
  const uint64_t ways = scene->first[scene->objects], for_each = sizeof(foredraw_lod_step) + 2 * sizeof(uint32_t);
  const uint64_t bytes = FOREDRAW_LOD_BUCKETS * sizeof(foredraw_lod_bucket) + ways * for_each;
  return bytes < SIZE_MAX ? (size_t)bytes : SIZE_MAX;
}

/* Whether a gains more for its cost than b. Exact. */
static inline int foredraw_lod_is_steeper(uint32_t a_benefit, uint32_t a_cost, uint32_t b_benefit, uint32_t b_cost) {
  return (uint64_t)a_benefit * b_cost > (uint64_t)b_benefit * a_cost;
}

/* The cheapest way of n, of these the best, of these the first. n is above 0. */
static inline uint32_t foredraw_lod_cheapest(const foredraw_lod_way* ways, uint32_t n) {
  uint32_t i, best = 0;
  for (i = 1; i < n; ++i)
    if (ways[i].cost < ways[best].cost || (ways[i].cost == ways[best].cost && ways[i].benefit > ways[best].benefit))
      best = i;
  return best;
}

/* The next way on the upper hull of those that cost no more than `most`: the one that is better at the least price for
 * it, of equal ones the nearest. n: there is none. */
static inline uint32_t foredraw_lod_next(const foredraw_lod_way* ways, uint32_t n, uint32_t from, uint64_t most) {
  uint32_t i, best = n, best_cost = 1, best_benefit = 0;
  for (i = 0; i < n; ++i) {
    uint32_t cost, benefit;
    if (ways[i].benefit <= ways[from].benefit || ways[i].cost <= ways[from].cost || ways[i].cost > most) continue;
    cost = ways[i].cost - ways[from].cost;
    benefit = ways[i].benefit - ways[from].benefit;
    if (best != n && !foredraw_lod_is_steeper(benefit, cost, best_benefit, best_cost) &&
        (cost >= best_cost || foredraw_lod_is_steeper(best_benefit, best_cost, benefit, cost)))
      continue;
    best = i;
    best_cost = cost;
    best_benefit = benefit;
  }
  return best;
}

/* Steeper steps have higher buckets, or the same: a quotient that is rounded once never changes sides with another. */
static inline uint32_t foredraw_lod_bucket_of(const foredraw_lod_step* step) {
  const double gain = (double)step->benefit / (double)step->cost; /* above 2^-32, below 2^32 */
  uint64_t bits;
  memcpy(&bits, &gain, sizeof bits);
  return (uint32_t)(bits >> 45) - ((1023u - 32u) << 7);
}

/* Every object at its cheapest way. */
static inline void foredraw_lod_begin(const foredraw_lod_scene* scene, uint32_t* chosen, foredraw_lod_result* result) {
  uint32_t i;
  result->cost = result->benefit = 0;
  for (i = 0; i < scene->objects; ++i) {
    const foredraw_lod_way* ways = scene->ways + scene->first[i];
    const uint32_t n = scene->first[i + 1] - scene->first[i];
    chosen[i] = 0;
    if (n == 0) continue;
    chosen[i] = foredraw_lod_cheapest(ways, n);
    result->cost += ways[chosen[i]].cost;
    result->benefit += ways[chosen[i]].benefit;
  }
}

/* The steps of an object along the upper hull of its ways that cost no more than `most`, where these come by their
 * costs, from either end: one pass, in which two steps become one where the later one gains more for its cost. How many
 * there are; n: the ways come in another sequence. */
static inline uint32_t foredraw_lod_in_turn(const foredraw_lod_way* ways, uint32_t n, uint32_t cheapest, uint64_t most,
                                            int is_rising, foredraw_lod_step* steps) {
  foredraw_lod_way from = ways[cheapest];
  uint32_t i, count = 0;
  for (i = 0; i < n; ++i) {
    const uint32_t way = is_rising ? i : n - 1 - i;
    const foredraw_lod_way to = ways[way];
    uint32_t cost = to.cost - from.cost, benefit = to.benefit - from.benefit;
    if (to.cost < from.cost) return n;
    if (to.benefit <= from.benefit || to.cost > most) continue;
    while (count > 0 && foredraw_lod_is_steeper(benefit, cost, steps[count - 1].benefit, steps[count - 1].cost)) {
      cost += steps[--count].cost;
      benefit += steps[count].benefit;
    }
    steps[count].way = way;
    steps[count].cost = cost;
    steps[count++].benefit = benefit;
    from = to;
  }
  return count;
}

/* The same for ways in any sequence. */
static inline uint32_t foredraw_lod_steps_of(const foredraw_lod_way* ways, uint32_t n, uint32_t cheapest, uint64_t most,
                                             foredraw_lod_step* steps) {
  uint32_t way = cheapest, next, count = foredraw_lod_in_turn(ways, n, cheapest, most, 1, steps);
  if (count == n) count = foredraw_lod_in_turn(ways, n, cheapest, most, 0, steps);
  if (count < n) return count;
  for (count = 0; (next = foredraw_lod_next(ways, n, way, most)) != n; way = next) {
    steps[count].way = next;
    steps[count].cost = ways[next].cost - ways[way].cost;
    steps[count++].benefit = ways[next].benefit - ways[way].benefit;
  }
  return count;
}

/* The steps from there, object after object, without ways that `more` would not pay for. How many there are. */
static inline uint32_t foredraw_lod_steps(const foredraw_lod_scene* scene, const uint32_t* chosen, uint64_t more,
                                          foredraw_lod_step* steps) {
  uint32_t i, count = 0;
  for (i = 0; i < scene->objects; ++i) {
    const foredraw_lod_way* ways = scene->ways + scene->first[i];
    const uint32_t n = scene->first[i + 1] - scene->first[i];
    uint32_t end;
    if (n == 0) continue;
    end = count + foredraw_lod_steps_of(ways, n, chosen[i], ways[chosen[i]].cost + more, steps + count);
    for (; count < end; ++count) steps[count].object = i;
  }
  return count;
}

/* Whether the first step is to come before the second one, if that is the sequence in which they stand. */
static inline int foredraw_lod_stay(const foredraw_lod_step* first, const foredraw_lod_step* second) {
  return !foredraw_lod_is_steeper(second->benefit, second->cost, first->benefit, first->cost);
}

/* Behind the last of the numbers from there on that are sorted already. */
static inline uint32_t foredraw_lod_end_of_run(const foredraw_lod_step* steps, const uint32_t* numbers, uint32_t from,
                                               uint32_t n) {
  uint32_t end = from < n ? from + 1 : n;
  while (end < n && foredraw_lod_stay(&steps[numbers[end - 1]], &steps[numbers[end]])) ++end;
  return end;
}

/* Sorts numbers of steps, the steepest first; equal ones stay in their sequence. Merges what is sorted already, such as
 * the steps of one object. `other` has as much room. Answers with the one of both that holds them. */
static inline uint32_t* foredraw_lod_sorted(const foredraw_lod_step* steps, uint32_t* numbers, uint32_t n,
                                            uint32_t* other) {
  uint32_t runs;
  do {
    uint32_t begin = 0;
    uint32_t* merged = other;
    for (runs = 0; begin < n; ++runs) {
      const uint32_t middle = foredraw_lod_end_of_run(steps, numbers, begin, n);
      const uint32_t end = foredraw_lod_end_of_run(steps, numbers, middle, n);
      uint32_t a = begin, b = middle;
      for (; begin < end; ++begin) {
        const int is_first = b == end || (a < middle && foredraw_lod_stay(&steps[numbers[a]], &steps[numbers[b]]));
        merged[begin] = is_first ? numbers[a++] : numbers[b++];
      }
    }
    other = numbers;
    numbers = merged;
  } while (runs > 1);
  return numbers;
}

/* chosen[object]: the number of its way among its own; 0 if it has none. `memory`: foredraw_lod_memory() bytes. Of what
 * any choice gains over the cheapest ways within the budget, this one gains half at the least, and mostly all but a
 * step. */
static inline foredraw_lod_result foredraw_lod_select(const foredraw_lod_scene* scene, uint64_t budget,
                                                      uint32_t* chosen, void* memory) {
  enum { neighbourhood = 512 }; /* steps behind the end of the budget, of which some may still fit */
  const size_t most_steps = scene->first[scene->objects];
  foredraw_lod_bucket* buckets = (foredraw_lod_bucket*)memory;
  foredraw_lod_step* steps = (foredraw_lod_step*)(buckets + FOREDRAW_LOD_BUCKETS);
  uint32_t* numbers = (uint32_t*)(steps + most_steps);
  uint32_t* bucket_of = numbers + most_steps;
  foredraw_lod_result result, least;
  const foredraw_lod_step* critical = NULL; /* the first that does not fit */
  uint32_t i, count, cut = FOREDRAW_LOD_BUCKETS, last = 0, near_cut = 0;
  uint64_t gathered = 0;
  foredraw_lod_begin(scene, chosen, &result);
  result.bound = result.benefit;
  result.is_over = result.cost > budget;
  if (result.is_over) return result;
  least = result;
  count = foredraw_lod_steps(scene, chosen, budget - least.cost, steps);
  for (i = 0; i < count; ++i) bucket_of[i] = foredraw_lod_bucket_of(&steps[i]);
  if (count > neighbourhood) { /* else all are sorted */
    memset(buckets, 0, FOREDRAW_LOD_BUCKETS * sizeof *buckets);
    for (i = 0; i < count; ++i) {
      buckets[bucket_of[i]].cost += steps[i].cost;
      ++buckets[bucket_of[i]].steps;
    }
    while (cut > 0 && result.cost + buckets[cut - 1].cost <= budget) result.cost += buckets[--cut].cost;
    for (last = cut; last > 0 && gathered < neighbourhood; --last) gathered += buckets[last - 1].steps;
  }
  for (i = 0; i < count; ++i) {
    if (bucket_of[i] >= cut) {
      chosen[steps[i].object] = steps[i].way;
      result.benefit += steps[i].benefit;
    } else if (bucket_of[i] >= last) {
      numbers[near_cut++] = i;
    }
  }
  numbers = foredraw_lod_sorted(steps, numbers, near_cut, bucket_of);
  for (i = 0; i < near_cut; ++i) {
    const foredraw_lod_step* step = &steps[numbers[i]];
    const foredraw_lod_step* before = numbers[i] > 0 && step[-1].object == step->object ? step - 1 : NULL;
    if (before != NULL && chosen[step->object] != before->way) continue;
    if (result.cost + step->cost <= budget) {
      chosen[step->object] = step->way;
      result.cost += step->cost;
      result.benefit += step->benefit;
    } else if (critical == NULL) { /* with a part of it, this is the best where steps can be divided */
      critical = step;
      result.bound = result.benefit + ((budget - result.cost) * step->benefit + step->cost - 1) / step->cost;
    }
  }
  if (critical == NULL) {
    result.bound = result.benefit;
  } else { /* a large step alone may be worth more than the small ones that took its place */
    const foredraw_lod_way* ways = scene->ways + scene->first[critical->object];
    const uint32_t n = scene->first[critical->object + 1] - scene->first[critical->object];
    const foredraw_lod_way* cheapest = &ways[foredraw_lod_cheapest(ways, n)];
    const uint64_t benefit = least.benefit + (ways[critical->way].benefit - cheapest->benefit);
    if (benefit > result.benefit) {
      const uint64_t bound = result.bound;
      foredraw_lod_begin(scene, chosen, &result);
      chosen[critical->object] = critical->way;
      result.cost += ways[critical->way].cost - cheapest->cost;
      result.benefit = benefit;
      result.bound = bound;
    }
  }
  return result;
}

/* What an earlier choice costs and is worth in this scene. It has no bound of its own. */
static inline foredraw_lod_result foredraw_lod_kept(const foredraw_lod_scene* scene, uint64_t budget,
                                                    const uint32_t* chosen) {
  foredraw_lod_result result = {0, 0, UINT64_MAX, 0};
  uint32_t i;
  for (i = 0; i < scene->objects; ++i) {
    if (scene->first[i] == scene->first[i + 1]) continue;
    result.cost += scene->ways[scene->first[i] + chosen[i]].cost;
    result.benefit += scene->ways[scene->first[i] + chosen[i]].benefit;
  }
  result.is_over = result.cost > budget;
  return result;
}

/* Whether an earlier choice may be drawn again, so that nothing switches though costs change with every move of the
 * camera: it is not over the budget, and what it loses is no more than what a new choice loses and so large a part of
 * it more (0.1: a tenth). Loss is what is missing to the best way of each object. Benefits themselves would not tell: a
 * hundredth of all that is shown can be many times what is missing. Where there is time for everything, only what is as
 * good may be kept. Ask with benefits in which there is no hysteresis. */
static inline int foredraw_lod_may_keep(const foredraw_lod_scene* scene, uint64_t budget, const uint32_t* earlier,
                                        const uint32_t* new_choice, double more) {
  const foredraw_lod_result kept = foredraw_lod_kept(scene, budget, earlier);
  const foredraw_lod_result next = foredraw_lod_kept(scene, budget, new_choice);
  uint64_t best = 0;
  uint32_t i, way;
  for (i = 0; i < scene->objects; ++i) {
    uint32_t most = 0;
    for (way = scene->first[i]; way < scene->first[i + 1]; ++way)
      if (scene->ways[way].benefit > most) most = scene->ways[way].benefit;
    best += most;
  }
  return !kept.is_over && (double)(best - kept.benefit) <= (1 + more) * (double)(best - next.benefit);
}

#endif
