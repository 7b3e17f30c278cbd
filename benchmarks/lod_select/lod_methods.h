/* The two optimisations of T. Funkhouser, C. Sequin: Adaptive Display Algorithm for Interactive Frame Rates, SIGGRAPH
 * 1993, section 6, to be compared with lod_select.h: by value, and from frame to frame. C99, no allocation. */
#ifndef FOREDRAW_BENCHMARKS_LOD_METHODS_H
#define FOREDRAW_BENCHMARKS_LOD_METHODS_H

#include <foredraw/runtime/lod_select.h>

/* Benefit for cost: whether a has more of it. A way that costs nothing comes first. */
static inline int foredraw_lod_is_worth_more(const foredraw_lod_way* a, const foredraw_lod_way* b) {
  if (a->cost == 0 || b->cost == 0) return a->cost < b->cost;
  return foredraw_lod_is_steeper(a->benefit, a->cost, b->benefit, b->cost);
}

/* One way takes another one's place. */
static inline void foredraw_lod_exchange(foredraw_lod_result* result, const foredraw_lod_way* before,
                                         const foredraw_lod_way* after) {
  result->cost += after->cost;
  result->cost -= before->cost;
  result->benefit += after->benefit;
  result->benefit -= before->benefit;
}

/* By value: all ways of all objects, the one of the highest value first; each takes the place of the object's worse one
 * while the budget lasts. Where each object has a way that costs nothing, twice its benefit and that of one more way
 * within the budget are no less than any choice's: half of the best, where one way is little. `memory`: so many
 * uint32_t as there are ways, twice. */
static inline foredraw_lod_result foredraw_lod_by_value(const foredraw_lod_scene* scene, uint64_t budget,
                                                        uint32_t* chosen, uint32_t* memory) {
  const uint32_t count = scene->first[scene->objects];
  uint32_t *sorted = memory, *other = memory + count, *swapped, width, i;
  foredraw_lod_result result;
  uint32_t object = 0;
  foredraw_lod_begin(scene, chosen, &result);
  result.bound = UINT64_MAX; /* it has none */
  result.is_over = result.cost > budget;
  for (i = 0; i < count; ++i) sorted[i] = i;
  for (width = 1; width < count; width = width < count / 2 + 1 ? 2 * width : count) {
    for (i = 0; i < count;) {
      const uint32_t middle = count - i > width ? i + width : count;
      const uint32_t end = count - middle > width ? middle + width : count;
      uint32_t a = i, b = middle;
      for (; i < end; ++i) {
        const int is_first =
            b == end || (a < middle && !foredraw_lod_is_worth_more(&scene->ways[sorted[b]], &scene->ways[sorted[a]]));
        other[i] = is_first ? sorted[a++] : sorted[b++];
      }
    }
    swapped = sorted;
    sorted = other;
    other = swapped;
  }
  /* other[way]: its object */
  for (i = 0; i < count; ++i) {
    while (i >= scene->first[object + 1]) ++object;
    other[i] = object;
  }
  for (i = 0; i < count; ++i) {
    const foredraw_lod_way* better = &scene->ways[sorted[i]];
    const foredraw_lod_way* now;
    object = other[sorted[i]];
    now = &scene->ways[scene->first[object] + chosen[object]];
    if (better->benefit <= now->benefit || result.cost - now->cost + better->cost > budget) continue;
    foredraw_lod_exchange(&result, now, better);
    chosen[object] = sorted[i] - scene->first[object];
  }
  return result;
}

/* Objects with something to take up or to give back, in a heap. */
typedef struct foredraw_lod_heap {
  const foredraw_lod_scene* scene;
  const uint32_t* chosen;
  uint32_t* objects; /* [place] */
  uint32_t* places;  /* [object], or none */
  uint32_t count;
  int is_up; /* the next better way of the highest value comes first; else the way of the lowest value that is not the
              * first one */
} foredraw_lod_heap;

/* What an object has to offer there; NULL: nothing. */
static inline const foredraw_lod_way* foredraw_lod_offer(const foredraw_lod_heap* heap, uint32_t object) {
  const uint32_t first = heap->scene->first[object], at = first + heap->chosen[object];
  if (heap->is_up) return at + 1 < heap->scene->first[object + 1] ? &heap->scene->ways[at + 1] : NULL;
  return at > first ? &heap->scene->ways[at] : NULL;
}

static inline int foredraw_lod_comes_first(const foredraw_lod_heap* heap, uint32_t a, uint32_t b) {
  const foredraw_lod_way *of_a = foredraw_lod_offer(heap, a), *of_b = foredraw_lod_offer(heap, b);
  if (of_a == NULL || of_b == NULL) return of_b == NULL && (of_a != NULL || a < b);
  if (heap->is_up ? foredraw_lod_is_worth_more(of_a, of_b) : foredraw_lod_is_worth_more(of_b, of_a)) return 1;
  if (heap->is_up ? foredraw_lod_is_worth_more(of_b, of_a) : foredraw_lod_is_worth_more(of_a, of_b)) return 0;
  return a < b;
}

static inline void foredraw_lod_put(foredraw_lod_heap* heap, uint32_t place, uint32_t object) {
  heap->objects[place] = object;
  heap->places[object] = place;
}

/* What the object offers has changed. */
static inline void foredraw_lod_settle(foredraw_lod_heap* heap, uint32_t object) {
  uint32_t place = heap->places[object];
  while (place > 0 && foredraw_lod_comes_first(heap, object, heap->objects[(place - 1) / 2])) {
    foredraw_lod_put(heap, place, heap->objects[(place - 1) / 2]);
    place = (place - 1) / 2;
  }
  for (;;) {
    uint32_t child = 2 * place + 1;
    if (child >= heap->count) break;
    if (child + 1 < heap->count && foredraw_lod_comes_first(heap, heap->objects[child + 1], heap->objects[child]))
      ++child;
    if (!foredraw_lod_comes_first(heap, heap->objects[child], object)) break;
    foredraw_lod_put(heap, place, heap->objects[child]);
    place = child;
  }
  foredraw_lod_put(heap, place, object);
}

/* From frame to frame: objects begin at `chosen`, which is the last frame's choice, or 0 for those that were not
 * visible. The best next way is taken, and the ways of the lowest value are given back until the budget is kept; it
 * ends when that gives back what was just taken. An object's ways go from the cheapest to the best; a choice that an
 * object no longer has is its last way. On ways whose value
 * does not fall from one to the next, it ends far from the best. `memory`: 4 uint32_t an object. `rounds`, if not NULL:
 * how many ways were taken. */
static inline foredraw_lod_result foredraw_lod_from_last(const foredraw_lod_scene* scene, uint64_t budget,
                                                         uint32_t* chosen, uint32_t* memory, uint32_t* rounds) {
  const uint32_t n = scene->objects;
  foredraw_lod_heap up = {scene, chosen, NULL, NULL, 0, 1}, down = {scene, chosen, NULL, NULL, 0, 0};
  foredraw_lod_result result = {0, 0, UINT64_MAX, 0};
  uint32_t i, taken = 0;
  up.objects = memory;
  up.places = memory + n;
  down.objects = memory + 2 * (size_t)n;
  down.places = memory + 3 * (size_t)n;
  for (i = 0; i < n; ++i) {
    const uint32_t own = scene->first[i + 1] - scene->first[i];
    if (chosen[i] >= own) chosen[i] = own > 0 ? own - 1 : 0;
    if (own > 0) {
      result.cost += scene->ways[scene->first[i] + chosen[i]].cost;
      result.benefit += scene->ways[scene->first[i] + chosen[i]].benefit;
    }
    foredraw_lod_put(&up, up.count++, i);
    foredraw_lod_settle(&up, i);
    foredraw_lod_put(&down, down.count++, i);
    foredraw_lod_settle(&down, i);
  }
  while (n > 0 && taken < scene->first[n]) { /* more would be a circle of equal values */
    const uint32_t raised = up.objects[0];
    const int has_more = foredraw_lod_offer(&up, raised) != NULL;
    int is_stable = 0;
    if (has_more) {
      const foredraw_lod_way* way = &scene->ways[scene->first[raised] + chosen[raised]++];
      foredraw_lod_exchange(&result, &way[0], &way[1]);
      foredraw_lod_settle(&up, raised);
      foredraw_lod_settle(&down, raised);
      ++taken;
    }
    while (result.cost > budget && foredraw_lod_offer(&down, down.objects[0]) != NULL) {
      const uint32_t lowered = down.objects[0];
      const foredraw_lod_way* way = &scene->ways[scene->first[lowered] + --chosen[lowered]];
      foredraw_lod_exchange(&result, &way[1], &way[0]);
      foredraw_lod_settle(&up, lowered);
      foredraw_lod_settle(&down, lowered);
      is_stable = is_stable || (has_more && lowered == raised);
    }
    if (!has_more || is_stable || result.cost > budget) break;
  }
  result.is_over = result.cost > budget;
  if (rounds != NULL) *rounds = taken;
  return result;
}

#endif
