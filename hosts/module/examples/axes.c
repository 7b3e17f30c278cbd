/* A module: an orderer that tries several orders, and takes the one that shades least. cc -std=c99 -shared -fPIC -o
 * axes.so axes.c */
#include <foredraw/c/module.h>

#include <stdlib.h>
#include <string.h>

typedef struct placed_triangle {
  double place;
  uint32_t number;
} placed_triangle;

static int lower(const void* a, const void* b) {
  const placed_triangle *one = a, *other = b;
  if (one->place != other->place) return one->place < other->place ? -1 : 1;
  return one->number < other->number ? -1 : 1;
}

/* Along an axis, one way or the other: which, says `way`, 0 to 5. */
static void sort_along(int way, const foredraw_draw* draw, placed_triangle* triangles, uint32_t* order) {
  for (uint64_t t = 0; t < draw->triangle_count; ++t) {
    double sum = 0;
    for (int c = 0; c < 3; ++c) sum += draw->positions[3 * (uint64_t)draw->indices[3 * t + c] + way / 2];
    triangles[t].place = sum == sum ? (way % 2 ? -sum : sum) : 0; /* not where a position is no number */
    triangles[t].number = (uint32_t)t;
  }
  qsort(triangles, draw->triangle_count, sizeof *triangles, lower);
  for (uint64_t t = 0; t < draw->triangle_count; ++t) order[t] = triangles[t].number;
}

static int axes(void* user, const foredraw_draw* draw, const foredraw_value* options, foredraw_answer* answer,
                const foredraw_host* host) {
  placed_triangle* triangles = malloc((draw->triangle_count + 1) * sizeof *triangles);
  uint32_t* order = malloc((draw->triangle_count + 1) * sizeof *order);
  uint64_t least = 0, shaded = 0;
  int best = -1, status = triangles && order ? host->count_overdraw(host->self, NULL, &least, NULL) : FOREDRAW_FAILED;
  (void)user, (void)options;
  for (int way = 0; way < 6 && status == FOREDRAW_DONE; ++way) {
    sort_along(way, draw, triangles, order);
    status = host->count_overdraw(host->self, order, &shaded, NULL);
    if (status != FOREDRAW_DONE || shaded >= least) continue;
    least = shaded, best = way;
    memcpy(answer->values, order, draw->triangle_count * sizeof *order);
  }
  if (status == FOREDRAW_DONE && best < 0) host->keep(host->self, "no axis shades less");
  free(triangles);
  free(order);
  return status;
}

static const foredraw_plugin plugin = {.size = sizeof(foredraw_plugin),
                                       .kind = FOREDRAW_TRIANGLE_ORDERER,
                                       .name = "acme-axes",
                                       .summary = "Draws along the axis that shades least",
                                       .reference = "own",
                                       .provides = "overdraw-ordered",
                                       .breaks = "cache-ordered fetch-ordered clustered",
                                       .runs_on_many_threads = 1,
                                       .run = axes,
                                       .pays_if = "an axis shades less than the order that there is",
                                       .flags = FOREDRAW_USES_OVERDRAW};
static const foredraw_plugin* const plugins[] = {&plugin};
static const foredraw_module module = {sizeof(foredraw_module), 1, 1, 1, "acme", "1.0.0", plugins};

FOREDRAW_EXPORT const foredraw_module* foredraw_module_v1(void) { return &module; }
