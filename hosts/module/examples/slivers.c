/* A module: a remesher. cc -std=c99 -shared -fPIC -o slivers.so slivers.c */
#include <foredraw/c/module.h>

#include <stdlib.h>

/* Four times the square of its area; not a number where a position is none. */
static double area_of(const foredraw_draw* draw, uint64_t triangle) {
  const uint32_t* corner = draw->indices + 3 * triangle;
  const float *a = draw->positions + 3 * (uint64_t)corner[0], *b = draw->positions + 3 * (uint64_t)corner[1],
              *c = draw->positions + 3 * (uint64_t)corner[2];
  const double x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2], u = c[0] - a[0], v = c[1] - a[1], w = c[2] - a[2];
  const double p = y * w - z * v, q = z * u - x * w, r = x * v - y * u;
  return p * p + q * q + r * r;
}

/* Leaves out triangles of at most that area, and vertices that no other uses. */
static int slivers(void* user, const foredraw_draw* draw, const foredraw_value* options, foredraw_answer* answer,
                   const foredraw_host* host) {
  const double most = 4 * options[0].number * options[0].number;
  uint32_t* vertex_to = malloc((draw->vertex_count + (size_t)1) * sizeof *vertex_to);
  uint64_t corners = 0;
  uint32_t vertices = 0;
  (void)user;
  if (vertex_to == NULL) return FOREDRAW_FAILED;
  for (uint32_t v = 0; v < draw->vertex_count; ++v) vertex_to[v] = UINT32_MAX;
  for (uint64_t t = 0; t < draw->triangle_count; ++t) {
    if (area_of(draw, t) <= most) continue;
    for (int corner = 0; corner < 3; ++corner) {
      const uint32_t old = draw->indices[3 * t + corner];
      if (vertex_to[old] == UINT32_MAX) {
        answer->vertex_from[vertices] = old;
        vertex_to[old] = vertices++;
      }
      answer->values[corners++] = vertex_to[old];
    }
  }
  free(vertex_to);
  if (corners == 3 * draw->triangle_count) host->keep(host->self, "no triangle is so small");
  if (corners == 0) host->keep(host->self, "no triangle would be left");
  answer->count = corners;
  answer->vertex_count = vertices;
  return FOREDRAW_DONE;
}

static const foredraw_option options[] = {{.name = "area",
                                           .doc = "The largest that is left out",
                                           .unit = "square units",
                                           .type = FOREDRAW_NUMBER,
                                           .least = 0,
                                           .most = 1e30}};
static const foredraw_plugin plugin = {.size = sizeof(foredraw_plugin),
                                       .kind = FOREDRAW_REMESHER,
                                       .name = "acme-slivers",
                                       .summary = "Leaves out the smallest triangles",
                                       .reference = "own",
                                       .options = options,
                                       .option_count = 1,
                                       .runs_on_many_threads = 1,
                                       .run = slivers,
                                       .pays_if = "a triangle is at most that small, and another is not"};
static const foredraw_plugin* const plugins[] = {&plugin};
static const foredraw_module module = {sizeof(foredraw_module), 1, 1, 1, "acme", "1.0.0", plugins};

FOREDRAW_EXPORT const foredraw_module* foredraw_module_v1(void) { return &module; }
